"""Supports on the ground: the triangles of fixed pins, and the wedges on which the edges of plates
rest.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import pi

from kinegrade.figure import symbols
from kinegrade.figure.mechanism.bars import Bar, Rod, SlottedDisc
from kinegrade.figure.mechanism.plates import Plate, find_outward_direction
from kinegrade.figure.mechanism.rims import Rim
from kinegrade.figure.mechanism.tracks import find_fixed_pins
from kinegrade.figure.plane import SIDE_VECTORS, angle_of, foot, length, shorter_way, unit
from kinegrade.figure.scene import Primitive
from kinegrade.mechanics.joints import GROUND, Line, Slide
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector

_STAND_ROOM = (
    0.85  # radians between a stand's axis and a bar at which the bar is clear of its hatching
)


def knife_edges(
    mechanism: Mechanism, parts: tuple[Bar | Plate | SlottedDisc | Rod, ...]
) -> dict[str, Vector]:
    """The fixed points on which the edge of a plate rests, each with the direction that leaves the
    plate.
    """
    plates = {part.body: part for part in parts if isinstance(part, Plate)}
    found = {}
    for joint in mechanism.joints:
        if isinstance(joint, Slide) and joint.body == GROUND and joint.of in plates:
            side = find_outward_direction(plates[joint.of], joint.line)
            if side is not None:
                found[joint.point] = unit(side)
    return found


def stands(
    mechanism: Mechanism,
    found: tuple[Rim, ...],
    parts: tuple[Bar | Plate | SlottedDisc | Rod, ...],
    knives: set[str],
    sleeves: list[tuple[Vector, Vector]],
) -> Iterator[Primitive]:
    """The stands of fixed pins; a pin at the centre of a fixed wheel needs none."""
    standing = {rim.centre for rim in found if rim.body == GROUND and not rim.ring}
    for name in find_fixed_pins(mechanism):
        if name not in standing | knives:
            at = mechanism.points[name]
            turning = any(length(place - at) < 1.0 for place, _ in sleeves)
            height = symbols.TALL_STAND if turning else symbols.STAND
            yield from symbols.draw_pivot(at, _find_free_side(at, parts), height)


def _find_free_side(at: Vector, parts: tuple[Bar | Plate | SlottedDisc | Rod, ...]) -> Vector:
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
