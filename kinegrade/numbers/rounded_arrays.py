"""Working by hand for many instances at once: arrays of doubles, each equal to the result of
`Rounded`, to the last bit.

Sums, products, quotients and roots of arrays are those of single doubles. Sines, cosines and angles
are taken from the same functions one by one; so are numbers close to the midpoint between two
roundings. An instance that takes another way than most (something vanishes in it, or cannot be
found) is marked as unsettled, to be worked out separately.
"""

from __future__ import annotations

import math
from contextlib import AbstractContextManager
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinegrade.numbers.elimination import Singular
from kinegrade.numbers.rounding import NOTHING, Rounded

_POWERS = np.array([float(10**power) for power in range(23)])  # those that doubles hold exactly
_NEAR = 1e-14  # relative: far more than the error of a product of two doubles
_DEGREES, _RADIANS = (
    180.0 / math.pi,
    math.pi / 180.0,
)  # as in `math.degrees` and `math.radians`
_SINE, _COSINE = np.frompyfunc(math.sin, 1, 1), np.frompyfunc(math.cos, 1, 1)
_ARCTANGENT = np.frompyfunc(math.atan2, 2, 1)


class RoundedArrays(Rounded):
    """The arithmetic of `Rounded`, or of `Sparing` where `sparing`, for arrays of `count`
    instances.

    `unsettled` marks the instances whose values are meaningless; where one of them is NaN,
    FloatingPointError is raised. Numbers that are not arrays are the same in all instances.

    >>> arithmetic = RoundedArrays(3, 2)
    >>> arithmetic.sqrt(np.array([3.0, -2.0])), arithmetic.written(np.array([1.235, 0.0]))
    (array([1.73, 1.  ]), array([1.24, 0.  ]))
    >>> arithmetic.unsettled
    array([False,  True])
    """

    def __init__(self, figures: int, count: int, *, sparing: bool = False) -> None:
        super().__init__(figures)
        self.sparing = sparing
        self.unsettled: NDArray[np.bool_] = np.zeros(count, dtype=bool)

    def context(self) -> AbstractContextManager[Any]:
        """Operations that give NaN are refused."""
        return np.errstate(divide="raise", over="raise", invalid="raise", under="ignore")

    def written(self, number: Any) -> Any:
        """The numbers as they are written down; what is within rounding of zero is zero."""
        if not isinstance(number, np.ndarray):
            return super().written(number)
        size = np.abs(number)
        none = size < NOTHING
        exponent = np.log10(np.where(none, 1.0, size))
        places = (self.figures - 1 - np.floor(exponent)).astype(int)
        power = _POWERS[np.minimum(np.abs(places), len(_POWERS) - 1)]
        below = places >= 0
        scaled = np.where(below, number * power, number / power)
        whole = np.rint(scaled)
        result = np.where(none, 0.0, np.where(below, whole / power, whole * power))
        tied = np.abs(np.abs(scaled - whole) - 0.5) <= _NEAR * np.abs(scaled)
        bound = np.abs(exponent - np.rint(exponent)) <= _NEAR * (1 + np.abs(exponent))
        for place in np.flatnonzero(~none & (tied | bound | (np.abs(places) >= len(_POWERS)))):
            result[place] = super().written(float(number[place]))
        return result

    def noted(self, number: Any) -> Any:
        """Intermediate values as the working continues with them: written down, or with all their
        figures.
        """
        if not self.sparing:
            return self.written(number)
        zero = np.abs(number) < NOTHING
        return (
            np.where(zero, 0.0, number)
            if isinstance(number, np.ndarray)
            else 0.0
            if zero
            else number
        )

    def number(self, rational: Any) -> Any:
        """A rational or exact number as a double; arrays stay arrays."""
        return rational if isinstance(rational, np.ndarray) else super().number(rational)

    def is_zero(self, number: Any) -> bool:
        """Whether numbers are zero in most instances; the others are unsettled."""
        zero = np.abs(number) < NOTHING
        if not isinstance(number, np.ndarray):
            return bool(zero)
        most = bool(
            2 * np.count_nonzero(zero & ~self.unsettled) > np.count_nonzero(~self.unsettled)
        )
        self.unsettled |= zero != most
        return most

    def sign(self, number: Any) -> Any:
        """-1, 0 or 1, one by one; values within rounding of zero count as zero."""
        return _plain(np.where(np.abs(number) < NOTHING, 0, np.sign(number)))

    def choose(self, condition: Any, yes: Any, no: Any) -> Any:
        """`yes` where the condition holds, else `no`, one by one."""
        return _plain(np.where(condition, yes, no))

    def sqrt(self, number: Any) -> Any:
        """The positive square root, written down; instances where there is none are unsettled."""
        if not isinstance(number, np.ndarray):
            return 0.0 if abs(number) < NOTHING else self.noted(math.sqrt(number))
        zero = np.abs(number) < NOTHING
        below = (number < 0) & ~zero
        self.unsettled |= below
        return np.where(zero, 0.0, self.noted(np.sqrt(np.where(zero | below, 1.0, number))))

    def magnitude(self, x: Any, y: Any) -> Any:
        """The lengths of vectors (x, y), one by one: along an axis the component itself, else a
        root, written down.
        """
        x, y = np.broadcast_to(x, self.unsettled.shape), np.broadcast_to(y, self.unsettled.shape)
        askew = self.sqrt(x * x + y * y)
        return np.where(self.sign(x) == 0, np.abs(y), np.where(self.sign(y) == 0, np.abs(x), askew))

    def cos(self, angle: Any) -> Any:
        """Cosines of angles in radians, written down."""
        return self.noted(_in_doubles(_COSINE(angle)))

    def sin(self, angle: Any) -> Any:
        """Sines of angles in radians, written down."""
        return self.noted(_in_doubles(_SINE(angle)))

    def arctangent(self, y: Any, x: Any) -> Any:
        """The angles from +x to the vectors (x, y) in radians, written down in degrees."""
        return self.noted(_in_doubles(_ARCTANGENT(y, x)) * _DEGREES) * _RADIANS

    def solve(self, rows: list[list[Any]], right: list[Any]) -> list[Any]:
        """The unknowns of rows * unknowns = right, each written down; instances without them are
        unsettled.
        """
        count = len(rows[0])
        if len(rows) < count:
            raise Singular
        table = np.empty((len(rows), count + 1, len(self.unsettled)))
        for place, (row, value) in enumerate(zip(rows, right, strict=True)):
            for column, entry in enumerate((*row, value)):
                table[place, column] = entry
        for column in range(count):
            table = self.cleared(table, column)
        return [self.written(table[index, count]) for index in range(count)]

    def cleared(self, table: Any, column: int) -> Any:
        """The table with the largest entry of the column, from its diagonal row on, as pivot, and
        the rest of the column zero.
        """
        places = np.arange(table.shape[2])
        pivot = column + np.abs(table[column:, column]).argmax(axis=0)  # the first of equals
        source, other = table[pivot, :, places].T, table[column].copy()
        table[pivot, :, places] = other.T
        dead = np.abs(source[column]) < NOTHING
        self.unsettled |= dead
        source = source / np.where(dead, 1.0, source[column])
        multiples = table[:, column][:, None]
        table = np.where(multiples != 0, table - multiples * source, table)
        table[column] = source
        return table


def _in_doubles(found: Any) -> Any:
    """Values found one by one, as an array of doubles; a single value stays a double."""
    return found.astype(float) if isinstance(found, np.ndarray) else found


def _plain(result: Any) -> Any:
    """The same, but a zero-dimensional array as a plain number: it holds for all instances."""
    return result[()]
