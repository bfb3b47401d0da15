"""Plane geometry of the drawing, in floats: unit vectors, angles, feet, hulls (mechanics is
exact).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import atan2, cos, hypot, pi, sin

from kinegrade.mechanics.joints import Line
from kinegrade.mechanics.vector import Vector

NEAR = 1e-6  # millimetres: far below what a printer shows, far above rounding of floats
SIDE_VECTORS = {
    "right": Vector(1.0, 0.0),
    "up": Vector(0.0, 1.0),
    "left": Vector(-1.0, 0.0),
    "down": Vector(0.0, -1.0),
}


def length(vector: Vector) -> float:
    """Length of a vector."""
    return hypot(vector.x, vector.y)


def unit(vector: Vector) -> Vector:
    """The direction of a vector; a zero vector counts as pointing right."""
    size = length(vector)
    return vector / size if size > NEAR else Vector(1.0, 0.0)


def polar(angle: float, radius: float = 1.0) -> Vector:
    """The vector with that direction (radians, counter-clockwise from right) and length."""
    return Vector(radius * cos(angle), radius * sin(angle))


def angle_of(vector: Vector) -> float:
    """Direction of a vector in radians, counter-clockwise from right, in (-pi, pi]."""
    return atan2(vector.y, vector.x)


def shorter_way(sweep: float) -> float:
    """The same rotation in (-pi, pi]."""
    turn = sweep % (2 * pi)
    return turn - 2 * pi if turn > pi else turn


def foot(point: Vector, line: Line) -> Vector:
    """The point of the line nearest to `point`."""
    along = unit(line.direction)
    nearest: Vector = line.point + along * (point - line.point).dot(along)
    return nearest


def nearest_of(point: Vector, start: Vector, end: Vector) -> Vector:
    """The point of the segment from `start` to `end` nearest to `point`."""
    step = end - start
    size = step.squared()
    share = (point - start).dot(step) / size if size > 0 else 0.0
    return start + step * min(1.0, max(0.0, share))


def parts(start: Vector, end: Vector, one: Vector, other: Vector) -> bool:
    """Whether the segment from `start` to `end` passes between two points."""
    return _lie_on_both_sides(one, other, start, end) and _lie_on_both_sides(start, end, one, other)


def _lie_on_both_sides(start: Vector, end: Vector, one: Vector, other: Vector) -> bool:
    """Whether two points lie on both sides of a line; in plain numbers, as it is asked often."""
    (x, y), (to_x, to_y) = start, end
    along, rise = to_x - x, to_y - y
    levels = [along * (at.y - y) - rise * (at.x - x) for at in (one, other)]
    return bool(levels[0] * levels[1] < 0)


def on_line(point: Vector, line: Line) -> bool:
    """Whether the point lies on the line."""
    return length(point - foot(point, line)) < NEAR * (1 + length(point))


def same_line(one: Line, other: Line) -> bool:
    """Whether two lines coincide."""
    return (
        on_line(other.point, one) and abs(unit(one.direction).cross(unit(other.direction))) < NEAR
    )


def meet(one: Line, other: Line) -> Vector:
    """Where two lines cross, which must not be parallel."""
    ahead = (other.point - one.point).cross(other.direction) / one.direction.cross(other.direction)
    crossing: Vector = one.point + one.direction * ahead
    return crossing


def collinear(points: Sequence[Vector]) -> bool:
    """Whether all points lie on one straight line."""
    far = max(points, key=lambda point: length(point - points[0]))
    return all(on_line(point, Line(points[0], far - points[0])) for point in points)


def mean(points: Iterable[Vector]) -> Vector:
    """The centroid of points of equal weight; the origin when there are none."""
    found = list(points)
    return sum(found, Vector(0.0, 0.0)) / len(found) if found else Vector(0.0, 0.0)


def hull(points: Iterable[Vector]) -> tuple[Vector, ...]:
    """The convex hull, counter-clockwise (Andrew's monotone chain)."""
    ordered = sorted(set(points))
    return tuple(_make_chain(ordered)[:-1] + _make_chain(ordered[::-1])[:-1])


def _make_chain(ordered: list[Vector]) -> list[Vector]:
    chain: list[Vector] = []
    for point in ordered:
        while len(chain) > 1 and (chain[-1] - chain[-2]).cross(point - chain[-1]) <= 0:
            chain.pop()
        chain.append(point)
    return chain
