"""Bodies that move: where their points and lines get in a short time."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from tests.description.reader.geometry import Line
from tests.description.reader.series import Series, Vector, cosine, series, sine
from tests.description.reader.vocabulary import GROUND


@dataclass(frozen=True)
class Pose:
    """The displacement of the point at the origin, and the turn, from now on."""

    x: Series
    y: Series
    angle: Series

    def carry(self, place: complex) -> Vector:
        """The way of the point of the body that is now at the place."""
        turned = self.turn(place)
        return Vector(self.x + turned.x, self.y + turned.y)

    def turn(self, vector: complex) -> Vector:
        """What becomes of a vector fixed to the body."""
        sin, cos = sine(self.angle), cosine(self.angle)
        return Vector(cos * vector.real - sin * vector.imag, sin * vector.real + cos * vector.imag)

    def offset(self, point: Vector, line: Line) -> Series:
        """The distance of a point from a line of the body, positive on its left."""
        return self.turn(line.direction).cross(point - self.carry(line.point))

    def progress(self, point: Vector, line: Line) -> Series:
        """How far along a line of the body the foot of a point is."""
        return self.turn(line.direction).dot(point - self.carry(line.point))


STILL = Pose(series(0.0), series(0.0), series(0.0))


@dataclass(frozen=True)
class Motion:
    """The poses of all bodies; the ground does not move."""

    poses: Mapping[str, Pose]

    def of(self, body: str) -> Pose:
        """How the body moves."""
        return STILL if body == GROUND else self.poses[body]
