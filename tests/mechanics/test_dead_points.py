"""A dead point is told from a joint that is missing, and says what is in line."""

from __future__ import annotations

from dataclasses import replace

import pytest
from flint import arb

from kinegrade.mechanics.joints import GROUND, Pin, Slide
from kinegrade.mechanics.motion import solve_motion
from kinegrade.numbers.balls import Balls, Undecided
from tests.laws.cases import with_numbers
from tests.mechanics.refusals import CRANK, POINTS, P, problem, written
from tests.mechanics.writing import X
from tests.small_class import kinegrade


def test_a_dead_point_names_the_joints_that_cannot_act_together() -> None:
    stretched = written(
        [*CRANK, Slide("B", "AB", P.line(0, 0, X), GROUND)], [P.moves("B", "AB", X, 1)]
    )
    assert problem(stretched).endswith(
        "the given motion of B of AB cannot act together: choose another configuration or driver"
    )


DYAD_POINTS = {"O": (0, 0), "C": (2, 0), "D": (5, 0), "O6": (9, 0)}
DYAD_BODIES = {"OC": "O C", "CD": "C D", "DO6": "D O6"}
DYAD = [
    Pin("O", ("OC", GROUND)),
    Pin("C", ("OC", "CD")),
    Pin("D", ("CD", "DO6")),
    Pin("O6", ("DO6", GROUND)),
]


def test_a_dead_point_says_what_is_in_line_and_asks_for_no_joint() -> None:
    """The four-bar is complete; only where its coupler and its rocker are in line they may turn
    either way.
    """
    assert problem(written(DYAD, [P.turns("OC", 0)], points=DYAD_POINTS, bodies=DYAD_BODIES)) == (
        "dead point: C, D and O6 are in line at these values: choose other values or another driver"
    )
    standing = {**DYAD_POINTS, "O": (2, -2)}
    assert problem(
        written(DYAD, [P.turns("OC", 1)], points=standing, bodies=DYAD_BODIES)
    ).startswith("dead point: C, D and O6 are in line at these values, ")


def test_a_rod_at_right_angles_to_its_guide_is_at_a_dead_point() -> None:
    upright = {**POINTS, "B": (3, 5)}
    joints = [*CRANK, Slide("B", "AB", P.line(0, 5, X), GROUND)]
    assert problem(written(joints, [P.turns("OA", 0)], points=upright)) == (
        "dead point: AB is at right angles to the line on which B slides at these values: "
        "choose other values or another driver"
    )


def test_links_in_line_that_lack_a_joint_are_loose() -> None:
    assert problem(
        written(DYAD[:3], [P.turns("OC", 1)], points=DYAD_POINTS, bodies=DYAD_BODIES)
    ).endswith("(2 degrees of freedom left): add a joint or a driver")
    assert problem(written(DYAD, [], points=DYAD_POINTS, bodies=DYAD_BODIES)).endswith(
        "left): add a joint or a driver"
    )


def test_solve_names_the_dead_point_of_a_trammel() -> None:
    shown = kinegrade("solve", "elliptic-trammel-end-driven", "--set", "phi=0")
    assert shown.exit_code == 2
    assert "dead point: AB is at right angles to the line on which B slides" in shown.stderr


def test_a_ball_that_may_be_a_dead_point_is_undecided_rather_than_wrong() -> None:
    balls = Balls(256)
    with balls.context():
        mechanism = with_numbers(
            written(
                [*CRANK, Slide("B", "AB", P.line(0, 0, X), GROUND)], [P.moves("B", "AB", X, 1)]
            ),
            balls.number,
        )
        points = {**mechanism.points, "A": mechanism.points["A"]._replace(y=arb(0, arb("1e-30")))}
        with pytest.raises(Undecided):
            solve_motion(replace(mechanism, points=points), balls)
