"""Discs with a straight slot: beside the only point of a body that turns about this, or along a
radius where the author says so.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from kinegrade.figure.joints.symbol import Feature, Rim, Symbol
from kinegrade.figure.mechanism.straight_parts import Part, SlottedDisc
from kinegrade.figure.plane import length, on_line, unit
from kinegrade.figure.scene import FIRM, PITCH, Disc, Outline, Primitive, Strokes
from kinegrade.figure.symbols.bars import SLOT_WIDTH, trace_round
from kinegrade.mechanics.joints import Line
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector

_OVERHANG = 12.0  # millimetres of a disc beyond what slides in its slot, and in a bar across it
_HUB, _RIM = 3.2, 2.0  # millimetres between a slot and the centre, and the edge


def find_slotted_disc(
    mechanism: Mechanism,
    body: Body,
    group: Sequence[Feature],
    symbols: Sequence[Symbol],
    shapes: Mapping[str, str],
) -> SlottedDisc | None:
    """The disc of a body in whose slot another acts; None where the body is a bar."""
    points = [mechanism.points[name] for name in body.points]
    line, action = group[0].line, group[0].action
    if group[0].use != "slot" or not points:
        return None
    beside = len(points) == 1 and not on_line(points[0], line)
    round_one = beside and _turns_about_point(mechanism, body, symbols)
    if not round_one and shapes.get(body.name) != "disc":
        return None
    centre = points[0]
    radius = length(action - centre) + _OVERHANG
    if on_line(centre, line):
        out = unit(action - centre)
        slot = (centre + out * _HUB, centre + out * (radius - _RIM))
    else:
        slot = _find_chord(centre, radius, action, unit(line.direction))
    return SlottedDisc(body.name, centre, radius, slot)


def _turns_about_point(mechanism: Mechanism, body: Body, symbols: Sequence[Symbol]) -> bool:
    """Whether a body turns about its only point."""
    turning = any(each.point in body.points and body.name in each.turning for each in symbols)
    return turning and body.name not in mechanism.find_translating()


def _find_chord(
    centre: Vector, radius: float, action: Vector, along: Vector
) -> tuple[Vector, Vector]:
    """A slot beside the centre, from edge to edge."""
    across = (action - centre).dot(along.turned())
    half = (radius**2 - across**2) ** 0.5 - _RIM
    middle = centre + along.turned() * across
    return middle - along * half, middle + along * half


def draw_slotted_disc(disc: SlottedDisc) -> tuple[Primitive, ...]:
    """The disc with its slot; where that is beside the centre, its axis too, to which its distance
    is measured.
    """
    slot = Outline(trace_round(disc.slot, SLOT_WIDTH / 2), FIRM, "white")
    whole = (Disc(disc.centre, disc.radius, FIRM, "grey"), slot)
    start, end = disc.slot
    beside = not on_line(disc.centre, Line(start, end - start))
    return (*whole, Strokes((disc.slot,), PITCH)) if beside else whole


def list_slotted_rims(parts: Iterable[Part]) -> Iterator[Rim]:
    """The circles of slotted discs, which no joint mentions."""
    for part in parts:
        if isinstance(part, SlottedDisc):
            start, _ = part.slot
            yield Rim(part.body, "", part.centre, part.radius, "edge", False, start, start)
