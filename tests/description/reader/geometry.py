"""Lines and circles of the plane; points and vectors are complex numbers."""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Line:
    """A straight line: one of its points and its direction, of length one."""

    point: complex
    direction: complex


@dataclass(frozen=True)
class Circle:
    """A circle: its centre and its radius."""

    centre: complex
    radius: float


Curve = Line | Circle


class NoCommonPoint(ValueError):
    """Two curves that do not meet."""


def dot(first: complex, second: complex) -> float:
    """The scalar product of two vectors."""
    return (first.conjugate() * second).real


def cross(first: complex, second: complex) -> float:
    """Positive where the second vector points to the left of the first one."""
    return (first.conjugate() * second).imag


def unit(vector: complex) -> complex:
    """The vector of length one in the same direction."""
    if vector == 0:
        raise ZeroDivisionError("a vector of no length has no direction")
    return vector / abs(vector)


def line_between(start: complex, end: complex) -> Line:
    """The line through two points, directed from the first to the second."""
    return Line(start, unit(end - start))


def line_towards(point: complex, angle: float) -> Line:
    """The line through a point in the direction of an angle."""
    return Line(point, cmath.rect(1, angle))


def polar(point: complex, distance: float, angle: float) -> complex:
    """The point at a distance in the direction of an angle."""
    return point + cmath.rect(distance, angle)


def toward(start: complex, end: complex, distance: float) -> complex:
    """The point at a distance from the first one, towards the second one."""
    return start + distance * unit(end - start)


def foot(point: complex, line: Line) -> complex:
    """The foot of the perpendicular from a point to a line."""
    return line.point + line.direction * dot(line.direction, point - line.point)


def offset(point: complex, line: Line) -> float:
    """The distance of a point from a line, positive on the left of it."""
    return cross(line.direction, point - line.point)


def crossing(first: Line, second: Line) -> complex:
    """The common point of two lines."""
    slope = cross(first.direction, second.direction)
    if abs(slope) < 1e-12:
        raise NoCommonPoint("the lines are parallel")
    along = cross(second.point - first.point, second.direction) / slope
    return first.point + along * first.direction


def common_points(first: Curve, second: Curve) -> list[complex]:
    """The common points of two curves: of two circles or a line and a circle, both."""
    if isinstance(first, Line):
        if isinstance(second, Line):
            return [crossing(first, second)]
        return ends_of_chord(first, second)
    if isinstance(second, Line):
        return ends_of_chord(second, first)
    return ends_of_chord(radical_line(first, second), second)


def ends_of_chord(line: Line, circle: Circle) -> list[complex]:
    """The two points in which a line meets a circle, in the order of its direction."""
    nearest = foot(circle.centre, line)
    rest = circle.radius**2 - abs(nearest - circle.centre) ** 2
    if rest < -1e-12 * circle.radius**2:
        raise NoCommonPoint("the line passes by the circle")
    half = math.sqrt(max(rest, 0.0)) * line.direction
    return [nearest - half, nearest + half]


def radical_line(first: Circle, second: Circle) -> Line:
    """The line on which the common points of two circles lie."""
    between = second.centre - first.centre
    if between == 0:
        raise NoCommonPoint("the circles have the same centre")
    share = (abs(between) ** 2 + first.radius**2 - second.radius**2) / (2 * abs(between) ** 2)
    return Line(first.centre + share * between, unit(between) * 1j)


def extreme(points: list[complex], side: str) -> complex:
    """The one of the points that is farthest `right`, `left`, `upper` or `lower`."""
    ahead = {"right": 1, "left": -1, "upper": 1j, "lower": -1j}[side]
    return max(points, key=lambda point: dot(ahead, point))


def beside(points: list[complex], start: complex, end: complex, side: str) -> complex:
    """The one of the points on the `left` or `right` of who looks from start to end."""
    sign = {"left": 1, "right": -1}[side]
    return max(points, key=lambda point: sign * cross(end - start, point - start))
