"""What is right for an ask of an instance, and how far rounding may take an answer from it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from math import degrees, tau
from typing import Any

import numpy as np

from kinegrade.mechanics.motion import Motion
from kinegrade.numbers.angle import Angle
from kinegrade.numbers.doubles import convert_number
from kinegrade.numbers.rounding import NOTHING, Rounded
from kinegrade.numbers.tolerance import ONE_PER_CENT, Tolerance
from kinegrade.problem.quantity import Quantity
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Ask
from kinegrade.problem.tolerance import find_effective_tolerance

_DISPLAY = 10  # significant figures that a calculator shows and a student may type
# Of a unit of the last figure written: what rounding changes at most, and the rounding of doubles
_SAFELY = 0.5000001


@dataclass(frozen=True)
class Target:
    """What is right for one ask: the smallest and the largest right answer, the exact one, a full
    turn where turns do not matter (else 0), and the significant figures to be carried.
    """

    low: float
    high: float
    exact: float
    turn: float
    figures: int

    def met(self, worked: float | None, figures: int) -> bool:
        """Whether an answer is right as it came out, and written to so many significant figures or
        to more.
        """
        if worked is None:
            return False
        near = find_nearest_turn(worked, self.exact, self.turn)
        room = safe_room(abs(worked), figures)
        if self.low + room <= near <= self.high - room:
            return True
        typed = (
            worked,
            *(Rounded(count).written(worked) for count in range(figures, _DISPLAY + 1)),
        )
        return all(
            self.low <= find_nearest_turn(number, self.exact, self.turn) <= self.high
            for number in typed
        )


def safe_room(size: Any, figures: int) -> Any:
    """More than a number of that size, or numbers, can change when written to so many significant
    figures.
    """
    return _SAFELY * size * 10.0 ** (1 - figures) + NOTHING


def find_targets(solution: Solution, tolerances: Mapping[str, Tolerance]) -> dict[str, Target]:
    """What is right for every ask of an instance, where nothing is stated within 1 %."""
    return {
        name: find_target(
            solution.template.asks[name],
            answer,
            tolerances.get(name, ONE_PER_CENT),
            solution.doubles,
        )
        for name, answer in solution.answers.items()
    }


def list_carried_figures(aims: Mapping[str, Target]) -> list[tuple[int, bool]]:
    """The significant figures that are carried: three, or as many as a tolerance takes to be met at
    all, and then all ways of working are followed; and one more.
    """
    least = {aim.figures for aim in aims.values()}
    return [
        (figures, figures in least) for figures in sorted(least | {count + 1 for count in least})
    ]


def find_target(ask: Ask, answer: Quantity, tolerance: Tolerance, motion: Motion) -> Target:
    """What is right for one ask of an instance; `motion` gives the scale next to zero."""
    exact = convert_number(answer.number)
    if isinstance(answer.number, Angle) and ask.unit.degrees:
        exact = degrees(exact)
    allowed = find_effective_tolerance(tolerance, exact, ask.unit, motion)
    low, high = allowed.interval(Fraction(exact))
    return Target(
        float(low), float(high), exact, find_full_turn(ask), allowed.carried(Fraction(exact))
    )


def find_full_turn(ask: Ask) -> float:
    """A full turn in the unit of an angle that is right with any number of turns; 0 for everything
    else.
    """
    if not ask.cyclic:
        return 0.0
    return 360.0 if ask.unit.degrees else tau


def find_nearest_turn(number: Any, exact: Any, turn: float) -> Any:
    """The angle, or angles, with the number of full turns that brings it next to the exact one."""
    if not turn:
        return number
    nearest = np.rint if isinstance(number, np.ndarray) else round
    return number - nearest((number - exact) / turn) * turn
