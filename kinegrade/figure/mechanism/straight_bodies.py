"""Straight bodies as primitives: bars, racks, rods in their guides, plates, slotted discs, Geneva
wheels.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import assert_never

from kinegrade.figure.joints.symbol import Rim
from kinegrade.figure.mechanism.geneva_wheels import trace_geneva_wheel
from kinegrade.figure.mechanism.plates import RULED_EDGE, Plate
from kinegrade.figure.mechanism.rims import find_gap_of_rack
from kinegrade.figure.mechanism.slotted_discs import draw_slotted_disc
from kinegrade.figure.mechanism.straight_parts import Bar, GenevaWheel, Part, Rod, SlottedDisc
from kinegrade.figure.plane import length, unit
from kinegrade.figure.scene import BOLD, FIRM, THIN, Outline, Primitive, Strokes
from kinegrade.figure.symbols.bars import (
    SOLID_AT_PIN,
    draw_broad_bar,
    draw_slotted_bar,
    trace_round,
)
from kinegrade.figure.symbols.sliding import BLOCK_LENGTH, draw_cylinder, draw_guide
from kinegrade.figure.symbols.teeth import draw_jaw, draw_rack
from kinegrade.mechanics.vector import Vector

_PLATE_EDGE = 1.9  # millimetres of a plate beyond the pins at its corners
_SOLID_END = 1.6  # millimetres from the end of a rack to its last gap, which is no longer cut there


def draw_straight_part(part: Part, rims: Sequence[Rim]) -> tuple[Primitive, ...]:
    """The primitives of one straight part of a mechanism with those circles."""
    match part:
        case Plate():
            return _draw_plate(part)
        case SlottedDisc():
            return draw_slotted_disc(part)
        case GenevaWheel():
            return (trace_geneva_wheel(part),)
        case Rod(cylinder=True):
            return draw_cylinder(part.start, part.end)
        case Rod():
            along = unit(part.end - part.start)
            return (
                *draw_guide(part.end - along * 5.0, along),
                Strokes(((part.start, part.end),), BOLD),
            )
        case Bar():
            return _draw_bar(part, rims)
        case _:
            assert_never(part)


def _draw_plate(plate: Plate) -> tuple[Primitive, ...]:
    """A plate: round about the pins at its corners, or exact where a corner is no pin, or an edge
    touches something; round about its edges as well where they are thin lines on it.
    """
    if plate.ruled:
        edges = tuple(pairwise((*plate.corners, plate.corners[0])))
        return (_draw_round_plate(plate, RULED_EDGE), Strokes(edges, THIN))
    if plate.rounded:
        return (_draw_round_plate(plate, _PLATE_EDGE),)
    return (Outline(plate.corners, FIRM, "grey"),)


def _draw_round_plate(plate: Plate, beyond: float) -> Outline:
    return Outline(trace_round(plate.corners, beyond), FIRM, "grey")


def _draw_bar(bar: Bar, rims: Sequence[Rim]) -> tuple[Primitive, ...]:
    match bar.use:
        case "rack":
            eyes = tuple(at for at in (bar.start, bar.end) if at not in bar.free)
            gap = find_gap_of_rack(rims, bar.actions[0]) if bar.actions else _find_last_gap(bar)
            return draw_rack(bar.start, bar.end, bar.back, gap, eyes)
        case "slot":
            return draw_slotted_bar(bar.start, bar.end, _find_slot(bar), bar.fill)
        case "broad":
            return draw_broad_bar(bar.start, bar.end)
        case "jaw":
            return draw_jaw(bar.start, bar.end, bar.back)
        case "link" | "bar" | "face":
            return (Strokes(((bar.start, bar.end),), BOLD),)
        case _:
            assert_never(bar.use)


def _find_last_gap(rack: Bar) -> Vector:
    """The gap of a rack without a gear that leaves its end solid."""
    return rack.end + unit(rack.start - rack.end) * _SOLID_END


def _find_slot(part: Bar) -> tuple[Vector, Vector]:
    """The slot leaves the ends of a bar solid, and more of an end where the bar is pinned."""
    along = unit(part.end - part.start)
    margins = [
        0.4 if any(length(end - free) < 1e-6 for free in part.free) else SOLID_AT_PIN
        for end in (part.start, part.end)
    ]
    low, high = part.start + along * margins[0], part.end - along * margins[1]
    reach = (BLOCK_LENGTH - 1.0) / 2
    for action in part.actions:
        low = min(low, action - along * reach, key=along.dot)
        high = max(high, action + along * reach, key=along.dot)
    return low, high
