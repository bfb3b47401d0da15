"""Sliders as primitives: blocks on ground guides and in the slots of moving bodies, and sleeves."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.figure.mechanism.anatomy import Anatomy
from kinegrade.figure.plane import mean
from kinegrade.figure.scene import Primitive
from kinegrade.figure.symbols import (
    BLOCK_LENGTH,
    SLOT_WIDTH,
    draw_block,
    draw_ground_slider,
    draw_sleeve,
)
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector


def draw_sleeves(anatomy: Anatomy) -> Iterator[Primitive]:
    """The sleeves about bars."""
    for sleeve in anatomy.sleeves:
        yield from draw_sleeve(sleeve.point, sleeve.direction)


def draw_blocks(anatomy: Anatomy) -> Iterator[Primitive]:
    """The blocks in slots and on ground guides; a rod needs none in its guide."""
    for symbol in anatomy.symbols:
        if symbol.block:
            at, along = symbol.block.point, symbol.block.direction
            yield draw_block(at, along, BLOCK_LENGTH - 1.0, SLOT_WIDTH)
        if symbol.guide and symbol.point and not anatomy.is_rod(symbol):
            at, along = symbol.guide.at, symbol.guide.along
            side = _choose_guide_side(anatomy.mechanism, symbol.point, along)
            yield from draw_ground_slider(at, along, side)


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
