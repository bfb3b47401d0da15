"""Sliders as primitives: blocks on ground guides and in the slots of moving bodies, and sleeves."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from kinegrade.figure.mechanism.anatomy import Anatomy
from kinegrade.figure.mechanism.rails import Rail
from kinegrade.figure.scene import Primitive
from kinegrade.figure.symbols import (
    BLOCK_LENGTH,
    SLOT_WIDTH,
    draw_block,
    draw_ground,
    draw_sleeve,
)


def draw_sleeves(anatomy: Anatomy) -> Iterator[Primitive]:
    """The sleeves about bars."""
    for sleeve in anatomy.sleeves:
        yield from draw_sleeve(sleeve.point, sleeve.direction)


def draw_blocks(anatomy: Anatomy) -> Iterator[Primitive]:
    """The blocks in slots."""
    for symbol in anatomy.symbols:
        if symbol.block:
            at, along = symbol.block.point, symbol.block.direction
            yield draw_block(at, along, BLOCK_LENGTH - 1.0, SLOT_WIDTH)


def draw_ground_sliders(rails: Iterable[Rail]) -> Iterator[Primitive]:
    """The blocks on ground guides; a rod needs none in its guide, nor an end that is bare."""
    for rail in rails:
        yield from draw_ground(rail.start, rail.end, rail.side)
        if rail.block:
            yield draw_block(rail.at, rail.along, rail.block.length, rail.block.width)
