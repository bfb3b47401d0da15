"""Functions of time to the second order, exactly differentiated."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Union

import numpy

Coefficient = Union[float, "numpy.ndarray"]
Operand = Union["Series", float]


@dataclass(frozen=True)
class Series:
    """value + first t + second t**2; coefficients may be arrays, for many motions at once."""

    value: Coefficient
    first: Coefficient = 0.0
    second: Coefficient = 0.0

    def __add__(self, other: Operand) -> Series:
        other = series(other)
        return Series(
            self.value + other.value, self.first + other.first, self.second + other.second
        )

    def __neg__(self) -> Series:
        return Series(-self.value, -self.first, -self.second)

    def __sub__(self, other: Operand) -> Series:
        return self + (-series(other))

    def __mul__(self, other: Operand) -> Series:
        other = series(other)
        return Series(
            self.value * other.value,
            self.value * other.first + self.first * other.value,
            self.value * other.second + self.first * other.first + self.second * other.value,
        )

    def __truediv__(self, other: Operand) -> Series:
        other = series(other)
        value = self.value / other.value
        first = (self.first - value * other.first) / other.value
        second = (self.second - value * other.second - first * other.first) / other.value
        return Series(value, first, second)

    __radd__ = __add__
    __rmul__ = __mul__

    def __rsub__(self, other: float) -> Series:
        return series(other) - self


def series(value: Operand) -> Series:
    """The value itself, or a constant function of time."""
    return value if isinstance(value, Series) else Series(value)


def through(inner: Series, value: Coefficient, slope: Coefficient, bend: Coefficient) -> Series:
    """f(inner) of a function f with that value and first and second derivative."""
    return Series(value, slope * inner.first, slope * inner.second + bend * inner.first**2 / 2)


def sine(angle: Series) -> Series:
    """The sine."""
    sin, cos = numpy.sin(angle.value), numpy.cos(angle.value)
    return through(angle, sin, cos, -sin)


def cosine(angle: Series) -> Series:
    """The cosine."""
    sin, cos = numpy.sin(angle.value), numpy.cos(angle.value)
    return through(angle, cos, -sin, -cos)


def root(square: Series) -> Series:
    """The square root."""
    value = numpy.sqrt(square.value)
    return through(square, value, 1 / (2 * value), -1 / (4 * value * square.value))


@dataclass(frozen=True)
class Vector:
    """A vector of the plane that changes with time."""

    x: Series
    y: Series

    def __add__(self, other: Vector) -> Vector:
        return Vector(self.x + other.x, self.y + other.y)

    def __sub__(self, other: Vector) -> Vector:
        return Vector(self.x - other.x, self.y - other.y)

    def dot(self, other: Vector) -> Series:
        """The scalar product."""
        return self.x * other.x + self.y * other.y

    def cross(self, other: Vector) -> Series:
        """Positive where the other vector points to the left of this one."""
        return self.x * other.y - self.y * other.x

    def length(self) -> Series:
        """The length."""
        return root(self.dot(self))


def turn_of(vector: Vector, start: complex) -> Series:
    """The angle, counter-clockwise, from a direction that does not change to the vector."""
    fixed = Vector(Series(start.real), Series(start.imag))
    value = numpy.arctan2(fixed.cross(vector).value, fixed.dot(vector).value)
    now = Vector(Series(vector.x.value), Series(vector.y.value))
    return through(now.cross(vector) / now.dot(vector), value, 1.0, 0.0)
