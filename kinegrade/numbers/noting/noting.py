"""The arithmetic of a student who writes down every value: sines, roots and angles, and the lines
of an elimination.

It finds no answers; it follows the working of a right solution to see how far off rounding may put
the results (`kinegrade.numbers.noting.pad`).
"""

from __future__ import annotations

from contextlib import AbstractContextManager
from typing import Any

import numpy as np

from kinegrade.numbers.elimination import Singular
from kinegrade.numbers.floats import Floats
from kinegrade.numbers.noting.pad import NOTHING, Noted, Pad, Use

_Table = list[list[Any]]


class Noting(Floats):
    """The arithmetic of numbers on a `pad`; numbers that are not on it are constants."""

    def __init__(self, pad: Pad) -> None:
        self.pad = pad

    def fork(self) -> Noting:
        """The same arithmetic: floats need no field."""
        return self

    def context(self) -> AbstractContextManager[Any]:
        """Instances without a value have NaN, and so have their errors."""
        return np.errstate(all="ignore")

    def number(self, rational: Any) -> Any:
        """A rational or exact number as a constant; a number on the pad stays there."""
        return rational if isinstance(rational, Noted) else super().number(rational)

    def is_zero(self, number: Any) -> bool:
        """Whether a number is zero to within rounding, in every instance."""
        return super().is_zero(_find_value(number))

    def sign(self, number: Any) -> Any:
        """-1, 0 or 1, elementwise; values within rounding of zero count as zero."""
        return super().sign(_find_value(number))

    def choose(self, condition: Any, yes: Any, no: Any) -> Any:
        """`yes` where the condition holds, else `no`, elementwise; nothing is written."""
        if not (isinstance(yes, Noted) or isinstance(no, Noted)):
            return super().choose(condition, yes, no)
        condition = np.broadcast_to(condition, self.pad.count)
        first, second = self._put(yes), self._put(no)
        return self.pad.write(
            np.where(condition, first.value, second.value),
            (Use(first.place, condition * 1.0), Use(second.place, ~condition * 1.0)),
            exact=np.where(condition, first.exact, second.exact),
            copied=True,
            angle=first.angle or second.angle,
        )

    def _put(self, number: Any) -> Noted:
        """A number on the pad: a constant is written with all its figures."""
        if isinstance(number, Noted):
            return number
        value = np.broadcast_to(np.asarray(number, dtype=float), self.pad.count)
        return self.pad.write(value, copied=True)

    def sqrt(self, number: Any) -> Any:
        """The positive square root, written down; NaN below zero."""
        if not isinstance(number, Noted):
            return super().sqrt(number)
        root = super().sqrt(number.value)
        none = root < NOTHING
        slope = np.where(none, 0.0, 0.5 / np.where(none, 1.0, root))
        return self.pad.write(root, (Use(number.place, slope),), exact=number.exact)

    def cos(self, angle: Any) -> Any:
        """Cosine of an angle in radians, written down."""
        if not isinstance(angle, Noted):
            return super().cos(angle)
        uses = (Use(angle.place, -np.sin(angle.value)),)
        return self.pad.write(np.cos(angle.value), uses, exact=angle.exact)

    def sin(self, angle: Any) -> Any:
        """Sine of an angle in radians, written down."""
        if not isinstance(angle, Noted):
            return super().sin(angle)
        uses = (Use(angle.place, np.cos(angle.value)),)
        return self.pad.write(np.sin(angle.value), uses, exact=angle.exact)

    def arctangent(self, y: Any, x: Any) -> Any:
        """The angle from +x to the vector (x, y) in radians, written down in degrees."""
        if not (isinstance(y, Noted) or isinstance(x, Noted)):
            return super().arctangent(y, x)
        up, right = self._put(y), self._put(x)
        square = up.value**2 + right.value**2
        return self.pad.write(
            np.arctan2(up.value, right.value),
            (Use(up.place, right.value / square), Use(right.place, -up.value / square)),
            exact=up.exact & right.exact,
            angle=True,
        )

    def solve(self, rows: _Table, right: list[Any]) -> list[Any]:
        """The unknowns of rows * unknowns = right, by elimination with all its lines written down;
        surplus rows are not needed and are ignored.

        NaN in instances that do not determine them. Raises Singular where the rows are too few.
        """
        table = [[*row, side] for row, side in zip(rows, right, strict=True)]
        count = len(rows[0])
        if len(table) < count:
            raise Singular
        for column in range(count):
            for lower in range(column + 1, len(table)):
                self._bring_larger(table, column, lower)
            _clear(table, column)
        return [row[count] for row in table[:count]]

    def _bring_larger(self, table: _Table, column: int, lower: int) -> None:
        """Exchange the column's row with a lower one in the instances where that has the larger
        entry.
        """
        upper_row, lower_row = table[column], table[lower]
        larger = np.abs(_find_value(lower_row[column])) > np.abs(_find_value(upper_row[column]))
        if not np.any(larger):
            return
        if np.all(larger):
            table[column], table[lower] = lower_row, upper_row
            return
        pairs = list(zip(upper_row, lower_row, strict=True))
        table[column] = [self.choose(larger, below, above) for above, below in pairs]
        table[lower] = [self.choose(larger, above, below) for above, below in pairs]


def _clear(table: _Table, column: int) -> None:
    """Make the pivot one and the rest of its column zero."""
    pivot = table[column][column]
    table[column] = source = [_divide(entry, pivot) for entry in table[column]]
    for index, row in enumerate(table):
        multiple = row[column]
        if index != column and not _is_nothing(multiple):
            table[index] = [
                entry - multiple * part for entry, part in zip(row, source, strict=True)
            ]


def _divide(entry: Any, pivot: Any) -> Any:
    """A quotient; a constant over zero is infinite, as an array would have it."""
    return entry / (pivot if isinstance(pivot, Noted) else np.float64(pivot))


def _is_nothing(number: Any) -> bool:
    return not isinstance(number, Noted) and bool(np.all(number == 0))


def _find_value(number: Any) -> Any:
    return number.value if isinstance(number, Noted) else number
