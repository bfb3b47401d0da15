"""Components of vectors as sums: in symbols, in numbers, with their value."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

from kinegrade.mechanics.vector import AxisName
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.formulas.atoms import TWO, ZERO, VectorSymbol, add_terms
from kinegrade.worked.formulas.equation import Equation, lead_to
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.numbers import state_number
from kinegrade.worked.vectors.vectors import UNITS

PLACES: dict[AxisName, int] = {"x": 0, "y": 1}


@dataclass(frozen=True)
class Summand:
    """A summand with its sign, in symbols and as the factors of its number."""

    sign: Literal["+", "-"]
    symbol: Formula
    numbers: tuple[Formula, ...]
    squared: bool = False  # whether the first number is squared

    @property
    def counts(self) -> bool:
        """Whether none of its factors is zero."""
        return ZERO not in self.numbers

    @property
    def in_symbols(self) -> Formula:
        """The summand in symbols."""
        return self._sign(self.symbol)

    @property
    def in_numbers(self) -> Formula:
        """The summand in numbers."""
        first, *others = self.numbers
        product: Formula = first**TWO if self.squared else first
        for number in others:
            product = product.dot(number)
        return self._sign(product)

    def _sign(self, formula: Formula) -> Formula:
        return {"+": formula, "-": -formula}[self.sign]


def name_component(vector: VectorSymbol, axis: AxisName) -> VectorSymbol:
    """The component of a vector: v_Bx of v_B."""
    return replace(vector, axis=axis)


def add_summands(left: Formula, summands: Sequence[Summand], value: Any, level: Level) -> Equation:
    """A component as the sum of its summands in symbols, in numbers as far as they count, and its
    value.
    """
    symbols = add_terms(one.in_symbols for one in summands)
    numbers = add_terms(one.in_numbers for one in summands if one.counts)
    return Equation(
        left, lead_to(left, (symbols, numbers), state_number(value, UNITS[level, False]))
    )
