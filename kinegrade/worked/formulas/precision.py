"""With how many digits the rounded numbers of a solution print: with more than usual, all of them,
where what follows would lose digits, as where two nearly equal ones are subtracted. So whoever
works out a line with its printed numbers gets the printed result, to one of its fourth digit.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from math import degrees, floor, log10

from kinegrade.worked.formulas.atoms import Measured, Number
from kinegrade.worked.formulas.equation import Equation
from kinegrade.worked.formulas.exactness import is_exact, is_numeric, list_parts
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.notation import DIGITS, Notation
from kinegrade.worked.formulas.printed_values import find_printed_value

MOST_MORE_DIGITS = 3
_ROOM = 0.99  # units of the last digit that is usual


@dataclass(frozen=True)
class _Working:
    """Numbers, and what they are said to amount to."""

    numbers: Formula
    result: Number
    in_degrees: bool

    def measure(self, notation: Notation) -> float:
        """How far from the printed result that of the printed numbers is, in units of the last
        digit that is usual.
        """
        value = abs(float(self.result.show(notation)))
        last = len(self.result.digits.partition(".")[2])
        place = last if self.result.rounded else max(last, DIGITS - 1 - floor(log10(value)))
        worked = abs(find_printed_value(self.numbers, notation))
        away = (degrees(worked) if self.in_degrees else worked) - value
        return float(abs(away) * 10.0**place)


def find_more_digits(equations: Iterable[Equation]) -> int:
    """The digits beyond the usual ones: as few as do, else those that do best."""
    workings = [working for equation in equations for working in _list_workings(equation)]
    worst = dict[int, float]()
    for more in range(MOST_MORE_DIGITS + 1):
        notation = Notation(more_digits=more)
        worst[more] = max((one.measure(notation) for one in workings), default=0.0)
        if worst[more] <= _ROOM:
            return more
    return min(worst, key=lambda more: worst[more])


def _list_workings(equation: Equation) -> Iterator[_Working]:
    """The last numbers of an equation that stand before a decimal, with that."""
    numbers: Formula | None = None
    for formula in (equation.left, *(link.right for link in equation.links)):
        result = _find_number(formula)
        if result is None:
            if is_exact(formula):  # it says nothing of what leads to it
                continue
            numbers = formula if is_numeric(formula) and any(_list_rounded(formula)) else None
        elif numbers is not None:
            if float(result.digits):
                yield _Working(numbers, result, "deg" in _list_units(formula))
            numbers = None  # a decimal that follows is this one in another unit


def _list_rounded(formula: Formula) -> Iterator[Number]:
    """The rounded numbers of a formula."""
    for part in list_parts(formula):
        if isinstance(part, Number) and part.rounded and part.long:
            yield part


def _list_units(formula: Formula) -> list[str]:
    return [part.unit for part in list_parts(formula) if isinstance(part, Measured)]


def _find_number(formula: Formula) -> Number | None:
    """The decimal that a formula is, without its sign; None where it is more."""
    size = formula.size
    number = size.number if isinstance(size, Measured) else size
    return number if isinstance(number, Number) else None
