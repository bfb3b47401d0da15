"""The straight parts of bodies as tactile lines, and what stands on the ground."""

from __future__ import annotations

from collections.abc import Iterator
from typing import assert_never

from kinegrade.figure.mechanism.anatomy import Anatomy
from kinegrade.figure.mechanism.geneva_wheels import trace_geneva_wheel
from kinegrade.figure.mechanism.plates import Plate
from kinegrade.figure.mechanism.rails import Rail
from kinegrade.figure.mechanism.stands import choose_upright
from kinegrade.figure.mechanism.straight_parts import Bar, GenevaWheel, Part, Rod, SlottedDisc
from kinegrade.figure.plane import SIDE_VECTORS, unit
from kinegrade.figure.scene import Disc, Outline, Primitive, Strokes
from kinegrade.figure.symbols.bars import SLOT_WIDTH, trace_round
from kinegrade.figure.tactile.piece import Way
from kinegrade.figure.tactile.sizes import (
    BLOCK,
    BODY,
    CLEAR,
    GROUND,
    HALF,
    HALF_BASE,
    OUTLINE,
    RAIL,
    RUN_ON,
    STAND,
)
from kinegrade.mechanics.vector import Vector

_LARGER = HALF / (SLOT_WIDTH / 2)  # than in print are the slots of a Geneva wheel
_GUIDE = BODY.width / 2 + CLEAR + GROUND.width / 2  # from the axis of a rod to its guide
_JAW = 16.0  # from a jaw to the fixed one that it faces


def draw_part(part: Part) -> tuple[Primitive, ...]:
    """One part of a body."""
    match part:
        case Bar(use="slot"):
            axis = _run_on(part.start, part.end, part.free)
            return (Outline(trace_round(axis, HALF), OUTLINE),)
        case Bar(use="jaw"):
            facing = -part.back * _JAW
            jaw = (part.start + facing, part.end + facing)
            return (Strokes(((part.start, part.end),), BODY), Strokes((jaw,), GROUND))
        case Bar():
            return (Strokes((_run_on(part.start, part.end, part.free),), BODY),)
        case Rod():
            return tuple(_draw_rod(part))
        case Plate():
            return (Outline(part.corners, BODY),)
        case SlottedDisc():
            slot = Outline(trace_round(part.slot, HALF), OUTLINE)
            return (Disc(part.centre, part.radius, OUTLINE), slot)
        case GenevaWheel(body, centre, pivot, pin):
            small = [at / _LARGER for at in (centre, pivot, pin)]
            outline = trace_geneva_wheel(GenevaWheel(body, *small))
            return (Outline(tuple(at * _LARGER for at in outline.corners), OUTLINE),)
        case _:
            assert_never(part)


def _run_on(start: Vector, end: Vector, free: tuple[Vector, ...]) -> tuple[Vector, Vector]:
    """The axis of a bar, beyond its free ends."""
    more = unit(end - start) * RUN_ON
    return start - more if start in free else start, end + more if end in free else end


def _draw_rod(rod: Rod) -> Iterator[Primitive]:
    """A rod between the two walls of its guide, or in its cylinder, which has a floor."""
    start, end = _run_on(rod.start, rod.end, rod.free)
    along = unit(end - start)
    above = along * (_GUIDE if rod.cylinder else 0.0)
    yield Strokes(((start, end - above),), BODY)
    if rod.cylinder:
        floor = (end - along.turned() * _GUIDE, end + along.turned() * _GUIDE)
        yield Strokes((floor,), GROUND)
    middle = end - along * (BLOCK / 2 + (0.0 if rod.cylinder else 4.0))
    for side in (along.turned() * _GUIDE, -along.turned() * _GUIDE):
        wall = (middle + side - along * (BLOCK / 2), middle + side + along * (BLOCK / 2))
        yield Strokes((wall,), GROUND)


def draw_block(at: Vector, along: Vector) -> Outline:
    """A block or a sleeve, whose long side is along its guide."""
    half, across = along * (BLOCK / 2), along.turned() * HALF
    corners = (at - half - across, at + half - across, at + half + across, at - half + across)
    return Outline(corners, OUTLINE)


def list_rail_ways(rail: Rail) -> Iterator[Way]:
    """A block on its rail, on either side; a bare end slides on the ground itself."""
    if rail.block is None:
        ends = _run_on(rail.start, rail.end, (rail.start, rail.end))
        yield Way((Strokes((ends,), GROUND),))
        return
    block = draw_block(rail.at, rail.along)
    level = HALF + OUTLINE.width / 2 + GROUND.width / 2 - 0.4
    for side in (rail.side, -rail.side):
        middle = rail.at + side * level
        wall = (middle - rail.along * RAIL, middle + rail.along * RAIL)
        yield Way((block, Strokes((wall,), GROUND)))


def list_stand_ways(name: str, anatomy: Anatomy) -> Iterator[Way]:
    """The support of a fixed pin: a triangle on a bar of ground, where it stands in print first."""
    at = anatomy.mechanism.points[name]
    usual = unit(choose_upright(name, anatomy))
    for toward in dict.fromkeys((usual, *SIDE_VECTORS.values())):
        base, across = at + toward * STAND, toward.turned() * HALF_BASE
        triangle = Outline((at, base + across * 0.7, base - across * 0.7), OUTLINE)
        yield Way((triangle, Strokes(((base - across, base + across),), GROUND)))


def draw_knife_edge(at: Vector, toward: Vector) -> tuple[Primitive, ...]:
    """A fixed edge that touches a body: a black wedge on a bar of ground."""
    base, across = at + toward * STAND, toward.turned()
    wedge = Outline((at, base + across * 3.0, base - across * 3.0), OUTLINE, "black")
    return (wedge, Strokes(((base - across * HALF_BASE, base + across * HALF_BASE),), GROUND))
