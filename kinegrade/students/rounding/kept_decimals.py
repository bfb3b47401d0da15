"""What Canvas keeps of a typed number, four decimals, and the unit in which they distinguish right
from wrong.

A draw is refused by this rule where the bank says that the exam goes to Canvas
(`problem.draw_filter`), and the quiz is written by it (`lms.quiz.canvas_units`). Numbers are
exact, in the unit of the ask.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

_KEPT = Fraction(1, 10**4)  # the last decimal that Canvas keeps
_SMALLEST = 10 * _KEPT  # a right answer, not zero, of which two decimals are left at least
_FINER = {"km": ("m", 1000), "m": ("mm", 1000), "cm": ("mm", 10)}  # exact powers of ten
# A length to the first power leads: m, m/s, cm/s^2
_LENGTH_FIRST = re.compile(r"(km|m|cm)(?![\^a-z])")


@dataclass(frozen=True)
class RightRange:
    """A right answer and what counts as right, from `low` to `high`, both included."""

    value: Fraction
    low: Fraction
    high: Fraction

    def times(self, factor: int) -> RightRange:
        """The same in a unit so many times finer."""
        return RightRange(self.value * factor, self.low * factor, self.high * factor)

    @property
    def typed_fits(self) -> bool:
        """Whether the right answer is still right with the decimals that are kept of it."""
        return self.low <= round_as_kept(self.value) <= self.high

    @property
    def fits(self) -> bool:
        """Whether the decimals are also enough for what counts as right on either side of the right
        answer.
        """
        if self.low == self.high:
            return self.typed_fits
        large = self.value == 0 or abs(self.value) >= _SMALLEST
        return large and (self._wide_enough or self._bounds_kept)

    @property
    def _wide_enough(self) -> bool:
        return min(self.value - self.low, self.high - self.value) >= _KEPT

    @property
    def _bounds_kept(self) -> bool:
        """Whether rounding makes no right answer wrong, because the bounds are kept unchanged."""
        whole = all((bound / _KEPT).denominator == 1 for bound in (self.low, self.high))
        return whole and self.high - self.low >= 2 * _KEPT


def round_as_kept(number: Fraction) -> Fraction:
    """What Canvas keeps of a number.

    >>> float(round_as_kept(Fraction("1.23456")))
    1.2346
    """
    return round(number / _KEPT) * _KEPT


def list_finer_units(unit: str) -> Iterator[tuple[str, int]]:
    """The unit and those that are finer, each with how many of it make one of the first.

    >>> list(list_finer_units("km/s")), list(list_finer_units("rad/s"))
    ([('km/s', 1), ('m/s', 1000), ('mm/s', 1000000)], [('rad/s', 1)])
    """
    factor = 1
    yield unit, factor
    while found := _LENGTH_FIRST.match(unit):
        finer, more = _FINER[found[1]]
        unit, factor = finer + unit[found.end() :], factor * more
        yield unit, factor


def find_fitting_factor(unit: str, right: RightRange) -> int | None:
    """How many times finer the unit must be: the nearest one in which the range fits, else the
    finest one.

    None where not even the right answer itself is right in the finest one.
    """
    factor = 1
    for _, factor in list_finer_units(unit):
        if right.times(factor).fits:
            return factor
    return factor if right.times(factor).typed_fits else None
