"""`check` says where a circle touches a flank beyond its end, and a pin has left its Geneva wheel."""

from __future__ import annotations

import pytest

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.proof.checking import check
from kinegrade.proof.contacts import note_lost_contacts
from tests.said import all_said

FLANK = """family = "cam-follower"
source = "worked out by hand"
language = "en"
title = "A roller on a flank"
statement = "A roller of radius {{ q }} at {{ s }}, the flank of length {{ w }} turned by {{ phi }}, {{ omega }}."
joints = [
  "pin T: ground cam",
  "C of follower slides on line(C, pi/2)",
  "follower translates",
  "pin C: follower roller",
  "circle(C, q) of roller rolls on line(T, phi) of cam",
]
inputs = [{ motion = "cam turns", velocity = "omega" }]
[parameters]
q = { unit = "mm", draw = [20], means = "radius of the roller" }
s = { unit = "mm", draw = [-20, 20, 60], means = "distance" }
w = { unit = "mm", draw = [50], means = "length of the flank" }
phi = { unit = "deg", draw = [0], means = "angle" }
omega = { unit = "rad/s", draw = [2], means = "rate" }
[points]
T = "(0, 0)"
M = "polar(T, w, phi)"
C = "(s, q)"
[bodies]
cam = "T M"
follower = "C"
roller = "C"
[asks]
v_C = { quantity = "y(velocity(C))", unit = "m/s", sign = "+y", points = 1, means = "velocity" }
"""


def note(text: str, *values: dict[str, str]) -> list[str]:
    template = read_template("flank", text)
    solutions = [solve_template(template, each, ()) for each in values]
    return all_said(note_lost_contacts(template, solutions))


def test_a_roller_that_hovers_beyond_the_end_of_its_flank_is_noted() -> None:
    places = [{"s": each} for each in ("-20", "20", "60")]
    assert note(FLANK, *places) == [
        "roller touches cam beyond the ends of MT, where nothing of it is drawn, in 2 of 3 "
        "instances: a longer MT, other domains, or the line on the other side bring the contact "
        "onto it"
    ]
    assert note(FLANK.replace("line(T, phi)", "line(M, T)"), *places[:1])[0].count("1 of 1")
    assert note(FLANK, {"s": "20"}) == []


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ('cam = "T M"', 'cam = "T"'),  # a face without an end
        ("[asks]", '[figure]\nshapes = { cam = "rope" }\n[asks]'),  # drawn up to the wheel
    ],
)
def test_a_line_whose_end_is_not_drawn_has_no_end(before: str, after: str) -> None:
    assert note(FLANK.replace(before, after), {"s": "60"}) == []


def test_a_pin_outside_its_geneva_wheel_is_noted() -> None:
    geneva = load_template("geneva-drive")
    solutions = [solve_template(geneva, {"phi": each}, ()) for each in ("30", "-60", "60")]
    assert all_said(note_lost_contacts(geneva, solutions)) == [
        "P is outside the slot of the Geneva wheel wheel in 2 of 3 instances, as the crank is past "
        "the right angle to the slot: narrow its domain to where the pin is in the wheel"
    ]


@pytest.mark.parametrize(
    ("place", "draws", "noted"),
    [
        ("(s, 3*q)", ("20",), False),  # an arm
        ("(s, 3/2*q)", ("20",), False),
        ("(s, 2*q + s)", ("-20", "20"), True),
    ],
)
def test_a_point_that_is_now_on_its_wheel_now_beyond_the_rim_is_noted(
    place: str, draws: tuple[str, ...], noted: bool
) -> None:
    text = FLANK.replace("[bodies]", f'Q = "{place}"\n[bodies]').replace('er = "C"', 'er = "C Q"')
    text = text.replace('follower = "C Q"', 'follower = "C"')
    said = [each for each in note(text, *({"s": each} for each in draws)) if "rim" in each]
    assert (
        said
        == [
            "Q lies outside the rim of roller in 1 of 2 instances, where a bar leads to it, and on "
            "the wheel in the others: a condition on distance(C, Q) or other domains make the "
            "figures alike"
        ]
        * noted
    )


def test_check_remarks_it() -> None:
    remarks = all_said(
        check(read_template("flank", FLANK.replace("-20, 20, ", "")), sample=1).remarks
    )
    assert any("roller touches cam beyond the ends of MT" in each for each in remarks), remarks


@pytest.mark.parametrize("name", find_template_names())
def test_no_template_that_is_shipped_has_such_a_contact(name: str) -> None:
    template = load_template(name)
    assert all_said(note_lost_contacts(template, [solve_template(template, {}, ())])) == []
