"""The two sides of a check in numbers, with as many digits as whoever works them out with the
printed numbers gets.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import floor, log10
from typing import Any

from kinegrade.worked.formulas.atoms import ZERO, Measured, Number, add_terms
from kinegrade.worked.formulas.equation import Equation, Link, approximate, equate
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.formulas.notation import DIGITS, Notation
from kinegrade.worked.formulas.numbers import round_number
from kinegrade.worked.formulas.printed_values import find_printed_value
from kinegrade.worked.vectors.summands import Summand

_EQUAL = 1e-9  # relative: far below a digit that is printed


@dataclass(frozen=True)
class Side:
    """One side in numbers, and its value in SI; in letters first where it has such."""

    numbers: Formula
    value: Any
    letters: Formula | None = None

    @property
    def sum(self) -> Formula:
        """Its terms, in letters where it has such."""
        return self.letters or self.numbers

    def count_digits(self, notation: Notation) -> int:
        """How many digits of the value its printed numbers give, to within one of the last, at most
        as many as are usual; none where they cancel but for what rounding has left.
        """
        value = double(self.value)
        if self.numbers.is_decimal or not value:
            return DIGITS
        printed, first = find_printed_value(self.numbers, notation), floor(log10(abs(value)))
        for digits in range(DIGITS, 0, -1):
            rounded = find_printed_value(self._round(digits), notation)
            if abs(printed - rounded) < 10.0 ** (first - digits + 1):
                return digits
        return 0

    def work_out(self, unit: str, digits: int, notation: Notation) -> Equation:
        """The side with its value; alone where it is nothing but a value."""
        said = self.numbers.is_decimal and (digits == DIGITS or not double(self.value))
        value = () if said else self._state_value(unit, digits, notation)
        if self.letters is None:
            return Equation(self.numbers, value)
        rounded = self.numbers.is_decimal and self._misses(self.numbers, notation)
        numbers = approximate(self.numbers) if rounded else equate(self.numbers)
        if value and self.numbers.is_decimal:
            return Equation(self.letters, value)
        return Equation(self.letters, (*numbers, *value))

    def drop_letters(self, worked: Equation) -> Equation:
        """The side as it has been worked out, without the letters before the numbers."""
        if self.letters is None:
            return worked
        first, *others = worked.links
        return Equation(first.right, tuple(others))

    def _round(self, digits: int) -> Number:
        """The value as usual, or with the fewer digits that its numbers give."""
        number = round_number(self.value, digits)
        return number if digits == DIGITS else replace(number, long="")

    def _misses(self, number: Formula, notation: Notation) -> bool:
        """Whether what is printed is not the value, but is rounded, or made of rounded numbers."""
        printed, value = find_printed_value(number, notation), double(self.value)
        return abs(printed - value) > _EQUAL * max(abs(value), 1e-3)

    def _state_value(self, unit: str, digits: int, notation: Notation) -> tuple[Link, ...]:
        zero = not (digits and double(self.value))
        number = ZERO if zero else self._round(digits)
        stated = ZERO if zero else Measured(number, unit)
        if self.count_digits(notation) < DIGITS or self._misses(number, notation):
            return approximate(stated)
        printed = find_printed_value(self.numbers, notation)
        away = abs(printed - find_printed_value(number)) > _EQUAL * max(abs(printed), 1e-3)
        return equate(stated) if away or not self.numbers.is_decimal else ()


def make_side(summands: Sequence[Summand], value: Any) -> Side:
    """The side that is a sum, in letters and in numbers."""
    told = [one for one in summands if one.counts]
    numbers = add_terms(one.in_numbers for one in told)
    letters = add_terms(one.in_symbols for one in told) if told else None
    return Side(numbers, value, letters)
