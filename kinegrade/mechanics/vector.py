"""Plane vectors over any arithmetic: field elements, balls, floats or arrays (x right, y up).

Everything in `mechanics` is written with these few operations, so one formula serves all
arithmetics.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, Literal, NamedTuple, TypeAlias

from kinegrade.numbers.number import Arithmetic, Number

# A `Number` of the arithmetic that is worked in. Who draws has a mechanism in doubles and takes
# components for doubles, which no protocol of all numbers would allow
Component = Any
AxisName: TypeAlias = Literal["x", "y"]

# What the constructor of a named tuple calls: half the time, in what is done most often
_make = tuple.__new__


class Vector(NamedTuple):
    """A vector or a point of the plane; components in any one arithmetic."""

    x: Component
    y: Component

    def __add__(self, other: Vector) -> Vector:  # type: ignore[override]
        return _make(Vector, (self.x + other.x, self.y + other.y))

    def __sub__(self, other: Vector) -> Vector:
        return _make(Vector, (self.x - other.x, self.y - other.y))

    def __neg__(self) -> Vector:
        return _make(Vector, (-self.x, -self.y))

    def __mul__(self, factor: Number) -> Vector:  # type: ignore[override]
        if isinstance(factor, Vector):
            return NotImplemented
        return _make(Vector, (self.x * factor, self.y * factor))

    def __rmul__(self, factor: Number) -> Vector:  # type: ignore[override]
        return self * factor

    def __truediv__(self, divisor: Number) -> Vector:
        return _make(Vector, (self.x / divisor, self.y / divisor))

    def dot(self, other: Vector) -> Component:
        """Scalar product."""
        return self.x * other.x + self.y * other.y

    def cross(self, other: Vector) -> Component:
        """The out-of-plane component of the vector product, counter-clockwise positive."""
        return self.x * other.y - self.y * other.x

    def turned(self) -> Vector:
        """The vector turned by 90 degrees counter-clockwise (k x self)."""
        return _make(Vector, (-self.y, self.x))

    def squared(self) -> Component:
        """Square of the length."""
        return self.x * self.x + self.y * self.y

    def magnitude(self, arithmetic: Arithmetic) -> Component:
        """The length, in the unit of the components."""
        return arithmetic.magnitude(self.x, self.y)

    def map(self, number: Callable[[Number], Number]) -> Vector:
        """The vector with `number` applied to its components."""
        return _make(Vector, (number(self.x), number(self.y)))


# An array times a vector is a vector, no array of two rows. Outside, as it is no component
Vector.__array_ufunc__ = None  # type: ignore[attr-defined]


def add_vectors(vectors: Iterable[Vector]) -> Vector:
    """The sum of vectors, zero if there are none."""
    result = Vector(0, 0)
    for vector in vectors:
        result = result + vector
    return result
