"""The bars that leave a point of their body, and what they leave open of the ground there."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

from kinegrade.figure.mechanism.straight_parts import (
    Bar,
    Part,
    Rod,
    find_half_width,
    list_ways,
)
from kinegrade.figure.plane import NEAR, length, unit
from kinegrade.figure.scene import BOLD
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector

OPENING = 0.8  # millimetres of the ground that are open on either side of a bar through it
Leaving = tuple[Vector, float]  # the unit vector of a bar that leaves a point, and half its width


def list_leaving(mechanism: Mechanism, parts: Sequence[Part], name: str) -> Iterator[Leaving]:
    """The bars of a point's bodies that leave it; of a plate, the directions to its points."""
    points = mechanism.points
    at = points[name]
    for body in mechanism.bodies:
        if name not in body.points:
            continue
        bars = [part for part in parts if isinstance(part, Bar | Rod) and part.body == body.name]
        for bar in bars:
            yield from ((unit(way), find_half_width(bar)) for way in list_ways(bar, at))
        if not bars:
            steps = (points[other] - at for other in body.points)
            yield from ((unit(step), BOLD.width / 2) for step in steps if length(step) > NEAR)


def has_bar_through(leaving: Sequence[Leaving], along: Vector) -> bool:
    """Whether a bar across a guide runs on through the block."""
    ways = [way for way, _ in leaving if abs(way.cross(along)) > NEAR]
    return any(length(one + other) < NEAR for one, other in combinations(ways, 2))


def find_room_before(bar: Leaving, along: Vector, side: Vector, level: float) -> float:
    """How far from its point, along the ground, there is room before a bar that leaves."""
    way, half = bar
    aside = level * abs(way.dot(along))
    return float((aside - half - OPENING) / abs(way.dot(side)))


def find_opening(bar: Leaving, along: Vector, side: Vector, level: float) -> float:
    """How far from its point, along the ground, the opening reaches through which a bar leaves."""
    way, half = bar
    aside = level * abs(way.dot(along))
    return float((aside + half + OPENING) / abs(way.dot(side)))
