"""The marks of points as primitives: open circles at pins, half circles at the side of a bar that
runs on, crosses at centres, at labelled construction points and in the hollow of a slot, dots at
other marked points.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinegrade.figure.joints.drivers import find_motor
from kinegrade.figure.mechanism.anatomy import Anatomy
from kinegrade.figure.mechanism.plates import Plate
from kinegrade.figure.mechanism.stands import choose_upright
from kinegrade.figure.mechanism.straight.gussets import find_welded_arms
from kinegrade.figure.mechanism.straight_parts import Bar, Rod, is_slender, list_ways
from kinegrade.figure.plane import NEAR, length, unit
from kinegrade.figure.scene import FIRM, Disc, Outline, Primitive
from kinegrade.figure.symbols.pins import (
    DOT,
    draw_boss,
    draw_centre_mark,
    draw_dot,
    draw_half_pin,
    draw_pin,
)
from kinegrade.mechanics.vector import Vector

_LOWER = Vector(0.01, -0.1)  # where a pin sits when nothing else decides: below, or to the right

_DOT_IN_MESH = 0.5  # millimetres of radius: it fits on a tooth
_DOT_ON_BAR = 0.95  # millimetres of radius among teeth on a bar that is not its body's
# Millimetres: the radius of a motor, and half the width of its neck there
_HOUSING, _NECK = 2.3, 1.9
_WELD = 5.5  # millimetres along the bar that carries it to the tip of its weld


def draw_points(anatomy: Anatomy) -> Iterator[Primitive]:
    """Crosses below dots below circles; the tip of a knife edge or of a pointed follower and a
    rigid corner need no mark.
    """
    at = anatomy.mechanism.points
    tips = {*anatomy.knife_edges, *anatomy.heads}
    pins = _find_pins(anatomy) - tips
    swivels = find_swivels(anatomy)
    owned = {name for body in anatomy.mechanism.bodies for name in body.points}
    centres = ({rim.centre for rim in anatomy.rims} | _find_labelled(anatomy) - owned - tips) - pins
    for name in sorted(centres):
        yield from draw_centre_mark(at[name])
    hollow = _find_in_slots(anatomy) - pins - centres
    for name in sorted(hollow - _find_letterless(anatomy)):
        yield from draw_centre_mark(at[name])
    for name in sorted(owned - pins - centres - hollow - tips - _find_at_corners(anatomy)):
        yield from _draw_marked_point(anatomy, at[name])
    for name in sorted(pins - swivels.keys()):
        yield from _draw_joint(anatomy, name)


def _draw_joint(anatomy: Anatomy, name: str) -> tuple[Primitive, ...]:
    """A half circle beside a bar that runs on through a pin, a small hole in the boss of several
    that do, else a circle.
    """
    at = anatomy.mechanism.points[name]
    joined, through = _find_members(anatomy, name)
    if not through or _is_occupied(anatomy, at):
        return draw_pin(at)
    if len(through) > 1:
        return draw_boss(at)
    beside = [bar for bar in joined if bar is not through[0]]
    along = through[0].end - through[0].start
    return draw_half_pin(at, _find_side(anatomy, name, beside, along))


def draw_swivels(anatomy: Anatomy) -> Iterator[Primitive]:
    """The pins about which sleeves turn: half circles beside the bars that slide through these,
    towards the members pinned there.
    """
    for at, side in find_half_pins(anatomy):
        yield from draw_half_pin(at, side)


def find_half_pins(anatomy: Anatomy) -> tuple[tuple[Vector, Vector], ...]:
    """The points of pins in sleeves that are half circles, each with the unit vector from the bar
    to these; an arm that is welded to a sleeve is no such member.
    """
    arms = [arm for arm, _ in find_welded_arms(anatomy.parts, anatomy.symbols)]
    found = []
    for name, along in sorted(find_swivels(anatomy).items()):
        joined, _ = _find_members(anatomy, name)
        ways = [(bar, unit(bar.end - bar.start)) for bar in joined if bar not in arms]
        pinned = [bar for bar, way in ways if abs(along.cross(way)) > NEAR]
        side = _find_side(anatomy, name, pinned, along)
        found.append((anatomy.mechanism.points[name], side))
    return tuple(found)


def find_swivels(anatomy: Anatomy) -> dict[str, Vector]:
    """The points of pins in sleeves, with the direction of the bar there."""
    at, pins = anatomy.mechanism.points, _find_pins(anatomy)
    return {
        name: sleeve.direction
        for sleeve in anatomy.sleeves
        for name in pins
        if length(at[name] - sleeve.point) < NEAR
    }


def draw_motors(anatomy: Anatomy) -> Iterator[Primitive]:
    """A round housing about the pin of two bodies of which one drives the other, welded to the bar
    of the body that carries it.
    """
    for driver in anatomy.mechanism.drivers:
        bodies = find_motor(driver)
        for symbol in anatomy.symbols:
            if bodies and symbol.point and set(bodies) <= set(symbol.turning):
                at = anatomy.mechanism.points[symbol.point]
                yield from _weld_housing(anatomy, at, carrier=bodies[1])
                yield Disc(at, _HOUSING, FIRM, "grey")


def _weld_housing(anatomy: Anatomy, at: Vector, carrier: str) -> Iterator[Primitive]:
    """A light neck, which makes no corner of the two bars, as a black one would."""
    bars = [part for part in anatomy.parts if is_slender(part) and part.body == carrier]
    for toward in (unit(way) for bar in bars for way in list_ways(bar, at)):
        across = toward.turned() * _NECK
        yield Outline((at + toward * _WELD, at + across, at - across), FIRM, "grey")


def _find_pins(anatomy: Anatomy) -> set[str]:
    """The points of pins, but for those that only guide a rod or a rack."""
    return {
        symbol.point
        for symbol in anatomy.symbols
        if symbol.point
        and symbol.pinned
        and not anatomy.is_rod(symbol)
        and not anatomy.find_rack(symbol)
    }


def _draw_marked_point(anatomy: Anatomy, at: Vector) -> Iterator[Primitive]:
    """A dot, small among the teeth of two gears, where a bar passes over these one that is seen on
    the bar.
    """
    meshing = any(rim.kind == "gear" and length(rim.touch - at) < NEAR for rim in anatomy.rims)
    over = any(is_slender(part) and list_ways(part, at) for part in anatomy.parts)
    yield from draw_dot(at, (_DOT_ON_BAR if over else _DOT_IN_MESH) if meshing else DOT)


def _find_at_corners(anatomy: Anatomy) -> set[str]:
    """The points at which a body has a rigid corner or the corner of its plate."""
    corners = [corner.at for corner in anatomy.corners]
    corners += [at for part in anatomy.parts if isinstance(part, Plate) for at in part.corners]
    points = anatomy.mechanism.points.items()
    return {name for name, at in points if any(length(at - corner) < NEAR for corner in corners)}


def _find_in_slots(anatomy: Anatomy) -> set[str]:
    """The points that bodies have in the hollow of their own slots, where a dot would look like a
    pin that slides in them.
    """
    slots = [part for part in anatomy.parts if isinstance(part, Bar) and part.use == "slot"]
    return {
        name
        for slot in slots
        for name in anatomy.mechanism.body(slot.body).points
        if length(anatomy.mechanism.points[name] - slot.start) > NEAR
        and length(anatomy.mechanism.points[name] - slot.end) > NEAR
        and list_ways(slot, anatomy.mechanism.points[name])
    }


def _find_labelled(anatomy: Anatomy) -> set[str]:
    labels = anatomy.hints.labels.items()
    return {name for name, symbol in labels if symbol and name in anatomy.mechanism.points}


def _find_letterless(anatomy: Anatomy) -> set[str]:
    """The points whose letter is left out: a cross would ask what is there."""
    return {name for name, symbol in anatomy.hints.labels.items() if not symbol}


def _find_members(anatomy: Anatomy, name: str) -> tuple[list[Bar | Rod], list[Bar | Rod]]:
    """The slender members of the bodies that are pinned to each other at a point, and those of
    them that run on through it.
    """
    at = anatomy.mechanism.points[name]
    owners = {body.name for body in anatomy.mechanism.bodies if name in body.points}
    joined = [part for part in anatomy.parts if is_slender(part) and part.body in owners]
    return joined, [bar for bar in joined if len(list_ways(bar, at)) == 2]


def _find_side(anatomy: Anatomy, name: str, pinned: Sequence[Bar | Rod], through: Vector) -> Vector:
    """The unit vector from a bar that runs on through a pin to the members pinned to it."""
    at, toward = anatomy.mechanism.points[name], _LOWER
    for bar in pinned:
        toward = sum((unit(way) for way in list_ways(bar, at)), toward)
    if any(symbol.fixed and symbol.point == name for symbol in anatomy.symbols):
        toward = toward + unit(choose_upright(name, anatomy))
    across = unit(through).turned()
    return across if across.dot(toward) > 0 else -across


def _is_occupied(anatomy: Anatomy, at: Vector) -> bool:
    slides = [slide for symbol in anatomy.symbols for slide in (symbol.sleeve, symbol.block)]
    places = [slide.point for slide in slides if slide] + [rim.at for rim in anatomy.rims]
    return any(length(place - at) < NEAR for place in places)
