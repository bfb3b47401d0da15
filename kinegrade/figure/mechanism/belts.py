"""Belts and ropes as primitives: the strands between pulleys, whose rims close them, and what hangs
on wheels.
"""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.figure.mechanism.anatomy import Anatomy
from kinegrade.figure.plane import NEAR, length, same_line, unit
from kinegrade.figure.scene import FIRM, THIN, Outline, Primitive, Strokes
from kinegrade.figure.symbols.sliding import draw_block
from kinegrade.mechanics.vector import Vector

_LOAD = 6.0  # millimetres, the sides of a load


def draw_belts(anatomy: Anatomy) -> tuple[Primitive, ...]:
    """The two strands of each belt."""
    return tuple(Strokes(symbol.strands, THIN) for symbol in anatomy.symbols if symbol.strands)


def draw_ropes(anatomy: Anatomy) -> Iterator[Strokes | Outline]:
    """The ropes, as thin as belts, to their ends or to the farthest other wheel on them, each with
    its load if it has one.
    """
    ropes = [symbol.hanging for symbol in anatomy.symbols if symbol.hanging]
    for rope in ropes:
        same = [
            other for other in ropes if other.body == rope.body and same_line(other.line, rope.line)
        ]
        ends = [rope.end, *(other.start for other in same)]
        end = max(ends, key=lambda at: length(at - rope.start))
        if length(end - rope.start) > NEAR:
            yield Strokes(((rope.start, end),), THIN)
            if rope.loaded:
                yield _draw_load(end, unit(end - rope.start))


def _draw_load(top: Vector, down: Vector) -> Outline:
    corners = draw_block(top + down * (_LOAD / 2), down, _LOAD, _LOAD).corners
    return Outline(corners, FIRM, "grey")
