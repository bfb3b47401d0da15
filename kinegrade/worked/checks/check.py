"""A check of a result by another way: two sides worked out with the numbers printed before, which
agree where no slip has been made.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from kinegrade.language.math.width import measure_row
from kinegrade.language.message import Message
from kinegrade.worked.case import Case
from kinegrade.worked.document import Prose
from kinegrade.worked.formulas.equation import WIDEST, Equation, approximate
from kinegrade.worked.formulas.exactness import is_rounded
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.formulas.notation import PLAIN
from kinegrade.worked.formulas.numbers import state_number

_LONGEST = 2 * WIDEST  # letters of both sides: what is read at a glance
_CLOSE = 1e-9  # relative: far below a digit that is printed


@dataclass(frozen=True)
class Check:
    """By which way, and what either side amounts to."""

    way: Message
    left: Equation
    right: Equation

    @property
    def is_telling(self) -> bool:
        """Whether the sides are read at a glance, and are not the same from the start."""
        letters = sum(measure_row(side.print_inline(PLAIN)) for side in (self.left, self.right))
        return letters <= _LONGEST and self.left.left != self.right.left

    def say(self, case: Case) -> Prose:
        """The check in one sentence."""
        left, right = map(case.tell, (self.left, self.right))
        return case.say(Message("solution.check", way=self.way, left=left, right=right))


@dataclass(frozen=True)
class Side:
    """One side in numbers, and its value in SI."""

    numbers: Formula
    value: Any

    def work_out(self, unit: str) -> Equation:
        """The side with its value; alone where it is nothing but a value."""
        if self.numbers.is_decimal:
            return Equation(self.numbers, ())
        *_, decimal = state_number(self.value, unit)
        links = approximate(decimal.right) if is_rounded(self.numbers) else (decimal,)
        return Equation(self.numbers, links)


def compare(way: Message, left: Side, right: Side, unit: str, largest: float = 0.0) -> Check:
    """The check of two sides in one unit; where only the errors of doubles tell their values apart,
    measured by the larger of the left side and `largest`, both are rounded alike.
    """
    greatest = max(abs(double(left.value)), largest)
    same = abs(double(left.value) - double(right.value)) < _CLOSE * greatest
    other = Side(right.numbers, left.value) if same else right
    return Check(way, left.work_out(unit), other.work_out(unit))
