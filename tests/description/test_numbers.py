"""Numbers of a template that are lengths have a unit in its figure in words: that of the givens."""

from __future__ import annotations

import re

import pytest

from kinegrade.description.description import describe
from kinegrade.language import Language
from kinegrade.language.prose.plain import write_prose
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.reading import read_template

LEVER = """
family = "lever"
source = "own"
language = "en"
title = "Lever with a ram"
statement = "The lever $CB$ of length {{ l }} turns about $C$ at {{ omega }}."
joints = [
  "pin C: ground CB",
  "B of CB slides on line(B, pi/2) of ram",
  "E of ram slides on line(E, 0)",
  "ram translates",
]
inputs = [{ motion = "CB turns", velocity = "omega" }]
[parameters]
l = { unit = "UNIT", draw = "360 .. 480 step 20", means = "length" }
omega = { unit = "rad/s", draw = "1 .. 3 step 1", means = "rate" }
[points]
C = "(0, 0)"
B = "polar(C, l, pi/3)"
E = "PLACE"
[bodies]
CB = "C B"
ram = "E"
[asks]
v_E = { quantity = "x(velocity(E))", unit = "m/s", means = "velocity of the ram" }
"""
PLACES = {
    "(x(B), y(B) + 0.12)": "E has the coordinates x = x_B and y = y_B + 120 mm.",
    "(x(B) + 0.25, 0.2)": "E has the coordinates x = x_B + 250 mm and y = 200 mm.",
    "(x(B) - 1/8, y(B) - 0.12*sin(pi/3))": (
        "E has the coordinates x = x_B - 125 mm and y = y_B - 120 mm sin 60°."
    ),
    "B + (0.05, l/2)": "l/2",
    "B + 0.12*(cos(pi/3), sin(pi/3))": "the vector 120 mm(cos 60°, sin 60°).",
    "B - (cos(pi/3), sin(pi/3))*0.12": "the vector -(cos 60°, sin 60°) 120 mm.",
    "B + 0.12*sin(pi/3)*(1, 0)": "the vector 120 mm sin 60° · (1, 0).",
    "B + 0.12*sin(pi/3)*(cos(pi/6), -sin(pi/6))": "120 mm sin 60° · (cos 30°, - sin 30°).",
    "B + sqrt(2)*0.06*(0, 1)": "60 mm(0, 1).",
    "B - sin(pi/3)*0.12*(-1, 0)": "sin 60° · 120 mm",
    "B + sin(pi/3)*(0.06, 0)": "the vector sin 60° · (60 mm, 0).",
    "polar(B, 2*l, pi/6)": "2l",
    "polar(B, 0.3, pi/6)": "E lies at the distance 300 mm from B in the direction 30°.",
    "polar(B, l + 0.1, pi/6)": "E lies at the distance l + 100 mm from B in the direction 30°.",
    "toward(B, C, 0.02)": "E lies on the ray from B through C, at the distance 20 mm from B.",
    "meet(circle(B, 0.5), line(C, 0), right)": "the circle about B of radius 500 mm.",
}


def described(place: str, unit: str = "mm") -> str:
    """The sentences on positions of a lever whose ram is there."""
    template = read_template("lever", LEVER.replace("PLACE", place).replace("UNIT", unit))
    found = describe(solve_template(template, {}), Language("en"))
    assert found is not None
    return "\n".join(write_prose(part.text, "description") for part in found.long)


@pytest.mark.parametrize("place", PLACES)
def test_a_number_that_is_a_length_has_the_unit_of_the_givens(place: str) -> None:
    said = described(place)
    assert PLACES[place] in said
    assert not re.search(r"0\.\d", said)


def test_lengths_in_metres_stay_in_metres() -> None:
    assert "y = y_B + 0.12 m." in described("(x(B), y(B) + 0.12)", "m")
