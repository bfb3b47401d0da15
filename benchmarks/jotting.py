"""The arithmetic of a student who rounds the result of every operation, for many students at once.

Each result is written to some significant figures; with a source of chance it is off by anything
within half a unit of the last figure, as if other roundings had gone before. Numbers are arrays
with an entry for each student. Nothing of the package's bound is used here.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from kinegrade.numbers.floats import Floats

NOTHING = 1e-12
EXACT = 0.01  # of a unit: a value that has no more figures is written as it is


class Jotted:
    """A number as it was written down, by each of the students."""

    __array_ufunc__ = None

    def __init__(self, jotting: Jotting, value: Any, *, angle: bool = False) -> None:
        self.jotting, self.value, self.angle = jotting, np.asarray(value, dtype=float), angle

    def __add__(self, other: Any) -> Any:
        if not isinstance(other, Jotted) and not np.any(other):
            return self
        angle = self.angle or (isinstance(other, Jotted) and other.angle)
        value, written = plain(other), self.jotting.write(self.value + plain(other), angle=angle)
        # What is below the last figure of the other summand leaves that as it is
        for one, small in ((self.value, value), (value, self.value)):
            below = np.abs(small) < 0.5 * self.jotting.find_unit(one, angle=angle)
            written.value = np.where(below, one, written.value)
        return written

    __radd__ = __add__

    def __neg__(self) -> Jotted:
        return Jotted(self.jotting, -self.value, angle=self.angle)

    def __abs__(self) -> Jotted:
        return Jotted(self.jotting, np.abs(self.value), angle=self.angle)

    def __sub__(self, other: Any) -> Any:
        return self + -other

    def __rsub__(self, other: Any) -> Any:
        return -self + other

    def __mul__(self, other: Any) -> Any:
        if not isinstance(other, Jotted) and not np.any(other):
            return 0.0
        angle = self.angle and not isinstance(other, Jotted)
        written = self.jotting.write(self.value * plain(other), angle=angle)
        for one, factor in ((self.value, plain(other)), (plain(other), self.value)):
            written.value = np.where(np.abs(factor) == 1, one * factor, written.value)
        return written

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Any:
        return self * (1 / plain(other)) if not isinstance(other, Jotted) else self.divide(other)

    def divide(self, other: Jotted) -> Jotted:
        """The quotient; by one nothing is written."""
        written = self.jotting.write(self.value / other.value)
        written.value = np.where(other.value == 1, self.value, written.value)
        return written

    def __rtruediv__(self, other: Any) -> Any:
        return self.jotting.write(plain(other) / self.value)

    def __pow__(self, power: int) -> Any:
        result: Any = 1.0
        for _ in range(power):
            result = self * result
        return result

    def __lt__(self, other: Any) -> Any:
        return self.value < plain(other)

    def __gt__(self, other: Any) -> Any:
        return self.value > plain(other)

    def __float__(self) -> float:
        return float(self.value.flat[0])


def plain(number: Any) -> Any:
    """The values alone."""
    return number.value if isinstance(number, Jotted) else number


class Jotting(Floats):
    """The arithmetic; `figures` are written, and with `chance` errors are random."""

    def __init__(self, figures: int, chance: np.random.Generator | None = None) -> None:
        self.figures, self.chance = figures, chance

    def write(self, value: Any, *, angle: bool = False) -> Jotted:
        """A result written down; an angle, in radians, in degrees."""
        shown = np.degrees(value) if angle else np.asarray(value, dtype=float)
        size, unit = np.abs(shown), self.find_unit(shown)
        unit = np.where(size < NOTHING, 1.0, unit)
        rounded = np.rint(shown / unit) * unit
        if self.chance is not None:
            error = self.chance.uniform(-0.5, 0.5, size.shape) * unit
            rounded = np.where(np.abs(shown - rounded) <= EXACT * unit, rounded, shown + error)
        written = np.where(size < NOTHING, 0.0, rounded)
        return Jotted(self, np.radians(written) if angle else written, angle=angle)

    def find_unit(self, value: Any, *, angle: bool = False) -> Any:
        """The unit of the last figure, of an angle in degrees but given in radians."""
        size = np.abs(np.degrees(value) if angle else value)
        exponent = np.floor(np.log10(np.where(size < NOTHING, 1.0, size)))
        unit = 10.0 ** (exponent + 1 - self.figures)
        return np.where(size < NOTHING, 0.0, np.radians(unit) if angle else unit)

    def number(self, rational: Any) -> Any:
        return rational if isinstance(rational, Jotted) else super().number(rational)

    def fork(self) -> Jotting:
        return self

    def is_zero(self, number: Any) -> bool:
        return super().is_zero(plain(number))

    def sign(self, number: Any) -> Any:
        return super().sign(plain(number))

    def choose(self, condition: Any, yes: Any, no: Any) -> Any:
        if not (isinstance(yes, Jotted) or isinstance(no, Jotted)):
            return super().choose(condition, yes, no)
        angle = any(isinstance(one, Jotted) and one.angle for one in (yes, no))
        return Jotted(self, np.where(condition, plain(yes), plain(no)), angle=angle)

    def sqrt(self, number: Any) -> Any:
        root = super().sqrt(plain(number))
        return self.write(root) if isinstance(number, Jotted) else root

    def cos(self, angle: Any) -> Any:
        return self.write(np.cos(plain(angle))) if isinstance(angle, Jotted) else np.cos(angle)

    def sin(self, angle: Any) -> Any:
        return self.write(np.sin(plain(angle))) if isinstance(angle, Jotted) else np.sin(angle)

    def arctangent(self, y: Any, x: Any) -> Any:
        found = np.arctan2(plain(y), plain(x))
        written = isinstance(y, Jotted) or isinstance(x, Jotted)
        return self.write(found, angle=True) if written else found

    def solve(self, rows: list[list[Any]], right: list[Any]) -> list[Any]:
        """By elimination, each line rounded; the largest entries of the first student lead."""
        table = [[*row, side] for row, side in zip(rows, right, strict=True)]
        count = len(rows[0])
        for column in range(count):
            pivot = max(range(column, len(table)), key=lambda index: lead(table[index][column]))
            table[column], table[pivot] = table[pivot], table[column]
            divisor = table[column][column]
            table[column] = source = [entry / divisor for entry in table[column]]
            for index, row in enumerate(table):
                multiple = row[column]
                if index != column and np.any(plain(multiple)):
                    table[index] = [e - multiple * s for e, s in zip(row, source, strict=True)]
        return [row[count] for row in table[:count]]


def lead(entry: Any) -> float:
    """The size of an entry for the first student."""
    return abs(float(np.ravel(plain(entry))[0]))
