"""Belts as primitives: the strands between the pulleys, whose rims close them."""

from __future__ import annotations

from kinegrade.figure.mechanism.anatomy import Anatomy
from kinegrade.figure.scene import THIN, Primitive, Strokes


def draw_belts(anatomy: Anatomy) -> tuple[Primitive, ...]:
    """The two strands of each belt."""
    return tuple(Strokes(symbol.strands, THIN) for symbol in anatomy.symbols if symbol.strands)
