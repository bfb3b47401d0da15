"""Sliders as primitives: blocks on ground guides and in the slots of moving bodies, and sleeves."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from msgspec.structs import replace

from kinegrade.figure.mechanism.anatomy import Anatomy
from kinegrade.figure.mechanism.pins import find_swivels
from kinegrade.figure.mechanism.rails import Rail
from kinegrade.figure.mechanism.straight.leaving_bars import OPENING, Leaving
from kinegrade.figure.plane import NEAR, length
from kinegrade.figure.scene import FIRM, Outline, Primitive, Strokes
from kinegrade.figure.symbols.bars import SLEEVE_WIDTH, SLOT_WIDTH
from kinegrade.figure.symbols.ground import HATCHING, HATCHING_DEPTH, draw_ground
from kinegrade.figure.symbols.sliding import (
    BLOCK_IN_SLOT,
    SLEEVE_LENGTH,
    WIDTH_ABOUT_PIN,
    draw_block,
)
from kinegrade.mechanics.vector import Vector

_LEAN = -1.0  # millimetres along the ground to which a stroke of hatching goes in each of depth


def draw_sleeves(anatomy: Anatomy) -> Iterator[Primitive]:
    """The sleeves about bars, wider about a pin, which sits in one beside the bar."""
    at = [anatomy.mechanism.points[name] for name in find_swivels(anatomy)]
    for sleeve in anatomy.sleeves:
        turns = any(length(sleeve.point - each) < NEAR for each in at)
        width = WIDTH_ABOUT_PIN if turns else SLEEVE_WIDTH
        yield draw_block(sleeve.point, sleeve.direction, SLEEVE_LENGTH, width)


def draw_blocks(anatomy: Anatomy) -> Iterator[Primitive]:
    """The blocks in slots."""
    for symbol in anatomy.symbols:
        if symbol.block:
            at, along = symbol.block.point, symbol.block.direction
            yield draw_block(at, along, BLOCK_IN_SLOT, SLOT_WIDTH)


def draw_ground_sliders(rails: Iterable[Rail]) -> Iterator[Primitive]:
    """The blocks on ground guides; a rod needs none in its guide, nor an end that is bare."""
    for rail in rails:
        yield from _draw_rail(rail)
        if rail.block:
            yield draw_block(rail.at, rail.along, rail.block.length, rail.block.width)


def _draw_rail(rail: Rail) -> Iterator[Primitive]:
    """The ground with its openings; a stroke of hatching that one would cut is left out whole, as
    its rest would be a crumb. An axis passes over the hatching, between strokes along it.
    """
    between = _find_between_strokes(rail) if rail.axes else None
    hatching, line = draw_ground(rail.start, rail.end, rail.side, between=between)
    if isinstance(hatching, Strokes):
        whole = (stroke for stroke in hatching.lines if not _is_cut(stroke, rail))
        hatching = replace(hatching, lines=tuple(whole) or hatching.lines)
    yield hatching
    yield line
    yield from (_open_ground(rail, each) for each in rail.crossed)
    if rail.facing:
        yield from _draw_rail(rail.facing)


def _find_between_strokes(rail: Rail) -> float:
    """How far from the start of a rail two strokes begin between which the axis passes that is
    most nearly along them.
    """
    slopes = [axis.dot(rail.along) / axis.dot(rail.side) for axis in rail.axes]
    slope = min(slopes, key=lambda each: abs(each - _LEAN))
    middle = HATCHING_DEPTH / 2
    foot = slope * (rail.level + middle) - _LEAN * middle
    return float((rail.at - rail.start).dot(rail.along) + foot)


def _is_cut(stroke: tuple[Vector, Vector], rail: Rail) -> bool:
    """Whether a stroke of hatching reaches into the white about a bar."""
    for way, half in rail.crossed:
        asides, reach = [(end - rail.at).cross(way) for end in stroke], half + OPENING
        if min(asides) < reach and max(asides) > -reach:
            return True
    return False


def _open_ground(rail: Rail, bar: Leaving) -> Outline:
    """White about a bar through the ground and its hatching."""
    way, half = bar
    beside = rail.along * ((half + OPENING) / way.cross(rail.along))
    depths = rail.level - FIRM.width, rail.level + HATCHING
    near, far = (rail.at + way * (each / way.dot(rail.side)) for each in depths)
    return Outline((near - beside, far - beside, far + beside, near + beside), None, "white")
