"""Plane vectors over any arithmetic: field elements, balls, floats or arrays (x right, y up).

Everything in `mechanics` is written with these few operations, so one formula serves all
arithmetics.
"""

from __future__ import annotations

from typing import Any, NamedTuple


class Vector(NamedTuple):
    """A vector or a point of the plane; components in any one arithmetic."""

    x: Any
    y: Any

    def __add__(self, other: Vector) -> Vector:  # type: ignore[override]
        return Vector(self.x + other.x, self.y + other.y)

    def __sub__(self, other: Vector) -> Vector:
        return Vector(self.x - other.x, self.y - other.y)

    def __neg__(self) -> Vector:
        return Vector(-self.x, -self.y)

    def __mul__(self, factor: Any) -> Vector:
        if isinstance(factor, Vector):
            return NotImplemented
        return Vector(self.x * factor, self.y * factor)

    def __rmul__(self, factor: Any) -> Vector:
        return self * factor  # type: ignore[no-any-return]

    def __truediv__(self, divisor: Any) -> Vector:
        return Vector(self.x / divisor, self.y / divisor)

    def dot(self, other: Vector) -> Any:
        """Scalar product."""
        return self.x * other.x + self.y * other.y

    def cross(self, other: Vector) -> Any:
        """The out-of-plane component of the vector product, counter-clockwise positive."""
        return self.x * other.y - self.y * other.x

    def turned(self) -> Vector:
        """The vector turned by 90 degrees counter-clockwise (k x self)."""
        return Vector(-self.y, self.x)

    def squared(self) -> Any:
        """Square of the length."""
        return self.x * self.x + self.y * self.y
