"""The pad of a student who writes down every value, and how far the results may be off for it.

Each value that is written to d significant figures is off by at most half a unit of the d-th; to
first order a result is off by at most the sum of these errors, each times the result's derivative
with respect to that value. The derivatives are found by one sweep back over the pad (S. Linnainmaa,
Taylor expansion of the accumulated rounding error, BIT 16, 1976; F. L. Bauer, Computational graphs
and rounding error, SIAM J. Numer. Anal. 11, 1974). The same sweep finds the largest term of a
result: a value times the derivative with respect to it is what of the result stands or falls with
that value.

Numbers are arrays with an entry for each instance; `noting` is the arithmetic of such numbers.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

Doubles: TypeAlias = NDArray[np.float64]
Flags: TypeAlias = NDArray[np.bool_]
DEGREE = np.pi / 180
NOTHING = 1e-12  # as `Floats` has it: what is smaller is zero
_WHOLE = 1e-9  # of a unit: what is nearer to a number of d figures is that number


@dataclass(frozen=True)
class Use:
    """A value on the pad from which another one is found, by its place, and the derivative of the
    other one with respect to it.
    """

    place: int
    derivative: Doubles | float


@dataclass(frozen=True)
class Entry:
    """What was used for a value, how far writing it down puts it off at most, and its size as a
    term; an exact angle is none.
    """

    uses: tuple[Use, ...]
    error: Doubles
    size: Doubles


@dataclass(frozen=True)
class Swept:
    """How far results may be off, and their largest terms: a row for each result, an entry for each
    instance.
    """

    errors: Doubles
    terms: Doubles


@dataclass(frozen=True)
class Pad:
    """Values written one after the other to `figures` significant figures, for `count` instances;
    an angle is written in degrees.
    """

    figures: int
    count: int
    entries: list[Entry] = field(default_factory=list)

    def write(
        self,
        value: Doubles,
        uses: Sequence[Use] = (),
        *,
        exact: Flags | bool = True,
        copied: Flags | bool = False,
        angle: bool = False,
    ) -> Noted:
        """A value written down. Nothing is lost where it was `exact` and has no more figures, and
        where it is `copied`: it stands on the pad already, with another sign perhaps.
        """
        shown = value / DEGREE if angle else value
        unit = self.find_unit(shown)
        error = 0.5 * unit * (DEGREE if angle else 1.0)
        whole = np.abs(shown - np.rint(shown / unit) * unit) <= _WHOLE * unit
        zero = np.abs(shown) < NOTHING
        sure = exact & (whole | zero)
        size = np.where(sure & angle, 0.0, np.abs(value))
        self.entries.append(Entry(tuple(uses), np.where(sure | zero | copied, 0.0, error), size))
        return Noted(self, len(self.entries) - 1, value, sure, angle)

    def find_unit(self, shown: Doubles) -> Doubles:
        """The unit of the last figure; a number next below a power of ten may, with the errors
        before it, come out above.
        """
        size = np.abs(shown) * (1 + 2 * 10.0 ** (1 - self.figures))
        exponent = np.floor(np.log10(np.where(size < NOTHING, 1.0, size)))
        unit: Doubles = 10.0 ** (exponent + 1 - self.figures)
        return unit

    def sweep_back(self, results: Sequence[Noted]) -> Swept:
        """How far each result may be off, and its largest term: at least the result itself."""
        slopes: dict[int, Doubles] = {}
        total, largest = (np.zeros((len(results), self.count)) for _ in range(2))
        for row, result in enumerate(results):
            start = np.zeros((len(results), self.count))
            start[row] = 1.0
            slopes[result.place] = slopes.get(result.place, 0.0) + start
            largest[row] = np.nan_to_num(np.abs(result.value))
        for place in range(len(self.entries) - 1, -1, -1):
            slope = slopes.pop(place, None)
            if slope is None:
                continue
            entry = self.entries[place]
            steepness = np.abs(slope)
            total += steepness * entry.error
            largest = np.fmax(largest, steepness * entry.size)
            for use in entry.uses:
                slopes[use.place] = slopes.get(use.place, 0.0) + slope * use.derivative
        return Swept(total, largest)


@dataclass(frozen=True, eq=False)
class Noted:
    """A value on a pad, by its place there; what is computed with it is written down too.

    `exact` where no value before it was rounded; an `angle` is in radians. Whatever is not `Noted`
    is a constant, of which nothing is written.
    """

    pad: Pad
    place: int
    value: Doubles
    exact: Flags
    angle: bool = False

    __array_ufunc__ = None  # an array leaves operations with such numbers to them

    def __add__(self, other: Any) -> Noted:
        value, uses, exact, angle = _take(other, 1.0)
        if not uses and _is_all(value, 0):
            return self
        return self.pad.write(
            self.value + value,
            (Use(self.place, 1.0), *uses),
            exact=self.exact & exact,
            copied=_is_sure(self, 0) | _is_sure(other, 0),
            angle=self.angle or angle,
        )

    __radd__ = __add__

    def __neg__(self) -> Noted:
        return self._copy(-self.value, -1.0)

    def __abs__(self) -> Noted:
        return self._copy(np.abs(self.value), np.sign(self.value))

    def __sub__(self, other: Any) -> Noted:
        return self.__add__(-other)

    def __rsub__(self, other: Any) -> Noted:
        return self.__neg__().__add__(other)

    def __mul__(self, other: Any) -> Any:
        if isinstance(other, tuple):
            return NotImplemented  # a vector's components are multiplied, each by itself
        value, uses, exact, _ = _take(other, self.value)
        if not uses and _is_all(value, 0):
            return 0.0
        if not uses and _is_all(np.abs(value), 1):
            return self if _is_all(value, 1) else -self
        return self.pad.write(
            self.value * value,
            (Use(self.place, value), *uses),
            exact=self.exact & exact,
            copied=_is_sure(self, 1) | _is_sure(other, 1),
            angle=self.angle and not uses,  # a length times an angle is a length
        )

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Any:
        if not isinstance(other, Noted):
            return self * (1 / other)
        value = self.value / other.value
        return self.pad.write(
            value,
            (Use(self.place, 1 / other.value), Use(other.place, -value / other.value)),
            exact=self.exact & other.exact,
            copied=_is_sure(other, 1),
        )

    def __rtruediv__(self, other: Any) -> Noted:
        value = other / self.value
        return self.pad.write(value, (Use(self.place, -value / self.value),), exact=self.exact)

    def __pow__(self, power: int) -> Any:
        result: Any = 1.0
        for _ in range(power):
            result = self * result
        return result

    def __lt__(self, other: Any) -> Flags:
        below: Flags = self.value < _take(other, 0.0)[0]
        return below

    def __gt__(self, other: Any) -> Flags:
        above: Flags = self.value > _take(other, 0.0)[0]
        return above

    def __float__(self) -> float:
        return float(self.value.flat[0])

    def convert_angle(self, size: float) -> Noted:
        """The angle, found in degrees, as it is handed in in a unit of so many radians: what has
        few figures in degrees has endless ones there, and is rounded once more.
        """
        shown = self.pad.write(self.value / size, (Use(self.place, 1 / size),), exact=False)
        return self.pad.write(self.value, (Use(shown.place, size),), copied=True)

    def _copy(self, value: Doubles, derivative: Doubles | float) -> Noted:
        """The value with another sign."""
        uses = (Use(self.place, derivative),)
        return self.pad.write(value, uses, exact=self.exact, copied=True, angle=self.angle)


def _take(
    number: Any, derivative: Doubles | float
) -> tuple[Any, tuple[Use, ...], Flags | bool, bool]:
    """The value of an operand, its use with that derivative, whether it is exact, and an angle."""
    if isinstance(number, Noted):
        return number.value, (Use(number.place, derivative),), number.exact, number.angle
    return number, (), True, False


def _is_all(value: Any, number: int) -> bool:
    return bool(np.all(value == number))


def _is_sure(number: Any, size: int) -> Flags | bool:
    """Where an operand surely has that size: nothing new is written by adding 0 or multiplying by
    1.
    """
    value, _, exact, _ = _take(number, 0.0)
    sure: Flags = (np.abs(np.abs(value) - size) < NOTHING) & exact
    return sure
