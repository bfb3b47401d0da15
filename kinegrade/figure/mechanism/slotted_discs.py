"""Discs with a straight slot: beside the only point of a body, along a radius where the author says
so, or the four open slots of a Geneva wheel.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import cos, pi

from kinegrade.figure.joints.symbol import Feature
from kinegrade.figure.mechanism.straight_parts import SlottedDisc
from kinegrade.figure.plane import angle_of, length, on_line, polar, unit
from kinegrade.figure.scene import FIRM, Bow, Disc, Outline, Primitive
from kinegrade.figure.symbols import SLOT_WIDTH, trace_round
from kinegrade.mechanics.vector import Vector

_OVERHANG = 8.0  # millimetres of a disc beyond what slides in its slot
_MOUTH = 4.0  # the same of a Geneva wheel, whose slots are open
_HUB, _RIM = 3.2, 2.0  # millimetres between a slot and the centre, and the edge
_SLOTS = 4  # of a Geneva wheel
_WAIST = 0.55  # of the radius of a Geneva wheel: how near its hollows come to its centre


def find_slotted_disc(
    body: str, points: Sequence[Vector], group: Sequence[Feature], shapes: Mapping[str, str]
) -> SlottedDisc | None:
    """The disc of a body in whose slot another acts; None where the body is a bar."""
    line, action, shape = group[0].line, group[0].action, shapes.get(body)
    if group[0].use != "slot" or not points:
        return None
    beside = len(points) == 1 and not on_line(points[0], line)
    if not beside and shape not in ("disc", "geneva"):
        return None
    centre, geneva = points[0], shape == "geneva"
    radius = length(action - centre) + (_MOUTH if geneva else _OVERHANG)
    if on_line(centre, line):
        out = unit(action - centre)
        slot = (centre + out * _HUB, centre + out * (radius - _RIM))
    else:
        slot = _find_chord(centre, radius, action, unit(line.direction))
    return SlottedDisc(body, centre, radius, slot, geneva)


def _find_chord(
    centre: Vector, radius: float, action: Vector, along: Vector
) -> tuple[Vector, Vector]:
    """A slot beside the centre, from edge to edge."""
    across = (action - centre).dot(along.turned())
    half = (radius**2 - across**2) ** 0.5 - _RIM
    middle = centre + along.turned() * across
    return middle - along * half, middle + along * half


def draw_slotted_disc(disc: SlottedDisc) -> tuple[Primitive, ...]:
    """The disc with its slot, or a Geneva wheel."""
    if disc.geneva:
        return (Outline(tuple(_trace_geneva(disc)), FIRM, "grey"),)
    slot = Outline(trace_round(disc.slot, SLOT_WIDTH / 2), FIRM, "white")
    return (Disc(disc.centre, disc.radius, FIRM, "grey"), slot)


def _trace_geneva(disc: SlottedDisc) -> Iterator[Vector]:
    """Slot by slot: from its mouth to its round end and back, then the hollow up to the next."""
    start, end = disc.slot
    facing, step, half = angle_of(end - start), 2 * pi / _SLOTS, SLOT_WIDTH / 2
    depth = length(start - disc.centre)
    lip = 2.5 * half / disc.radius  # the angle between the middle of a slot and its hollow
    for number in range(_SLOTS):
        turn = facing + number * step
        out, across = polar(turn), polar(turn).turned() * half
        mouth = disc.centre + out * disc.radius
        yield disc.centre + polar(turn - lip, disc.radius)
        yield mouth - across
        yield from reversed(Bow(disc.centre + out * depth, half, turn + pi / 2, pi, FIRM).path())
        yield mouth + across
        yield disc.centre + polar(turn + lip, disc.radius)
        yield from _trace_hollow(disc, turn + step / 2, step / 2 - lip)


def _trace_hollow(disc: SlottedDisc, turn: float, reach: float) -> tuple[Vector, ...]:
    """The arc that the locking disc of the driver fits, within an angle on either side of a
    direction: through two points of the rim and the waist between them.
    """
    waist = _WAIST * disc.radius
    away = (disc.radius**2 - waist**2) / (2 * (disc.radius * cos(reach) - waist))
    middle = disc.centre + polar(turn, away)
    first = angle_of(disc.centre + polar(turn - reach, disc.radius) - middle)
    last = angle_of(disc.centre + polar(turn + reach, disc.radius) - middle)
    sweep = (last - first) % (2 * pi) - 2 * pi
    return Bow(middle, away - waist, first, sweep, FIRM).path(0.08)[1:-1]
