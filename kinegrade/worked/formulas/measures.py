"""Lengths and directions of vectors, for what is said about them."""

from __future__ import annotations

from math import atan2, degrees, hypot
from typing import Any

from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.angle import Angle
from kinegrade.numbers.balls import Undecided
from kinegrade.numbers.refusals import Inexact

NEGLIGIBLE = 1e-12  # in SI: less than this is what rounding leaves of zero


def length(vector: Vector, arithmetic: Any) -> Any:
    """The length of a vector: exact where the field holds it, else a double."""
    try:
        return arithmetic.fork().magnitude(vector.x, vector.y)
    except (Inexact, Undecided, ValueError):
        return size(vector)


def double(number: Any) -> float:
    """A number as a double; zero where only rounding has left anything."""
    value = float(number)
    return 0.0 if abs(value) < NEGLIGIBLE else value


def measure_angle(angle: Any) -> float:
    """An angle in radians as a double."""
    return double(angle.ball() if isinstance(angle, Angle) else angle)


def size(vector: Vector) -> float:
    """The length of a vector as a double."""
    return hypot(float(vector.x), float(vector.y))


def is_zero(vector: Vector) -> bool:
    """Whether a vector has no direction."""
    return not double(vector.x) and not double(vector.y)


def bearing(vector: Vector) -> float:
    """The direction of a vector in degrees from +x, counter-clockwise, from 0 to below 360."""
    return tidy(degrees(atan2(float(vector.y), float(vector.x)))) % 360


def tidy(angle: float) -> float:
    """An angle in degrees without the rounding errors of a double."""
    whole = round(angle, 6)
    return whole if abs(angle - whole) < 1e-7 else angle


def find_sign(number: Any) -> int:
    """1 for a positive number, else -1."""
    return 1 if double(number) > 0 else -1
