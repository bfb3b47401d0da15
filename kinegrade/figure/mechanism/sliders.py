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
from kinegrade.figure.symbols.ground import HATCHING, draw_ground
from kinegrade.figure.symbols.sliding import (
    BLOCK_IN_SLOT,
    SLEEVE_LENGTH,
    WIDTH_ABOUT_PIN,
    draw_block,
)
from kinegrade.mechanics.vector import Vector

_BESIDE_AXIS = 0.45  # millimetres of white on either side of an axis in hatching


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
    its rest would be a crumb. An axis passes through the hatching, which stays whole beside it.
    """
    hatching, line = draw_ground(rail.start, rail.end, rail.side)
    if isinstance(hatching, Strokes):
        whole = (stroke for stroke in hatching.lines if not _is_cut(stroke, rail))
        hatching = replace(hatching, lines=tuple(whole) or hatching.lines)
    yield hatching
    yield from (_clear_hatching(rail, axis) for axis in rail.axes)
    yield line
    yield from (_open_ground(rail, each) for each in rail.crossed)
    if rail.facing:
        yield from draw_ground(*rail.facing, -rail.side)


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
    return _clear_strip(rail, way, half + OPENING, rail.level - FIRM.width)


def _clear_hatching(rail: Rail, axis: Vector) -> Outline:
    """White about an axis in the hatching."""
    return _clear_strip(rail, axis, _BESIDE_AXIS, rail.level)


def _clear_strip(rail: Rail, way: Vector, aside: float, depth: float) -> Outline:
    """White so far on both sides of a way from the point on a rail, from a depth to the end of the
    hatching.
    """
    beside = way.turned() * aside
    depths = depth, rail.level + HATCHING
    near, far = (rail.at + way * (each / way.dot(rail.side)) for each in depths)
    return Outline((near - beside, far - beside, far + beside, near + beside), None, "white")
