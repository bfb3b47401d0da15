"""Positions without motion, poles at infinity, and the circles on which poles move."""

from __future__ import annotations

import json

import pytest
from flint import fmpq

from kinegrade.draws.examining import Refused, solve_sensible
from kinegrade.errors import MechanismError
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.template import Template

TEXTS = '{ en = "a length", zh = "长度" }'
HEAD = f"""
family = "test"
source = "by hand"
title = {TEXTS}
[statement]
en = "{{{{ r }}}} {{{{ theta }}}}"
zh = "{{{{ r }}}} {{{{ theta }}}}"
[parameters]
r = {{ unit = "m", draw = [1, 2], means = {TEXTS} }}
theta = {{ unit = "deg", draw = [60, 90], means = {TEXTS} }}
"""
TUBE = (
    """
joints = ["pin A: ground AB", "pin B: AB BC", "O of ground slides on line(O, B) of BC"]
inputs = [{ motion = "AB turns", velocity = "1" }]
"""
    + HEAD
    + """
[points]
A = "(0, 0)"
O = "(r, 0)"
B = "polar(A, r, theta)"
[bodies]
AB = "A B"
BC = "B"
[asks]
"""
)
SLIDER = (
    """
joints = ["pin O: ground OA", "pin A: OA AB", "B of AB slides on line(O, 0)"]
inputs = [{ motion = "OA turns", velocity = "2" }]
"""
    + HEAD
    + """
[points]
O = "(0, 0)"
A = "polar(O, r, theta)"
B = "meet(circle(A, 2*r), line(O, 0), right)"
[bodies]
OA = "O A"
AB = "A B"
[asks]
"""
)


def with_asks(text: str, *, kept: bool = False, **asks: str) -> Template:
    """A template that asks for the given quantities, each in the unit after the bar."""
    lines = [
        f'{name} = {{ quantity = "{ask.split("|")[0]}", unit = "{ask.split("|")[1]}", sign = '
        '"signed", '
        f"points = 1, vanishes = true, means = {TEXTS} }}"
        for name, ask in asks.items()
    ]
    return read_template("test", text + "\n".join(lines), kept=kept)


def test_the_pole_of_a_rod_in_a_guide_tube_moves_on_a_circle_about_the_pivot_of_the_crank() -> None:
    """AO = AB = r: the pole is the point of the crank's circle opposite B (textbook problem
    3-10C).
    """
    template = with_asks(
        TUBE,
        rho="radius(circle_of_poles(BC, theta))|m",
        x="x(centre(circle_of_poles(BC, theta)))|m",
        y="y(centre(circle_of_poles(BC, theta)))|m",
        x_S="x(pole(BC))|m",
    )
    solution = solve_template(template, {"r": "2", "theta": "60"})
    assert [solution[name].number for name in ("rho", "x", "y", "x_S")] == [2, 0, 0, -1]
    odd = solve_template(template, {"r": "2", "theta": "37.3"})
    assert not odd["rho"].is_exact
    assert odd["rho"].decimal(30) == "2"


def test_a_centrode_that_is_no_circle_is_refused() -> None:
    template = with_asks(SLIDER, rho="radius(circle_of_poles(AB, theta))|m")
    with pytest.raises(MechanismError, match="rho: the centrode of AB is no circle"):
        solve_template(template, {"r": "1", "theta": "60"})


@pytest.mark.parametrize(
    ("quantity", "message"),
    [
        ("radius(circle_of_poles(AB, r))|m", "expected the name of an angular parameter second"),
        ("radius(circle_of_poles(A, theta))|m", "expected the name of a body first"),
    ],
)
def test_a_centrode_needs_a_body_and_an_angle(quantity: str, message: str) -> None:
    with pytest.raises(MechanismError, match=message):
        solve_template(with_asks(SLIDER, kept=True, rho=quantity), {})


def test_a_pole_at_infinity_is_an_answer_and_leaves_the_others_alone() -> None:
    """Crank upright: the rod is in instantaneous translation with v_A = r omega."""
    template = with_asks(
        SLIDER, x_S="x(pole(AB))|m", AS="distance(A, pole(AB))|m", v="magnitude(velocity(B))|m/s"
    )
    solution = solve_template(template, {"r": "1", "theta": "90"})
    assert solution["v"].number == fmpq(2)
    assert solution["x_S"].exact == solution["x_S"].decimal(9) == "infinity"
    assert json.loads(json.dumps(solution["AS"].record()))["value"] is None
    assert (solution["AS"].value, solution["AS"].is_zero, solution["AS"].latex) == (
        float("inf"),
        False,
        r"\infty",
    )
    with pytest.raises(Refused, match="x_S is at infinity"):
        solve_sensible(template, {"r": "1", "theta": "90"}, ["x_S"], None)


def test_a_pose_has_positions_and_no_velocities() -> None:
    still = TUBE.replace('[{ motion = "AB turns", velocity = "1" }]', "[]")
    solution = solve_template(
        with_asks(still, phi="angle((1, 0), B - O)|rad", A11="along((1, 0), B - O)|1"), {}
    )
    assert (solution["phi"].exact, solution["A11"].exact) == ("2*pi/3", "-1/2")
    with pytest.raises(
        MechanismError, match="v: nothing drives this mechanism: it has positions but no velocities"
    ):
        solve_template(with_asks(still, v="magnitude(velocity(B))|m/s"), {})


def test_a_pose_must_fit_together_too() -> None:
    still = TUBE.replace('[{ motion = "AB turns", velocity = "1" }]', "[]").replace(
        "line(O, B)", "line(A, B)"
    )
    with pytest.raises(MechanismError, match="O does not lie on that line"):
        solve_template(with_asks(still, x="x(B)|m"), {})
