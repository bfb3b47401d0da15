"""Bars and rings, with what is cut into them: slots in which blocks and pins slide."""

from __future__ import annotations

from math import pi

from kinegrade.figure.plane import angle_of, polar
from kinegrade.figure.scene import FIRM, PITCH, THIN, Bow, Disc, Fill, Outline, Pen, Primitive
from kinegrade.mechanics.vector import Vector

SLOT_WIDTH, BAR_WIDTH, SLEEVE_WIDTH = 1.9, 3.5, 3.2


_STEPS = 60  # corners of a round band, whose edges are drawn over them
_STEP = 2 * pi / _STEPS
SOLID_AT_PIN = 3.0  # millimetres that a slot keeps from a pin of its own body, at least


def trace_round(corners: tuple[Vector, ...], radius: float) -> tuple[Vector, ...]:
    """The outline about a convex polygon (counter-clockwise; or two points) at a distance from it,
    with round corners.
    """
    outline: list[Vector] = []
    for index, corner in enumerate(corners):
        onward = corners[(index + 1) % len(corners)] - corner
        start, end = angle_of(corner - corners[index - 1]), angle_of(onward)
        outline += Bow(corner, radius, start - pi / 2, (end - start) % (2 * pi), FIRM).path()
    return tuple(outline)


def draw_round_slot(
    centre: Vector, radius: float, pivot: Vector | None = None
) -> tuple[Primitive, ...]:
    """A ring with a slot along it and the centre line of the slot, which leaves the ring solid at a
    pivot on it; what is drawn before shows through its middle.
    """
    ring, middle = _draw_band(centre, radius, BAR_WIDTH, FIRM, "grey"), Disc(centre, radius, PITCH)
    if pivot is None:
        return (*ring, *_draw_band(centre, radius, SLOT_WIDTH, THIN, "white"), middle)
    return (*ring, Outline(_trace_round_slot(centre, radius, pivot), THIN, "white"), middle)


def _trace_round_slot(centre: Vector, radius: float, pivot: Vector) -> tuple[Vector, ...]:
    solid, half = SOLID_AT_PIN / radius, SLOT_WIDTH / 2
    first, sweep = angle_of(pivot - centre) + solid, 2 * (pi - solid)
    ends = [centre + polar(turn, radius) for turn in (first + sweep, first)]
    onward = Bow(centre, radius + half, first, sweep, THIN).path(_STEP)
    back = Bow(centre, radius - half, first + sweep, -sweep, THIN).path(_STEP)
    caps = [
        Bow(ends[0], half, first + sweep, pi, THIN).path(),
        Bow(ends[1], half, first + pi, pi, THIN).path(),
    ]
    return (*onward, *caps[0][1:-1], *back, *caps[1][1:-1])


def _draw_band(
    centre: Vector, radius: float, width: float, pen: Pen, fill: Fill
) -> tuple[Primitive, ...]:
    outer, inner = radius + width / 2, radius - width / 2
    turns = [_STEP * step for step in range(_STEPS + 1)]
    there = [centre + polar(turn, outer) for turn in turns]
    back = [centre + polar(turn, inner) for turn in reversed(turns)]
    band = Outline((*there, *back), None, fill)
    return (band, Disc(centre, outer, pen), Disc(centre, inner, pen))


def draw_slotted_bar(
    start: Vector, end: Vector, slot: tuple[Vector, Vector], fill: Fill
) -> tuple[Primitive, ...]:
    """A rounded bar with a straight slot in it, through which is seen what lies behind."""
    edge, hole = trace_round((start, end), BAR_WIDTH / 2), trace_round(slot, SLOT_WIDTH / 2)
    ground = Outline((*edge, edge[0], hole[0], *reversed(hole)), None, fill)
    return (ground, Outline(edge, FIRM), Outline(hole, THIN))


def draw_broad_bar(start: Vector, end: Vector) -> tuple[Primitive, ...]:
    """A rounded bar on which something is drawn."""
    return (Outline(trace_round((start, end), BAR_WIDTH / 2), FIRM, "grey"),)
