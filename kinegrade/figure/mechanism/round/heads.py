"""The pointed heads of followers, whose tips run on the rim of a cam."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.figure.mechanism.anatomy import Anatomy
from kinegrade.figure.plane import unit
from kinegrade.figure.scene import FIRM, Outline, Primitive

_TAPER, _LENGTH, _HALF_WIDTH = 2.4, 4.6, 1.1  # millimetres


def draw_heads(anatomy: Anatomy) -> Iterator[Primitive]:
    """A head at the lower end of each rod that runs on a rim."""
    for name, rod in anatomy.heads.items():
        tip, along = anatomy.mechanism.points[name], unit(rod.end - rod.start)
        across = along.turned() * _HALF_WIDTH
        shoulder, top = tip + along * _TAPER, tip + along * _LENGTH
        corners = (tip, shoulder - across, top - across, top + across, shoulder + across)
        yield Outline(corners, FIRM, "white")
