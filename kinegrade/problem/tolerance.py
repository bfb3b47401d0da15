"""How far from the exact value an answer still counts as right: the rule that a bank states and the
paper prints.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache
from math import floor, log10

from kinegrade.mechanics.doubles import MotionInDoubles
from kinegrade.numbers.figures import figures_interval
from kinegrade.numbers.units import Unit
from kinegrade.problem.scale import find_scale

_CARRIED = 3  # significant figures that every student carries through a calculation


@dataclass(frozen=True)
class Tolerance:
    """Right within max(relative*|exact value|, absolute), the bounds included; absolute in the
    ask's unit.

    With `figures`, right is also what agrees with the exact value rounded to that many significant
    figures: within half a unit of the last of them, the bounds included. Whatever of the three
    gives more room holds.
    """

    relative: Fraction
    absolute: Fraction
    figures: int | None = None

    @property
    def share(self) -> Fraction:
        """The largest relative deviation that the rule allows, whatever the value: 1/100, or 1/200
        for 3 figures.
        """
        return max(self.relative, Fraction(5, 10**self.figures) if self.figures else Fraction(0))

    def interval(self, exact: Fraction) -> tuple[Fraction, Fraction]:
        """The smallest and the largest right answer.

        >>> three_figures = Tolerance(Fraction(0), Fraction(0), 3)
        >>> [float(bound) for bound in three_figures.interval(Fraction("1.2304"))]
        [1.225, 1.235]
        """
        room = max(self.relative * abs(exact), self.absolute)
        low, high = exact - room, exact + room
        if self.figures and exact:
            nearest = figures_interval(exact, self.figures)
            low, high = min(low, nearest[0]), max(high, nearest[1])
        return low, high

    def carried(self, exact: Fraction) -> int:
        """The significant figures that a student must carry: 3, or as many more as it takes to
        distinguish right from wrong.

        A number written to n figures may be off by half a unit of the last; that must be less than
        what is allowed.
        """
        share = float(max(self.share, self.absolute / abs(exact)) if exact else self.share)
        figures = _CARRIED
        while share and 5 / 10**figures >= share:
            figures += 1
        return figures


ONE_PER_CENT = Tolerance(Fraction(1, 100), Fraction(0))


def find_effective_tolerance(
    tolerance: Tolerance, value: float, unit: Unit, motion: MotionInDoubles
) -> Tolerance:
    """The tolerance for an answer of `value` units: where it is zero or next to it, the rule's
    share of the mechanism's scale is allowed. Next to zero means smaller than that.
    """
    room = tolerance.share * find_scale_of_mechanism(motion, unit)
    if abs(value) >= room:
        return tolerance
    return replace(tolerance, absolute=max(tolerance.absolute, room))


@lru_cache(maxsize=1024)
def find_scale_of_mechanism(motion: MotionInDoubles, unit: Unit) -> Fraction:
    """The mechanism's scale in a unit, to two significant figures."""
    return round_to_two_figures(find_scale(motion, unit))


def round_to_two_figures(size: float) -> Fraction:
    """A size rounded to two significant figures, exactly; what doubles left of a tie is a tie."""
    if size <= 0:
        return Fraction(0)
    step = Fraction(10) ** (floor(log10(size)) - 1)
    return round(Fraction(f"{size:.12g}") / step) * step
