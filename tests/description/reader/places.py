"""What sentences tell of positions: constructions, equations, and on which side a point is."""

from __future__ import annotations

import math
from dataclasses import dataclass

from tests.description.reader.deferred import Deferred, combined, position
from tests.description.reader.geometry import cross, dot

WAYS: dict[str, complex] = {
    "above": 1j,
    "below": -1j,
    "to the right of": 1,
    "to the left of": -1,
    "to the right": 1,
    "to the left": -1,
}


@dataclass(frozen=True)
class Construction:
    """A point that can be drawn once the points it needs are there."""

    name: str
    place: Deferred[complex]


@dataclass(frozen=True)
class Equation:
    """A length that vanishes where the sentence is true."""

    gap: Deferred[float]


@dataclass(frozen=True)
class Side:
    """A length that is positive where the sentence is true."""

    margin: Deferred[float]


def apart(first: str, second: str) -> Deferred[complex]:
    """The vector from the first point to the second."""
    return combined(lambda a, b: b - a, position(first), position(second))


def of_length(length: Deferred[complex] | Deferred[float], number: Deferred[float]) -> Equation:
    """The vector or the component has that length."""
    return Equation(combined(lambda found, wanted: abs(found) - wanted, length, number))


def angle_between(
    first: Deferred[complex], second: Deferred[complex], angle: Deferred[float]
) -> list[object]:
    """The second vector is the first one turned counter-clockwise through the angle."""

    def leaning(start: complex, end: complex, turn: float) -> float:
        return cross(turned(start, turn), end) / size(start, end)

    def ahead(start: complex, end: complex, turn: float) -> float:
        return dot(turned(start, turn), end) / size(start, end)

    return [
        Equation(combined(leaning, first, second, angle)),
        Side(combined(ahead, first, second, angle)),
    ]


def unsigned_angle(
    first: Deferred[complex], second: Deferred[complex], angle: Deferred[float]
) -> list[object]:
    """The angle between the two vectors, whatever its sense."""

    def excess(start: complex, end: complex, turn: float) -> float:
        return (dot(start, end) - abs(start) * abs(end) * math.cos(turn)) / size(start, end)

    return [Equation(combined(excess, first, second, angle)), Side(combined(size, first, second))]


def turned(vector: complex, angle: float) -> complex:
    """The vector turned counter-clockwise."""
    return vector * complex(math.cos(angle), math.sin(angle))


def size(first: complex, second: complex) -> float:
    """The length of the greater of two vectors: it makes a product of both a length."""
    return min(abs(first), abs(second)) or 1e-300


def component(vector: Deferred[complex], direction: complex) -> Deferred[float]:
    """The component of the vector along a direction."""
    return combined(lambda v: dot(direction, v), vector)
