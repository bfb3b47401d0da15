"""What accuracy is asked for: how many figures students carry, how far answers may be off, and
where honest rounding needs more room.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from math import ceil

from msgspec.structs import replace

from kinegrade.numbers.tolerance import ONE_PER_CENT, USUAL_CARRY, Tolerance
from kinegrade.problem.solution import Solution
from kinegrade.problem.tolerance import find_effective_tolerance
from kinegrade.round_numbers import round_up
from kinegrade.students.rounding.rounding import UNBOUNDED, Rounding

# A widened tolerance is one of these per cents
_PLAIN = tuple(Fraction(number) for number in ("1", "1.5", "2", "3", "4", "5", "6", "8"))
_SAME = 1e-9  # relative: closer than this is the same figure in doubles
WIDEST = Fraction(1, 10)  # of an answer
USUALLY = 0.9  # of the draws: a tolerance that holds in fewer is not enough


@dataclass(frozen=True)
class Accuracy:
    """The tolerances by ask, the significant figures that students `carry`, and the `honest` asks:
    those whose tolerance is widened where rounding needs it. For an ask without a stated tolerance
    1 % holds, widened.
    """

    tolerances: Mapping[str, Tolerance] = field(default_factory=dict)
    carry: int = USUAL_CARRY
    honest: frozenset[str] = frozenset()

    def find_stated(self, ask: str) -> Tolerance:
        """The tolerance stated for an ask."""
        return self.tolerances.get(ask, ONE_PER_CENT)

    def may_widen(self, ask: str) -> bool:
        """Whether an ask's tolerance is widened where rounding needs it."""
        return ask in self.honest or ask not in self.tolerances

    def state(
        self, solution: Solution, roundings: Mapping[str, Rounding[float]]
    ) -> dict[str, Tolerance]:
        """The tolerance of each answer of an instance as it is stated, next to zero with the share
        that is allowed there.

        `roundings` are those of `find_roundings`.
        """
        return {
            name: find_effective_tolerance(
                self.find_stated(name), answer.value, roundings.get(name, UNBOUNDED).largest
            )
            for name, answer in solution.answers.items()
        }

    def allow(
        self, solution: Solution, roundings: Mapping[str, Rounding[float]]
    ) -> dict[str, Tolerance | None]:
        """The tolerance of each answer of an instance; None where honest rounding may leave it.

        `roundings` are those of `find_roundings`.
        """
        allowed: dict[str, Tolerance | None] = {}
        for name, tolerance in self.state(solution, roundings).items():
            value = solution.answers[name].value
            bound = roundings.get(name, UNBOUNDED).bound
            if _holds(tolerance, value, bound):
                allowed[name] = tolerance
            elif self.may_widen(name):
                allowed[name] = _widen(tolerance, value, bound)
            else:
                allowed[name] = None
        return allowed


def _holds(tolerance: Tolerance, value: float, bound: float) -> bool:
    """Whether every answer that is off by no more than the bound is right."""
    low, high = tolerance.interval(Fraction(value))
    return float(low) <= value - bound and value + bound <= float(high)


def _widen(tolerance: Tolerance, value: float, bound: float) -> Tolerance | None:
    """The tolerance with as large a share as the bound needs, in plain figures; None where that is
    more than should be allowed.
    """
    if bound > WIDEST * abs(value):
        return None
    return replace(tolerance, relative=find_plain_figure(bound / abs(value)))


def find_usual_share(shares: Sequence[Fraction]) -> Fraction:
    """The least of some relative tolerances that is not below nine of ten."""
    return sorted(shares)[ceil(USUALLY * len(shares)) - 1]


def find_plain_figure(number: float) -> Fraction:
    """The least plain figure that is not below a positive number.

    >>> find_plain_figure(0.0124), find_plain_figure(0.81)
    (Fraction(3, 200), Fraction(1, 1))
    """
    return round_up(Fraction(number * (1 - _SAME)), _PLAIN)
