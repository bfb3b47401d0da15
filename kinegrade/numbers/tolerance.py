"""How far from the exact value an answer still counts as right: the rule that a bank states, the
paper prints and marking goes by.
"""

from __future__ import annotations

from fractions import Fraction

from msgspec import Struct

from kinegrade.numbers.decimals import figures_interval

# Significant figures that a bank may ask students to carry, and what holds where it says nothing
LEAST_CARRY, MOST_CARRY, USUAL_CARRY = 3, 6, 4
_CARRIED = 3  # significant figures that every student carries through a calculation
_MOST_UNITS = 11  # of the last figure, more than an answer that agrees may be off


class Tolerance(Struct, frozen=True):
    """Right within max(relative*|exact value|, absolute), the bounds included; absolute in the
    ask's unit.

    With `figures`, right is also what agrees with the exact value rounded to that many significant
    figures: within half a unit of the last of them, the bounds included. Whatever of the three
    gives more room holds.
    """

    relative: Fraction = Fraction(0)
    absolute: Fraction = Fraction(0)
    figures: int | None = None

    @property
    def share(self) -> Fraction:
        """The largest relative deviation that the rule allows, whatever the value: 1/100, or 1/200
        for 3 figures.
        """
        return max(self.relative, Fraction(5, 10**self.figures) if self.figures else Fraction(0))

    @property
    def widest_share(self) -> float:
        """A relative deviation, beside `absolute`, with which no value is right any more."""
        return float(self.relative) + (_MOST_UNITS / 10**self.figures if self.figures else 0)

    def room(self, exact: Fraction) -> Fraction:
        """How far an answer may be off, significant figures aside."""
        return max(self.relative * abs(exact), self.absolute)

    def goes_by_figures(self, exact: Fraction) -> bool:
        """Whether an answer may also agree to significant figures; zero has none."""
        return bool(self.figures and exact)

    def interval(self, exact: Fraction) -> tuple[Fraction, Fraction]:
        """The smallest and the largest right answer.

        >>> [float(bound) for bound in Tolerance(figures=3).interval(Fraction("1.2304"))]
        [1.225, 1.235]
        """
        room = self.room(exact)
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


ONE_PER_CENT = Tolerance(Fraction(1, 100))
