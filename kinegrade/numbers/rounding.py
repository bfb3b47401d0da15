"""The arithmetic of working by hand: doubles, in which everything written down is rounded to a
number of significant figures.

Written down are sines and cosines, roots, angles found from their sides, and the unknowns of every
solved set of equations; the caller rounds with `noted` what else is put on paper (coordinates, the
terms of a vector equation). Sums and products within one line of working stay in the calculator.
"""

from __future__ import annotations

from contextlib import AbstractContextManager, nullcontext
from math import atan2, cos, degrees, floor, log10, pi, radians, sin, sqrt
from typing import Any

from kinegrade.numbers.elimination import Singular
from kinegrade.numbers.magnitude import Magnitude
from kinegrade.numbers.surd import Surd

NOTHING = 1e-12  # anything smaller is zero: lengths, sines and rates of exercises are not


class Rounded(Magnitude):
    """The arithmetic of a student who writes down `figures` significant figures. Never the
    reference.

    >>> Rounded(3).sqrt(3.0), Rounded(3).cos(pi / 6), Rounded(4).written(-0.0123456)
    (1.73, 0.866, -0.01235)
    """

    exact = False
    certified = False

    def __init__(self, figures: int) -> None:
        self.figures = figures

    def written(self, number: float) -> float:
        """The number as it is written down; what is within rounding of zero is zero."""
        size = abs(number)
        return round(number, self.figures - 1 - floor(log10(size))) if size >= NOTHING else 0.0

    def noted(self, number: float) -> float:
        """An intermediate value as the working continues with it: written down."""
        return self.written(number)

    def fork(self) -> Rounded:
        """The same arithmetic: doubles need no field."""
        return self

    def context(self) -> AbstractContextManager[Any]:
        """Nothing to set up."""
        return nullcontext()

    def embed(self, value: Any) -> Any:
        """The same double: doubles need no conversion."""
        return value

    def number(self, rational: Any) -> float:
        """A rational or exact number as a double, not rounded: givens are used as stated."""
        if isinstance(rational, (int, float, Surd)):
            return float(rational)
        return int(rational.p) / int(rational.q)

    def turns(self, half_turns: Any) -> float:
        """The angle of `half_turns` times pi, in radians; not rounded."""
        return self.number(half_turns) * pi

    def is_zero(self, number: float) -> bool:
        """Whether a number is zero to within the rounding of doubles."""
        return abs(number) < NOTHING

    def sign(self, number: float) -> int:
        """-1, 0 or 1; values within rounding of zero count as zero."""
        return 0 if self.is_zero(number) else 1 if number > 0 else -1

    def choose(self, condition: Any, yes: Any, no: Any) -> Any:
        """`yes` where the condition holds, else `no`."""
        return yes if condition else no

    def sqrt(self, number: float) -> float:
        """The positive square root, written down. Raises ValueError below zero."""
        return 0.0 if self.is_zero(number) else self.noted(sqrt(number))

    def cos(self, angle: float) -> float:
        """Cosine of an angle in radians, written down."""
        return self.noted(cos(angle))

    def sin(self, angle: float) -> float:
        """Sine of an angle in radians, written down."""
        return self.noted(sin(angle))

    def arctangent(self, y: float, x: float) -> float:
        """The angle from +x to the vector (x, y) in radians, written down in degrees."""
        return radians(self.noted(degrees(atan2(y, x))))

    def solve(self, rows: list[list[float]], right: list[float]) -> list[float]:
        """The unknowns of rows * unknowns = right, each written down; surplus rows are not needed
        and are ignored.

        Raises Singular where the rows do not determine every unknown.
        """
        table = [[*row, value] for row, value in zip(rows, right, strict=True)]
        count = len(rows[0])
        if len(table) < count:
            raise Singular
        for column in range(count):
            _bring_largest(table, column)
            _clear(table, column)
        return [self.written(row[count]) for row in table[:count]]

    def require_zero(self, number: Any) -> None:
        """Nothing: rounded values agree only approximately."""


class Sparing(Rounded):
    """The arithmetic of a student who writes down only the solved unknowns, and keeps the rest in
    the calculator.

    >>> Sparing(3).cos(0.3), Sparing(3).solve([[3.0]], [2.0])
    (0.955336489125606, [0.667])
    """

    def noted(self, number: float) -> float:
        """The number with all its figures; what is within rounding of zero is zero."""
        return 0.0 if self.is_zero(number) else number


def _bring_largest(table: list[list[float]], column: int) -> None:
    """Exchange rows so that the largest entry of the column, from its diagonal row on, is the
    pivot. Raises Singular.
    """
    pivot = max(range(column, len(table)), key=lambda index: abs(table[index][column]))
    if not abs(table[pivot][column]) >= NOTHING:
        raise Singular
    table[column], table[pivot] = table[pivot], table[column]


def _clear(table: list[list[float]], column: int) -> None:
    """Make the pivot one and the rest of its column zero."""
    divisor = table[column][column]
    table[column] = source = [entry / divisor for entry in table[column]]
    for index, row in enumerate(table):
        multiple = row[column]
        if index != column and multiple:
            table[index] = [
                entry - multiple * part for entry, part in zip(row, source, strict=True)
            ]
