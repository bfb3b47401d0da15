"""Round bodies as primitives: wheels, gears, cams, ring-shaped slots, and fixed circles."""

from __future__ import annotations

from collections.abc import Iterator
from typing import assert_never

from kinegrade.figure.joints.symbol import Rim, find_fixed_pin
from kinegrade.figure.mechanism.anatomy import Anatomy
from kinegrade.figure.mechanism.wheels.outlines import (
    RING,
    find_pivot,
    trace_around,
    trace_cam_outline,
)
from kinegrade.figure.plane import NEAR, angle_of, length
from kinegrade.figure.scene import (
    FIRM,
    PITCH,
    THIN,
    TOOTHED,
    Disc,
    Fill,
    Outline,
    Primitive,
    Strokes,
)
from kinegrade.figure.symbols.bars import draw_round_slot
from kinegrade.figure.symbols.ground import draw_round_ground
from kinegrade.figure.teeth import TOOTH_ROOT, trace_gear
from kinegrade.mechanics.joints import GROUND

_BAND = 0.6  # millimetres of material behind the teeth of a fixed gear


def draw_round_bodies(anatomy: Anatomy) -> Iterator[Primitive]:
    """The circles of the ground, then those of the bodies, the larger ones below; of rings with
    slots the earlier one lies in front of those that it crosses. Each lies above the necks of its
    bars, so that its rim or its teeth are whole.
    """
    slotted = [rim for rim in anatomy.rims if _is_slotted(rim)]
    seen: set[str] = set()
    for rim in anatomy.rims:
        if rim.body not in seen:
            necks = (neck for neck in anatomy.necks if neck.body == rim.body)
            yield from (Outline(neck.corners, FIRM, "grey") for neck in necks)
            seen.add(rim.body)
        if rim not in slotted:
            yield from _draw_rim(anatomy, rim)
    for rim in reversed(slotted):
        yield from _draw_slotted(anatomy, rim)


def _is_slotted(rim: Rim) -> bool:
    return rim.kind == "slot" and rim.body != GROUND and not rim.ring


def _draw_slotted(anatomy: Anatomy, rim: Rim) -> tuple[Primitive, ...]:
    """A ring with a slot along it."""
    pin = find_fixed_pin(anatomy.symbols, rim.body)
    pivot = anatomy.mechanism.points[pin] if pin else None
    on_ring = pivot and abs(length(pivot - rim.at) - rim.radius) < NEAR
    return draw_round_slot(rim.at, rim.radius, pivot if on_ring else None)


def _draw_rim(anatomy: Anatomy, rim: Rim) -> tuple[Primitive, ...]:
    if rim.body == GROUND:
        return _draw_fixed_rim(anatomy, rim)
    match rim.kind:
        case "edge":
            return _draw_edge(anatomy, rim)
        case "cam":
            return _draw_cam(anatomy, rim)
        case "wheel" | "gear" | "slot":
            return _draw_ring(rim) if rim.ring else _draw_round(rim)
        case _:
            assert_never(rim.kind)


def _draw_edge(anatomy: Anatomy, rim: Rim) -> tuple[Primitive, ...]:
    """A circle of a body that no joint mentions. Those of a cam lie within one outline, whose
    straight flanks touch them; the circle about its pivot is its base circle.
    """
    if anatomy.hints.shapes.get(rim.body) != "cam":
        return (Disc(rim.at, rim.radius, FIRM, "grey"),)
    first, *_ = edges = [
        each for each in anatomy.rims if each.kind == "edge" and each.body == rim.body
    ]
    outline = Outline(trace_around(edges), FIRM, "grey") if rim is first else None
    is_base = rim.centre == find_fixed_pin(anatomy.symbols, rim.body)
    base = Disc(rim.at, rim.radius, PITCH) if is_base else None
    return tuple(drawn for drawn in (outline, base) if drawn)


def _draw_fixed_rim(anatomy: Anatomy, rim: Rim) -> tuple[Primitive, ...]:
    """A rim of the ground: hatched behind its edge or behind the teeth."""
    match rim.kind:
        case "edge":
            return (Disc(rim.at, rim.radius, FIRM),)
        case "gear":
            return _draw_fixed_gear(anatomy, rim)
        case "wheel" | "slot" | "cam":
            return draw_round_ground(rim.at, rim.radius, rim.ring, rim.find_arc())
        case _:
            assert_never(rim.kind)


def _draw_fixed_gear(anatomy: Anatomy, rim: Rim) -> tuple[Primitive, ...]:
    """The teeth on a band of material, whose other side is hatched, except behind a point of
    contact, whose letter may stand there.
    """
    named = any(length(at - rim.touch) < NEAR for at in anatomy.mechanism.points.values())
    contact = angle_of(rim.touch - rim.at) if named else None
    if rim.ring:
        back = rim.radius + TOOTH_ROOT + _BAND
        ground = draw_round_ground(rim.at, back, outward=True, open_at=contact)
        return (*ground, Disc(rim.at, back, FIRM, "grey"), *_draw_gear(rim, "white"))
    back = rim.radius - TOOTH_ROOT - min(_BAND, rim.radius / 3)
    ground = draw_round_ground(rim.at, back, outward=False, open_at=contact)
    return (*_draw_gear(rim, "grey"), Disc(rim.at, back, FIRM, "white"), *ground)


def _draw_ring(rim: Rim) -> tuple[Primitive, ...]:
    """A rim around others: the body lies outside."""
    outer = Disc(rim.at, rim.radius + RING, FIRM, "grey")
    match rim.kind:
        case "gear":
            return (outer, *_draw_gear(rim, "white"))
        case "wheel" | "slot" | "cam" | "edge":
            return (outer, Disc(rim.at, rim.radius, FIRM, "white"))
        case _:
            assert_never(rim.kind)


def _draw_gear(rim: Rim, fill: Fill) -> tuple[Primitive, ...]:
    """The teeth with the pitch circle."""
    teeth = Outline(trace_gear(rim.at, rim.tooth, rim.ring), TOOTHED, fill)
    return (teeth, Disc(rim.at, rim.radius, PITCH))


def _draw_round(rim: Rim) -> tuple[Primitive, ...]:
    """A wheel or a gear."""
    match rim.kind:
        case "gear":
            return _draw_gear(rim, "grey")
        case "wheel" | "slot" | "cam" | "edge":
            return (Disc(rim.at, rim.radius, FIRM, "grey"),)
        case _:
            assert_never(rim.kind)


def _draw_cam(anatomy: Anatomy, rim: Rim) -> tuple[Primitive, ...]:
    """The profile with its base circle, and a thin line from the centre of curvature to the
    contact.
    """
    profile = trace_cam_outline(anatomy.mechanism, anatomy.symbols, rim)
    pivot = find_pivot(anatomy.mechanism, anatomy.symbols, rim)
    base = min(length(corner - pivot) for corner in profile)
    return (
        Outline(profile, FIRM, "grey"),
        Disc(pivot, base, PITCH),
        Strokes(((rim.at, rim.touch),), THIN),
    )
