"""The mechanism itself as primitives, from the lowest layer up: circles, stands, bars, blocks, pins."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import pi

from kinegrade.figure import symbols
from kinegrade.figure.bars import (
    Bar,
    Plate,
    Rod,
    SlottedDisc,
    bar_and_carrier,
    bodies_of,
    sleeve_centre,
    translating,
)
from kinegrade.figure.cam import cam_profile
from kinegrade.figure.plane import (
    SIDE_VECTORS,
    angle_of,
    foot,
    length,
    mean,
    shorter_way,
    unit,
)
from kinegrade.figure.rims import Rim, grown, rims, track_feet, without_hidden
from kinegrade.figure.scene import (
    BOLD,
    FIRM,
    PITCH,
    THIN,
    Disc,
    Outline,
    Primitive,
    Strokes,
)
from kinegrade.mechanics.joints import GROUND, Line, Pin, Sleeve, Slide
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector

PENCILS = {"wheel": FIRM, "slot": FIRM, "gear": PITCH, "cam": FIRM}


@dataclass(frozen=True)
class Drawing:
    """The mechanism's primitives, with what marks and labels need to know about its parts."""

    primitives: tuple[Primitive, ...]
    rims: tuple[Rim, ...]
    parts: tuple[Bar | Plate | SlottedDisc | Rod, ...]


def draw(mechanism: Mechanism, shapes: Mapping[str, str]) -> Drawing:
    """The mechanism (lengths in millimetres) drawn with the symbols of ISO 3952."""
    found = without_hidden(rims(mechanism, shapes))
    parts = bodies_of(mechanism, shapes, found)
    layers = (
        *(piece for rim in found for piece in _rim(mechanism, rim)),
        *_tracks(mechanism),
        *(
            piece
            for part in parts
            if isinstance(part, Plate | SlottedDisc)
            for piece in _part(mechanism, part)
        ),
        *_stands(mechanism, found, parts),
        *_sleeves(mechanism, shapes),
        *(piece for part in parts if isinstance(part, Bar | Rod) for piece in _part(mechanism, part)),
        *_blocks(mechanism, shapes, parts),
        *_pins(mechanism, found),
    )
    return Drawing(layers, found, parts)


def _rim(mechanism: Mechanism, rim: Rim) -> tuple[Primitive, ...]:
    if rim.body == GROUND:
        edge = symbols.round_ground(rim.at, rim.radius, rim.ring)
        return (*edge[:-1], Disc(rim.at, rim.radius, PITCH)) if rim.kind == "gear" else edge
    if rim.kind == "cam":
        return _cam(mechanism, rim)
    pen = PENCILS[rim.kind]
    if rim.ring:
        return (Disc(rim.at, grown(rim, 2.0).radius, FIRM, "grey"), Disc(rim.at, rim.radius, pen, "white"))
    if rim.kind == "slot":
        half = symbols.SLOT_WIDTH / 2
        return (Disc(rim.at, rim.radius + half, pen), Disc(rim.at, rim.radius - half, pen))
    return (Disc(rim.at, rim.radius, pen, "grey"),)


def _cam(mechanism: Mechanism, rim: Rim) -> tuple[Primitive, ...]:
    """The profile, with a thin line from the centre of curvature to the contact."""
    return (Outline(cam_outline(mechanism, rim), FIRM, "grey"), Strokes(((rim.at, rim.touch),), THIN))


def cam_outline(mechanism: Mechanism, rim: Rim) -> tuple[Vector, ...]:
    """The profile of a cam about its fixed pin, in the unit of the mechanism."""
    pivots = [
        mechanism.points[joint.point]
        for joint in mechanism.joints
        if isinstance(joint, Pin) and GROUND in joint.bodies and rim.body in joint.bodies
    ]
    return cam_profile(pivots[0] if pivots else rim.at, rim.touch, rim.at, rim.radius)


def _tracks(mechanism: Mechanism) -> tuple[Primitive, ...]:
    """Straight ground surfaces under wheels, hatched on the side away from the wheel."""
    pieces: tuple[Primitive, ...] = ()
    for line, contact, centre, radius in track_feet(mechanism):
        along, reach = unit(line.direction), max(8.0, 1.2 * radius)
        pieces += symbols.ground(contact - along * reach, contact + along * reach, unit(contact - centre))
    return pieces


def _stands(
    mechanism: Mechanism, found: tuple[Rim, ...], parts: tuple[Bar | Plate | SlottedDisc | Rod, ...]
) -> tuple[Primitive, ...]:
    """The stands of fixed pins; a pin at the centre of a fixed wheel needs none."""
    standing = {rim.centre for rim in found if rim.body == GROUND and not rim.ring}
    fixed = [joint.point for joint in mechanism.joints if isinstance(joint, Pin) and GROUND in joint.bodies]
    fixed += [joint.point for joint in mechanism.joints if isinstance(joint, Slide) and joint.body == GROUND]
    return tuple(
        piece
        for name in dict.fromkeys(fixed)
        if name not in standing
        for piece in symbols.pivot(mechanism.points[name], _free_side(mechanism.points[name], parts))
    )


def _free_side(at: Vector, parts: tuple[Bar | Plate | SlottedDisc | Rod, ...]) -> Vector:
    """Down, unless a bar goes there; then the side with the widest room."""
    leaving = []
    for part in parts:
        if isinstance(part, Bar | Rod):
            near = foot(at, _axis(part))
            if length(near - at) < 1.0:
                leaving += [angle_of(end - at) for end in (part.start, part.end) if length(end - at) > 1.0]

    def room(side: Vector) -> float:
        return min((abs(shorter_way(angle - angle_of(side))) for angle in leaving), default=pi)

    sides = [SIDE_VECTORS[name] for name in ("down", "left", "right", "up")]
    return sides[0] if room(sides[0]) > 0.7 else max(sides, key=lambda side: round(room(side), 6))


def _axis(part: Bar | Rod) -> Line:
    return Line(part.start, part.end - part.start)


def _part(mechanism: Mechanism, part: Bar | Plate | SlottedDisc | Rod) -> tuple[Primitive, ...]:
    if isinstance(part, Plate):
        return (Outline(part.corners, BOLD, "grey"),)
    if isinstance(part, SlottedDisc):
        slot = Outline(symbols.stadium(*part.slot, symbols.SLOT_WIDTH), FIRM, "white")
        return (Disc(part.centre, part.radius, FIRM, "grey"), slot)
    if isinstance(part, Rod):
        along = unit(part.end - part.start)
        return (*symbols.guide(part.end - along * 5.0, along), Strokes(((part.start, part.end),), BOLD))
    if part.use == "slot":
        return symbols.slotted_bar(part.start, part.end, _slot(mechanism, part))
    return (Strokes(((part.start, part.end),), BOLD),)


def _slot(mechanism: Mechanism, part: Bar) -> tuple[Vector, Vector]:
    """The slot leaves the ends of a bar whole, and more of it where the bar is pinned."""
    along = unit(part.end - part.start)
    margins = [
        0.4 if any(length(end - free) < 1e-6 for free in part.free) else 3.0 for end in (part.start, part.end)
    ]
    low, high = part.start + along * margins[0], part.end - along * margins[1]
    reach = (symbols.BLOCK_LENGTH - 1.0) / 2
    for action in part.actions:
        low = min(low, action - along * reach, key=along.dot)
        high = max(high, action + along * reach, key=along.dot)
    return low, high


def _sleeves(mechanism: Mechanism, shapes: Mapping[str, str]) -> tuple[Primitive, ...]:
    pieces: tuple[Primitive, ...] = ()
    for joint in mechanism.joints:
        if isinstance(joint, Sleeve) and bar_and_carrier(mechanism, joint)[1] != GROUND:
            pieces += symbols.sleeve(sleeve_centre(mechanism, joint), unit(joint.line.direction))
        if isinstance(joint, Slide) and _in_sleeve(joint, shapes):
            pieces += symbols.sleeve(mechanism.points[joint.point], unit(joint.line.direction))
    return pieces


def _in_sleeve(joint: Slide, shapes: Mapping[str, str]) -> bool:
    return joint.of != GROUND and (joint.body == GROUND or shapes.get(joint.of) == "bar")


def _blocks(
    mechanism: Mechanism, shapes: Mapping[str, str], parts: tuple[Bar | Plate | SlottedDisc | Rod, ...]
) -> tuple[Primitive, ...]:
    """Sliders: on ground guides, and in the slots of moving bodies."""
    guided = translating(mechanism)
    pieces: tuple[Primitive, ...] = ()
    for joint in mechanism.joints:
        if (
            not isinstance(joint, Slide)
            or (joint.body in guided and joint.of == GROUND)
            or _in_sleeve(joint, shapes)
        ):
            continue
        at, along = mechanism.points[joint.point], unit(joint.line.direction)
        if joint.of == GROUND:
            pieces += symbols.ground_slider(at, along, _guide_side(mechanism, at, along))
        else:
            pieces += (symbols.block(at, along, symbols.BLOCK_LENGTH - 1.0, symbols.SLOT_WIDTH),)
    return pieces


def _guide_side(mechanism: Mechanism, at: Vector, along: Vector) -> Vector:
    """The side of a guide away from the mechanism; below, or to the right, when neither is."""
    across = along.turned()
    below = -across if across.y > 1e-9 or (abs(across.y) <= 1e-9 and across.x < 0) else across
    rest = (mean(mechanism.points.values()) - at).dot(below)
    return -below if rest > 1e-6 else below


def _pins(mechanism: Mechanism, found: tuple[Rim, ...]) -> tuple[Primitive, ...]:
    """Open circles at pins, crosses at the centres of circles, dots at other marked points."""
    pinned = {joint.point for joint in mechanism.joints if isinstance(joint, Pin)}
    translated = translating(mechanism)
    sliding = [joint for joint in mechanism.joints if isinstance(joint, Slide)]
    pinned |= {joint.point for joint in sliding if joint.body not in translated or joint.of != GROUND}
    centres = {rim.centre for rim in found} - pinned
    marked = {name for body in mechanism.bodies for name in body.points} - pinned - centres
    crosses = [piece for name in sorted(centres) for piece in symbols.centre_mark(mechanism.points[name])]
    dots = [piece for name in sorted(marked) for piece in symbols.dot(mechanism.points[name])]
    circles = [piece for name in sorted(pinned) for piece in symbols.pin(mechanism.points[name])]
    return (*crosses, *dots, *circles)
