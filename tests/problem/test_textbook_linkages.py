"""Linkages and cams of textbooks, worked out by hand: positions at the time t from the loop of the
mechanism, differentiated.
"""

from __future__ import annotations

from collections.abc import Callable

import pytest
from mpmath import asin, diff, exp, mpf, pi, radians, sin

from tests.problem.textbook import MINUTE, Answers, Case, Given, hold

METRE = mpf(1000)  # in millimetres


def turn_at(given: Given, speed: mpf) -> Callable[[mpf], mpf]:
    """The angle phi of a crank in radians at the time t."""
    return lambda t: radians(given["phi"]) + 2 * pi * speed / MINUTE * t


def turn_cylinder(given: Given) -> Answers:
    """The rod from A = (r, 0) ends on the ray from O: the law of sines, then the sides along it."""
    short, rod, cylinder = given["r"], given["l"], turn_at(given, given["n"])

    def lean(t: mpf) -> mpf:
        return cylinder(t) + asin(short * sin(cylinder(t)) / rod)

    def reach(t: mpf) -> mpf:
        """The distance OB."""
        return abs(short + rod * exp(1j * lean(t)))

    return {
        "omega_AB": diff(lean, 0),
        "v_r": diff(reach, 0) / METRE,
        "a_C": 2 * diff(cylinder, 0) * abs(diff(reach, 0)) / METRE,
        "alpha_AB": diff(lean, 0, 2),
    }


CASES: tuple[Case, ...] = (
    ("rotary-engine", turn_cylinder, {"r": 60, "l": 200, "phi": 40, "n": 900}),
    ("rotary-engine", turn_cylinder, {"r": 75, "l": 160, "phi": 130, "n": 700}),
)


@pytest.mark.parametrize(("name", "work_out", "given"), CASES)
def test_answers_are_those_of_positions(
    name: str, work_out: Callable[[Given], Answers], given: dict[str, int]
) -> None:
    hold(name, work_out, given)
