"""Supports on the ground: the triangles of fixed pins, and the wedges on which the edges of plates
rest.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import asin, atan2, hypot
from typing import assert_never

from kinegrade.errors import TemplateError
from kinegrade.figure.joints.symbol import Rim, find_fixed_pins
from kinegrade.figure.mechanism.anatomy import Anatomy
from kinegrade.figure.mechanism.plates import Plate
from kinegrade.figure.mechanism.straight_parts import (
    Bar,
    GenevaWheel,
    Part,
    Rod,
    SlottedDisc,
    find_half_width,
)
from kinegrade.figure.plane import (
    NEAR,
    SIDE_VECTORS,
    angle_of,
    length,
    nearest_of,
    shorter_way,
    unit,
)
from kinegrade.figure.scene import BOLD, Primitive
from kinegrade.figure.symbols.pins import (
    SMALL_STAND,
    STAND,
    STAND_OF_SLEEVE,
    draw_knife_edge,
    draw_pivot,
    find_half_base,
)
from kinegrade.figure.teeth import TOOTH_ROOT
from kinegrade.language.message import Fault, Message
from kinegrade.mechanics.joints import GROUND
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Side

_SIDES: tuple[Side, ...] = ("down", "up", "left", "right")
# Millimetres between the ground line and a bar, which may leave at 45 degrees beside it
_CLEAR = 0.2
_AROUND = 1.6  # millimetres around the upright of a stand that keep clear of other bodies
# Millimetres beyond the foot of a stand and at its sides that hide a marked centre
_HATCHED, _CROSS = 3.0, 0.8
_INSIDE = 8.5  # millimetres of radius at which a stand is clear of the hatching of a fixed wheel
_ROOMY = 6.4  # millimetres from the centre of a wheel to its rim, or teeth, that a stand takes


def draw_stands(anatomy: Anatomy) -> Iterator[Primitive]:
    """The knife edges, then the stands of fixed pins; a pin at the centre of a fixed wheel without
    room for one needs none.

    Raises TemplateError for a support where nothing is fixed.
    """
    at, fixed = anatomy.mechanism.points, find_fixed_pins(anatomy.symbols)
    for name in anatomy.hints.supports:
        if name not in fixed:
            raise TemplateError(
                Fault(f"figure.supports.{name}", Message("figure.nothing-to-support"))
            )
    for name, side in anatomy.knife_edges.items():
        yield from draw_knife_edge(at[name], side)
    wheels = {
        rim.centre
        for rim in anatomy.rims
        if rim.body == GROUND and not rim.ring and rim.radius < _INSIDE
    }
    for name in fixed:
        bare = name in wheels or name in anatomy.knife_edges
        if not bare and not _turns_a_sleeve(at[name], anatomy):
            yield from draw_pivot(at[name], choose_upright(name, anatomy))


def draw_stands_of_sleeves(anatomy: Anatomy) -> Iterator[Primitive]:
    """The stands of fixed pins beside the bars in sleeves, whose legs lead over these up to the
    pins.
    """
    at = anatomy.mechanism.points
    for name in find_fixed_pins(anatomy.symbols):
        if name not in anatomy.knife_edges and _turns_a_sleeve(at[name], anatomy):
            yield from draw_pivot(at[name], choose_upright(name, anatomy))


def choose_upright(name: str, anatomy: Anatomy) -> Vector:
    """The vector from a fixed pin to the ground of its stand, of one size in a figure: on the side
    that the author wants, else down, so that the supports of a mechanism look alike in all
    postures, unless something is in the way there.
    """
    at = anatomy.mechanism.points[name]
    height = STAND_OF_SLEEVE if _turns_a_sleeve(at, anatomy) else _choose_height(anatomy)
    wanted = anatomy.hints.supports.get(name, _SIDES[0])
    uprights = [SIDE_VECTORS[side] * height for side in dict.fromkeys((wanted, *_SIDES))]
    return min(uprights, key=lambda upright: _measure_hindrance(at, upright, anatomy))


def _choose_height(anatomy: Anatomy) -> float:
    """The height of all stands: they fit into the smallest wheel that turns about a fixed pin."""
    pins = [anatomy.mechanism.points[name] for name in find_fixed_pins(anatomy.symbols)]
    narrow = any(
        not rim.ring
        and rim.radius - TOOTH_ROOT * (rim.kind == "gear") < _ROOMY
        and any(length(rim.at - pin) < NEAR for pin in pins)
        for rim in anatomy.rims
    )
    return SMALL_STAND if narrow else STAND


def _turns_a_sleeve(at: Vector, anatomy: Anatomy) -> bool:
    """Whether a sleeve turns about a fixed pin, which is seen in it beside its bar."""
    return any(length(sleeve.point - at) < 1.0 for sleeve in anatomy.sleeves)


def _measure_hindrance(at: Vector, upright: Vector, anatomy: Anatomy) -> float:
    """How much is in the way of a stand along the upright of a pin; 0 for nothing."""
    bars = sum(_measure_part(part, at, upright) for part in anatomy.parts)
    rims = sum(_measure_rim(rim, at, upright) for rim in anatomy.rims)
    centres = sum(_measure_centre(rim, at, upright) for rim in anatomy.rims)
    return round(bars + rims + centres + _measure_axes(upright, at, anatomy), 6)


def _measure_part(part: Part, at: Vector, upright: Vector) -> float:
    """How much a part is in the way of a stand along the upright of a pin; 0 for not at all."""
    ends: tuple[Vector, ...]
    match part:
        case Bar() | Rod():
            middle = at + upright / 2
            if length(nearest_of(at, part.start, part.end) - at) > 1.0:
                gap = length(nearest_of(middle, part.start, part.end) - middle)
                return max(0.0, _AROUND + length(upright) / 2 - gap)
            ends, half = (part.start, part.end), find_half_width(part)
        case Plate():
            ends, half = part.corners, BOLD.width / 2
            if all(length(corner - at) > 1.0 for corner in ends):
                return 0.0
        case SlottedDisc() | GenevaWheel():
            return 0.0
        case _:
            assert_never(part)
    height, base = length(upright), find_half_base(length(upright))
    room = atan2(base, height) + asin((half + _CLEAR) / hypot(base, height))
    leaving = [angle_of(end - at) - angle_of(upright) for end in ends if length(end - at) > 1.0]
    return sum(max(0.0, room - abs(shorter_way(angle))) for angle in leaving)


def _measure_centre(rim: Rim, at: Vector, upright: Vector) -> float:
    """How much the marked centre of a circle is hidden by a stand and its hatching."""
    toward, height = unit(upright), length(upright)
    depth, aside = (rim.at - at).dot(toward), abs((rim.at - at).cross(toward))
    if length(rim.at - at) < 1.0 or not 0 < depth < height + _HATCHED:
        return 0.0
    half = find_half_base(height) * min(1.0, depth / height)
    return float(max(0.0, half + _CROSS - aside))


def _measure_axes(side: Vector, at: Vector, anatomy: Anatomy) -> float:
    """How much the axes x and y are in the way of a stand, up or to the right of their origin."""
    along = max(side.x, side.y) > 0 and length(at) < NEAR
    return _AROUND if along and anatomy.hints.axes == "origin" else 0.0


def _measure_rim(rim: Rim, at: Vector, upright: Vector) -> float:
    """How much a moving wheel beside the pin is in the way; one about or over the pin is on all
    sides of it.
    """
    if rim.body == GROUND or rim.ring or length(rim.at - at) < rim.radius + 1.0:
        return 0.0
    reach = _AROUND + length(upright) / 2 + rim.radius
    return max(0.0, reach - length(rim.at - at - upright / 2))
