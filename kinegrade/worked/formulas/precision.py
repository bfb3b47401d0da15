"""Which numbers of a solution print with more digits than usual: those that lose digits further
down, as where two nearly equal ones are subtracted, so that whoever works out a line with its
printed numbers gets the printed result, to one of its last digit; then those that lead to them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from math import degrees, floor, log10

from kinegrade.worked.formulas.atoms import Measured, Number
from kinegrade.worked.formulas.equation import Equation
from kinegrade.worked.formulas.exactness import is_exact, is_numeric, list_parts
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.notation import Notation
from kinegrade.worked.formulas.printed_values import find_printed_value

_DIGITS = 4  # of a result that has fewer, as it is exact
_MOST = 3  # digits beyond the usual ones
_ROOM = 0.99  # units of the last digit


@dataclass(frozen=True)
class _Working:
    """Numbers, and what they are said to amount to."""

    numbers: Formula
    result: Number
    in_degrees: bool

    def is_off(self, notation: Notation) -> bool:
        """Whether the printed numbers give another result than the printed one."""
        return self._measure(notation) > _ROOM

    def _measure(self, notation: Notation) -> float:
        """How far off it is, in units of the last digit."""
        shown = self.result.show(notation)
        value = abs(float(shown))
        last = len(shown.partition(".")[2])
        place = max(last, _DIGITS - 1 - floor(log10(value))) if not self.result.rounded else last
        worked = abs(find_printed_value(self.numbers, notation))
        away = (degrees(worked) if self.in_degrees else worked) - value
        return abs(away) * 10.0**place

    def choose(self, notation: Notation) -> str | None:
        """The number whose next digit brings the result nearest."""
        finer = {
            number.long.removeprefix("-"): _refine(notation, number)
            for number in _list_numbers(self.numbers)
        }
        left = {long: one for long, one in finer.items() if one.finer[long] <= _MOST}
        return min(left, key=lambda long: self._measure(left[long]), default=None)


def _refine(notation: Notation, number: Number) -> Notation:
    long = number.long.removeprefix("-")
    return replace(notation, finer={**notation.finer, long: notation.finer.get(long, 0) + 1})


def _list_numbers(formula: Formula) -> Iterator[Number]:
    """The rounded numbers of a formula."""
    for part in list_parts(formula):
        if isinstance(part, Number) and part.rounded and part.long and "e" not in part.digits:
            yield part


def find_finer(equations: Iterable[Equation]) -> Mapping[str, int]:
    """The digits beyond the usual ones that numbers need, by what these are without rounding."""
    workings = [working for equation in equations for working in _list_workings(equation)]
    notation, settled = Notation(), False
    while not settled:
        settled = True
        for working in workings:
            while working.is_off(notation) and (chosen := working.choose(notation)):
                finer = {**notation.finer, chosen: notation.finer.get(chosen, 0) + 1}
                notation, settled = replace(notation, finer=finer), False
    return notation.finer


def _list_workings(equation: Equation) -> Iterator[_Working]:
    """The last numbers of an equation that stand before a decimal, with that."""
    numbers: Formula | None = None
    for formula in (equation.left, *(link.right for link in equation.links)):
        result = _find_number(formula)
        if result is None:
            if is_exact(formula):  # it says nothing of what leads to it
                continue
            numbers = formula if is_numeric(formula) and any(_list_numbers(formula)) else None
        elif numbers is not None and float(result.digits):
            yield _Working(numbers, result, "deg" in _list_units(formula))


def _list_units(formula: Formula) -> list[str]:
    return [part.unit for part in list_parts(formula) if isinstance(part, Measured)]


def _find_number(formula: Formula) -> Number | None:
    """The decimal that a formula is, without its sign; None where it is more."""
    size = formula.size
    number = size.number if isinstance(size, Measured) else size
    return number if isinstance(number, Number) else None
