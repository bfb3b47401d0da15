"""Gear trains, racks and ropes of textbooks, worked out by hand: arcs that roll off each
other and lengths of rope, at the time t, differentiated.
"""

from __future__ import annotations

from collections.abc import Callable

import pytest
from mpmath import diff, exp, mpf, pi

from tests.problem.textbook import MINUTE, Answers, Case, Given, hold

METRE = mpf(1000)  # in millimetres


def count_turns(angle: Callable[[mpf], mpf]) -> mpf:
    """The revolutions a minute of what has turned by an angle at the time t."""
    return diff(angle, 0) * MINUTE / (2 * pi)


def turn_reverted_train(given: Given) -> Answers:
    """Arcs in teeth: E on the fixed gear B, then C on D, seen from the arm."""
    teeth = given["z_C"] + given["z_D"] - given["z_B"]

    def arm(t: mpf) -> mpf:
        return -2 * pi * given["n"] / MINUTE * t

    def pair(t: mpf) -> mpf:
        return arm(t) + given["z_B"] / teeth * arm(t)

    def driven(t: mpf) -> mpf:
        return arm(t) - given["z_D"] / given["z_C"] * (pair(t) - arm(t))

    def centre(t: mpf) -> mpf:
        return given["l"] * exp(1j * arm(t))

    return {
        "z_E": teeth,
        "n_P": count_turns(pair),
        "n_C": count_turns(driven),
        "v_P": abs(diff(centre, 0)) / METRE,
    }


CASES: tuple[Case, ...] = (
    (
        "reverted-epicyclic-train",
        turn_reverted_train,
        {"z_B": 75, "z_C": 30, "z_D": 90, "l": 180, "n": 100},
    ),
    (
        "reverted-epicyclic-train",
        turn_reverted_train,
        {"z_B": 60, "z_C": 40, "z_D": 70, "l": 275, "n": 30},
    ),
)


@pytest.mark.parametrize(("name", "work_out", "given"), CASES)
def test_answers_are_those_of_positions(
    name: str, work_out: Callable[[Given], Answers], given: dict[str, int]
) -> None:
    hold(name, work_out, given)
