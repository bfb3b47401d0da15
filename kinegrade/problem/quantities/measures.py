"""What a quantity may take of vectors and circles: magnitudes, components, angles, radii.

The entry `words.function-NAME` of the catalogues says what each gives.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from msgspec import Struct

from kinegrade.mechanics.geometry import Round
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic
from kinegrade.problem.kinds.dimension import LENGTH, NUMBER
from kinegrade.problem.kinds.signatures import (
    Signature,
    give_first,
    give_scalar,
    give_vector,
    make_signature,
)


class Measure(Struct, frozen=True):
    """A function of vectors or of a circle: what it takes and gives, and how it is worked out in an
    arithmetic.
    """

    signature: Signature
    read: Callable[..., Any]


def _measure_magnitude(arithmetic: Arithmetic, vector: Vector) -> Any:
    """Length of a vector."""
    return vector.magnitude(arithmetic)


def _measure_along(arithmetic: Arithmetic, vector: Vector, direction: Vector) -> Any:
    """Component along a direction given by any vector."""
    return vector.dot(direction) / _measure_magnitude(arithmetic, direction)


def _measure_angle(arithmetic: Arithmetic, first: Vector, second: Vector) -> Any:
    """Angle from the first vector to the second, counter-clockwise, in (-pi, pi]."""
    return arithmetic.arctangent(first.cross(second), first.dot(second))


def _measure_between(arithmetic: Arithmetic, first: Vector, second: Vector) -> Any:
    """Angle between two vectors, 0 to pi."""
    return arithmetic.arctangent(abs(first.cross(second)), first.dot(second))


def _measure_radius(arithmetic: Arithmetic, circle: Round) -> Any:
    return circle.radius


def _measure_centre(arithmetic: Arithmetic, circle: Round) -> Vector:
    return circle.centre


MEASURES: Mapping[str, Measure] = {
    "magnitude": Measure(
        make_signature("VECTOR", gives=give_first, example="magnitude(velocity(B))"),
        _measure_magnitude,
    ),
    "along": Measure(
        make_signature("VECTOR", "VECTOR", gives=give_first, example="along(velocity(B), B - A)"),
        _measure_along,
    ),
    "angle": Measure(
        make_signature(
            "VECTOR", "VECTOR", gives=give_scalar(NUMBER), example="angle(velocity(A), velocity(B))"
        ),
        _measure_angle,
    ),
    "between": Measure(
        make_signature(
            "VECTOR", "VECTOR", gives=give_scalar(NUMBER), example="between(velocity(A), B - A)"
        ),
        _measure_between,
    ),
    "radius": Measure(
        make_signature(
            "CIRCLE", gives=give_scalar(LENGTH), example="radius(circle_of_poles(AB, phi))"
        ),
        _measure_radius,
    ),
    "centre": Measure(
        make_signature(
            "CIRCLE", gives=give_vector(LENGTH), example="centre(circle_of_poles(AB, phi))"
        ),
        _measure_centre,
    ),
}
