"""The mechanism's own scale: the largest length, velocity, rotation ... that occurs, by dimension.

Where an exact answer is zero, a relative tolerance would leave no room at all; the room is then a share of the
largest quantity of the same kind in the mechanism.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from math import hypot

from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.vector import Vector
from kinegrade.units import Unit


def scale(motion: Motion, unit: Unit) -> float:
    """The largest size of a quantity of that dimension in the mechanism, in `unit`; angles: a radian; else 1."""
    if unit.time == 0 and unit.length == 0:
        return 57.3 if unit.degrees else 1.0
    if unit.time == 0:
        sizes = lengths(motion)
    elif unit.length == 0:
        sizes = turning(motion, unit.time)
    else:
        sizes = moving(motion, unit.time)
    return max(sizes, default=0.0) / float(unit.factor)


def lengths(motion: Motion) -> Iterator[float]:
    """Distances between points, m."""
    for first, second in combinations(motion.points.values(), 2):
        yield size(second - first)


def turning(motion: Motion, time: int) -> Iterator[float]:
    """Angular velocities, or angular accelerations with the squares of the angular velocities beside them."""
    for body in motion.frames.mechanism.bodies:
        if not body.particle:
            rate = abs(float(motion.omega(body.name)))
            yield rate if time == -1 else max(rate * rate, abs(float(motion.alpha(body.name))))


def moving(motion: Motion, time: int) -> Iterator[float]:
    """Speeds or accelerations of all marked points, as points of every body that has them."""
    for body in motion.frames.mechanism.bodies:
        for point in body.points:
            if time == -1:
                yield size(motion.velocity(point, body.name))
            else:
                yield size(motion.acceleration(point, body.name))


def size(vector: Vector) -> float:
    """The length of a vector as a float."""
    return hypot(float(vector.x), float(vector.y))
