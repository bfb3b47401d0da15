"""The mechanism itself as primitives, from the lowest layer up: circles, stands, bars, blocks,
pins.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import assert_never

from kinegrade.figure import symbols
from kinegrade.figure.mechanism.bars import (
    Bar,
    Rod,
    SlottedDisc,
    find_sleeve_centre,
    find_straight_bodies,
    find_translating,
    tell_bar_from_carrier,
)
from kinegrade.figure.mechanism.cam import trace_cam_profile
from kinegrade.figure.mechanism.plates import Plate
from kinegrade.figure.mechanism.rims import Rim, enlarge, find_rims, order_rims
from kinegrade.figure.mechanism.stands import knife_edges, stands
from kinegrade.figure.mechanism.tracks import draw_tracks
from kinegrade.figure.plane import length, mean, unit
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
from kinegrade.mechanics.joints import GROUND, Pin, Sleeve, Slide
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import FigureHints

_PENCILS = {"wheel": FIRM, "slot": FIRM, "gear": PITCH, "cam": FIRM}


@dataclass(frozen=True)
class Drawing:
    """The mechanism's primitives, with what marks and labels need to know about its parts."""

    primitives: tuple[Primitive, ...]
    rims: tuple[Rim, ...]
    parts: tuple[Bar | Plate | SlottedDisc | Rod, ...]


def draw(mechanism: Mechanism, hints: FigureHints) -> Drawing:
    """The mechanism (lengths in millimetres) drawn with the symbols of ISO 3952."""
    shapes = hints.shapes
    found = order_rims(find_rims(mechanism, shapes, hints.circles))
    parts = find_straight_bodies(mechanism, shapes, found)
    knives = knife_edges(mechanism, parts)
    sleeves = _find_sleeves(mechanism, shapes, knives)
    layers = (
        *(piece for rim in found for piece in _draw_rim(mechanism, rim)),
        *draw_tracks(mechanism, shapes),
        *(
            piece
            for part in parts
            if isinstance(part, Plate | SlottedDisc)
            for piece in _draw_part(mechanism, part)
        ),
        *(
            piece
            for name, side in knives.items()
            for piece in symbols.draw_knife_edge(mechanism.points[name], side)
        ),
        *stands(mechanism, found, parts, {*knives}, sleeves),
        *(piece for at, along in sleeves for piece in symbols.draw_sleeve(at, along)),
        *(
            piece
            for part in parts
            if isinstance(part, Bar | Rod)
            for piece in _draw_part(mechanism, part)
        ),
        *_draw_reference_lines(mechanism, hints),
        *_draw_blocks(mechanism, shapes),
        *_draw_pins(mechanism, found, hints, {*knives}),
    )
    return Drawing(layers, found, parts)


def _draw_rim(mechanism: Mechanism, rim: Rim) -> tuple[Primitive, ...]:
    if rim.body == GROUND:
        return _draw_fixed_rim(rim)
    match rim.kind:
        case "edge":
            return (Disc(rim.at, rim.radius, FIRM),)
        case "cam":
            return _draw_cam(mechanism, rim)
        case "wheel" | "gear" | "slot":
            return _draw_ring(rim) if rim.ring else _draw_round(rim)
        case _:
            assert_never(rim.kind)


def _draw_fixed_rim(rim: Rim) -> tuple[Primitive, ...]:
    """A rim of the ground: hatched, the pitch circle of a gear dash-dotted."""
    match rim.kind:
        case "edge":
            return (Disc(rim.at, rim.radius, FIRM),)
        case "gear":
            edge = symbols.draw_round_ground(rim.at, rim.radius, rim.ring)
            return (*edge[:-1], Disc(rim.at, rim.radius, PITCH))
        case "wheel" | "slot" | "cam":
            return symbols.draw_round_ground(rim.at, rim.radius, rim.ring)
        case _:
            assert_never(rim.kind)


def _draw_ring(rim: Rim) -> tuple[Primitive, ...]:
    """A rim around others: the body lies outside."""
    outer = Disc(rim.at, enlarge(rim, 2.0).radius, FIRM, "grey")
    return (outer, Disc(rim.at, rim.radius, _PENCILS[rim.kind], "white"))


def _draw_round(rim: Rim) -> tuple[Primitive, ...]:
    """A wheel, a gear, or a ring-shaped slot."""
    pen = _PENCILS[rim.kind]
    match rim.kind:
        case "slot":
            half = symbols.SLOT_WIDTH / 2
            return (Disc(rim.at, rim.radius + half, pen), Disc(rim.at, rim.radius - half, pen))
        case "wheel" | "gear" | "cam" | "edge":
            return (Disc(rim.at, rim.radius, pen, "grey"),)
        case _:
            assert_never(rim.kind)


def _draw_cam(mechanism: Mechanism, rim: Rim) -> tuple[Primitive, ...]:
    """The profile, with a thin line from the centre of curvature to the contact."""
    return (
        Outline(trace_cam_outline(mechanism, rim), FIRM, "grey"),
        Strokes(((rim.at, rim.touch),), THIN),
    )


def trace_cam_outline(mechanism: Mechanism, rim: Rim) -> tuple[Vector, ...]:
    """The profile of a cam about its fixed pin, in the unit of the mechanism."""
    pivots = [
        mechanism.points[joint.point]
        for joint in mechanism.joints
        if isinstance(joint, Pin) and GROUND in joint.bodies and rim.body in joint.bodies
    ]
    return trace_cam_profile(pivots[0] if pivots else rim.at, rim.touch, rim.at, rim.radius)


def _draw_part(
    mechanism: Mechanism, part: Bar | Plate | SlottedDisc | Rod
) -> tuple[Primitive, ...]:
    match part:
        case Plate():
            return (Outline(part.corners, BOLD, "grey"),)
        case SlottedDisc():
            slot = Outline(symbols.trace_stadium(*part.slot, symbols.SLOT_WIDTH), FIRM, "white")
            return (Disc(part.centre, part.radius, FIRM, "grey"), slot)
        case Rod():
            along = unit(part.end - part.start)
            return (
                *symbols.draw_guide(part.end - along * 5.0, along),
                Strokes(((part.start, part.end),), BOLD),
            )
        case Bar():
            return _draw_bar(mechanism, part)
        case _:
            assert_never(part)


def _draw_bar(mechanism: Mechanism, bar: Bar) -> tuple[Primitive, ...]:
    match bar.use:
        case "rack":
            return symbols.draw_rack(bar.start, bar.end, bar.back)
        case "slot":
            return symbols.draw_slotted_bar(bar.start, bar.end, _find_slot(mechanism, bar))
        case "link" | "bar" | "face":
            return (Strokes(((bar.start, bar.end),), BOLD),)
        case _:
            assert_never(bar.use)


def _find_slot(mechanism: Mechanism, part: Bar) -> tuple[Vector, Vector]:
    """The slot leaves the ends of a bar solid, and more of an end where the bar is pinned."""
    along = unit(part.end - part.start)
    margins = [
        0.4 if any(length(end - free) < 1e-6 for free in part.free) else 3.0
        for end in (part.start, part.end)
    ]
    low, high = part.start + along * margins[0], part.end - along * margins[1]
    reach = (symbols.BLOCK_LENGTH - 1.0) / 2
    for action in part.actions:
        low = min(low, action - along * reach, key=along.dot)
        high = max(high, action + along * reach, key=along.dot)
    return low, high


def _find_sleeves(
    mechanism: Mechanism, shapes: Mapping[str, str], knives: Mapping[str, Vector]
) -> list[tuple[Vector, Vector]]:
    """Where sleeves are, each with the direction of the bar in it."""
    places = []
    for joint in mechanism.joints:
        if isinstance(joint, Sleeve) and tell_bar_from_carrier(mechanism, joint)[1] != GROUND:
            places.append((find_sleeve_centre(mechanism, joint), unit(joint.line.direction)))
        if isinstance(joint, Slide) and _in_sleeve(joint, shapes) and joint.point not in knives:
            places.append((mechanism.points[joint.point], unit(joint.line.direction)))
    return places


def _draw_reference_lines(mechanism: Mechanism, hints: FigureHints) -> tuple[Primitive, ...]:
    lines = tuple((mechanism.points[start], mechanism.points[end]) for start, end in hints.lines)
    return (Strokes(lines, THIN),) if lines else ()


def _in_sleeve(joint: Slide, shapes: Mapping[str, str]) -> bool:
    return joint.of != GROUND and (joint.body == GROUND or shapes.get(joint.of) == "bar")


def _draw_blocks(mechanism: Mechanism, shapes: Mapping[str, str]) -> tuple[Primitive, ...]:
    """Sliders: on ground guides, and in the slots of moving bodies."""
    guided = find_translating(mechanism)
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
            pieces += symbols.draw_ground_slider(
                at, along, _choose_guide_side(mechanism, joint.point, along)
            )
        else:
            pieces += (
                symbols.draw_block(at, along, symbols.BLOCK_LENGTH - 1.0, symbols.SLOT_WIDTH),
            )
    return pieces


def _choose_guide_side(mechanism: Mechanism, name: str, along: Vector) -> Vector:
    """The side of a guide away from the mechanism; below, or to the right, when bars leave to both
    sides.
    """
    at = mechanism.points[name]
    across = along.turned()
    below = -across if across.y > 1e-9 or (abs(across.y) <= 1e-9 and across.x < 0) else across
    joined = [
        mechanism.points[point]
        for body in mechanism.bodies
        if name in body.points
        for point in body.points
    ]
    levels = [(point - at).dot(below) for point in joined]
    if min(levels, default=0.0) < -1.0 and max(levels, default=0.0) > 1.0:
        return below
    rest = (mean(mechanism.points.values()) - at).dot(below)
    return -below if rest > 1e-6 else below


def _draw_pins(
    mechanism: Mechanism, found: tuple[Rim, ...], hints: FigureHints, knives: set[str]
) -> tuple[Primitive, ...]:
    """Open circles at pins, crosses at centres and at labelled construction points, dots at other
    marked points.
    """
    pinned = {joint.point for joint in mechanism.joints if isinstance(joint, Pin)}
    translated = find_translating(mechanism)
    sliding = [joint for joint in mechanism.joints if isinstance(joint, Slide)]
    pinned |= {
        joint.point for joint in sliding if joint.body not in translated or joint.of != GROUND
    }
    pinned -= knives
    owned = {name for body in mechanism.bodies for name in body.points}
    labelled = {
        name for name, symbol in hints.labels.items() if symbol and name in mechanism.points
    }
    centres = ({rim.centre for rim in found} | (labelled - owned - knives)) - pinned
    marked = owned - pinned - centres - knives
    crosses = [
        piece
        for name in sorted(centres)
        for piece in symbols.draw_centre_mark(mechanism.points[name])
    ]
    dots = [piece for name in sorted(marked) for piece in symbols.draw_dot(mechanism.points[name])]
    circles = [
        piece for name in sorted(pinned) for piece in symbols.draw_pin(mechanism.points[name])
    ]
    return (*crosses, *dots, *circles)
