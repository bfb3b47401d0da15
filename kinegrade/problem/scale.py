"""The scale of a mechanism: the largest length, velocity, rotation ... that occurs, by dimension.

Where an exact answer is zero, a relative tolerance would leave no room at all; the room is then a
share of the largest quantity of the same kind in the mechanism.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from typing import Any

from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.doubles import convert_number
from kinegrade.numbers.floats import Floats
from kinegrade.numbers.units import Unit


def find_scale(motion: Motion, unit: Unit) -> float:
    """The largest size of a quantity of that dimension in the mechanism, in `unit`; angles: a
    radian; else 1.
    """
    return float(max(list_sizes(motion, unit), default=0.0))


def list_sizes(motion: Motion, unit: Unit) -> Iterator[Any]:
    """The sizes of all quantities of that dimension in the mechanism, in `unit`; arrays for a
    motion in arrays.
    """
    size = Floats().scale(unit.scale)
    if unit.time == 0 and unit.length == 0:
        yield 57.3 if unit.degrees else 1.0
    elif unit.time == 0:
        yield from (length / size for length in _list_lengths(motion))
    else:
        found = _list_moving(motion, unit.time) if unit.length else _list_turning(motion, unit.time)
        yield from (rate / size for rate in found)


def _list_lengths(motion: Motion) -> Iterator[Any]:
    """Distances between points, m."""
    for first, second in combinations(motion.points.values(), 2):
        yield _measure_size(second - first)


def _list_turning(motion: Motion, time: int) -> Iterator[Any]:
    """Angular velocities, or angular accelerations with the squares of the angular velocities
    beside them.
    """
    for body in motion.frames.mechanism.bodies:
        if not body.particle:
            rate = abs(convert_number(motion.omega(body.name)))
            if time == -1:
                yield rate
            else:
                yield from (rate * rate, abs(convert_number(motion.alpha(body.name))))


def _list_moving(motion: Motion, time: int) -> Iterator[Any]:
    """Speeds or accelerations of all marked points, as points of every body that has them."""
    for body in motion.frames.mechanism.bodies:
        for point in body.points:
            if time == -1:
                yield _measure_size(motion.velocity(point, body.name))
            else:
                yield _measure_size(motion.acceleration(point, body.name))


def _measure_size(vector: Vector) -> Any:
    """The length of a vector in doubles."""
    return abs(convert_number(vector.x) + 1j * convert_number(vector.y))
