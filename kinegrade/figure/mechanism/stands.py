"""Supports on the ground: the triangles of fixed pins, and the wedges on which the edges of plates
rest.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import pi

from kinegrade.figure.joints.symbol import find_fixed_pins
from kinegrade.figure.mechanism.anatomy import Anatomy
from kinegrade.figure.mechanism.straight_parts import Bar, Part, Rod
from kinegrade.figure.plane import SIDE_VECTORS, angle_of, foot, length, shorter_way
from kinegrade.figure.scene import Primitive
from kinegrade.figure.symbols import STAND, TALL_STAND, draw_knife_edge, draw_pivot
from kinegrade.mechanics.joints import GROUND, Line
from kinegrade.mechanics.vector import Vector

# Radians between a stand's axis and a bar at which the bar is clear of its hatching
_STAND_ROOM = 0.85
_INSIDE = 8.5  # millimetres of radius at which a stand is clear of the hatching of a fixed wheel


def draw_stands(anatomy: Anatomy) -> Iterator[Primitive]:
    """The knife edges, then the stands of fixed pins; a pin at the centre of a fixed wheel without
    room for one needs none.
    """
    at = anatomy.mechanism.points
    for name, side in anatomy.knife_edges.items():
        yield from draw_knife_edge(at[name], side)
    wheels = {
        rim.centre
        for rim in anatomy.rims
        if rim.body == GROUND and not rim.ring and rim.radius < _INSIDE
    }
    for name in find_fixed_pins(anatomy.symbols):
        if name not in wheels and name not in anatomy.knife_edges:
            side = _find_free_side(at[name], anatomy.parts)
            yield from draw_pivot(at[name], side, _choose_height(at[name], anatomy))


def _choose_height(at: Vector, anatomy: Anatomy) -> float:
    """Taller where a sleeve turns about the pin."""
    turning = any(length(sleeve.point - at) < 1.0 for sleeve in anatomy.sleeves)
    return TALL_STAND if turning else STAND


def _find_free_side(at: Vector, parts: Sequence[Part]) -> Vector:
    """Down, unless a bar goes there; then the side with the widest room."""
    leaving = []
    for part in parts:
        if isinstance(part, Bar | Rod):
            near = foot(at, _find_axis(part))
            if length(near - at) < 1.0:
                leaving += [
                    angle_of(end - at) for end in (part.start, part.end) if length(end - at) > 1.0
                ]

    def room(side: Vector) -> float:
        return min((abs(shorter_way(angle - angle_of(side))) for angle in leaving), default=pi)

    sides = [SIDE_VECTORS[name] for name in ("down", "left", "right", "up")]
    return (
        sides[0]
        if room(sides[0]) > _STAND_ROOM
        else max(sides, key=lambda side: round(room(side), 6))
    )


def _find_axis(part: Bar | Rod) -> Line:
    return Line(part.start, part.end - part.start)
