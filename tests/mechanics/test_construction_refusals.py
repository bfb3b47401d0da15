"""Points that no construction can place are refused with the reason."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from kinegrade.errors import ExpressionError, MechanismError
from kinegrade.mechanics.geometry import Constructions, Round
from kinegrade.mechanics.joints import Line
from tests.mechanics.refusals import P
from tests.mechanics.writing import X, Y


def ground_line(y: Any) -> Line:
    return P.line(0, y, X)


BUILD = Constructions(P.field, {"A": (place := P.vector(0, 1))})


@pytest.mark.parametrize(
    ("construct", "message"),
    [
        (
            lambda: BUILD.meet(Round(place, P.number("3/10")), ground_line(0), "right"),
            "the circle about A of radius 0.3 does not reach the line y = 0",
        ),
        (
            lambda: BUILD.meet(P.line(2, 0, Y), Round(place, P.number(1)), "upper"),
            "the circle about A of radius 1 does not reach the line x = 2",
        ),
        (
            lambda: BUILD.meet(Round(place, P.number(1)), P.line(9, 0, (1, 1)), "upper"),
            "the circle about A of radius 1 does not reach the slanting line through (9, 0)",
        ),
        (
            lambda: BUILD.meet(
                Round(place, P.number(1)), Round(P.vector(5, 1), P.number(2)), "upper"
            ),
            "the circle about A of radius 1 does not reach the circle about (5, 1) of radius 2",
        ),
        (
            lambda: BUILD.meet(
                Round(place, P.number(9)), Round(P.vector(5, 1), P.number(2)), "upper"
            ),
            "the circle about A of radius 9 does not reach the circle about (5, 1) of radius 2",
        ),
        (
            lambda: BUILD.meet(
                Round(place, P.number(1)), Round(P.vector(0, 1), P.number(1)), "upper"
            ),
            "have one centre and do not meet",
        ),
        (
            lambda: BUILD.meet(Round(place, P.number(2)), P.line(1, 0, Y), "right"),
            "right does not distinguish the two common points - name another side, one of right, "
            "left, upper, lower",
        ),
        (
            lambda: BUILD.meet(Round(place, P.number(2)), P.line(1, 0, Y), "clockwise"),
            "clockwise does not distinguish the two",
        ),
        (
            lambda: BUILD.meet(ground_line(0), ground_line(3)),
            "the line y = 0 and the line y = 3 are parallel and do not meet",
        ),
    ],
)
def test_configurations_that_cannot_be_constructed(
    construct: Callable[[], Any], message: str
) -> None:
    with pytest.raises(MechanismError) as refusal:
        construct()
    assert message in str(refusal.value)


@pytest.mark.parametrize("branch", [None, "rightright", "up", place])
def test_two_common_points_need_the_name_of_a_side(branch: Any) -> None:
    with pytest.raises(
        ExpressionError,
        match="say which, one of right, left, upper, lower, counterclockwise, clockwise",
    ):
        BUILD.meet(Round(place, P.number(2)), ground_line(0), branch)
