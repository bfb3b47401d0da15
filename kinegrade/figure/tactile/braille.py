"""Braille as dots on paper: the cells of a label as discs, and the room that they take."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.figure.scene import Box, Disc
from kinegrade.figure.tactile.sizes import CELL, CELL_DOT, CELL_RADIUS
from kinegrade.mechanics.vector import Vector

_FIRST_CELL = 0x2800  # of Unicode's Braille patterns: each dot is a bit
_DOTS = {0x01: (0, 0), 0x02: (0, 1), 0x04: (0, 2), 0x08: (1, 0), 0x10: (1, 1), 0x20: (1, 2)}


def measure_label(cells: str) -> tuple[float, float]:
    """Width and height of the room of a label, from the edges of its outermost dots."""
    width = (len(cells) - 1) * CELL + CELL_DOT + 2 * CELL_RADIUS
    return width, 2 * CELL_DOT + 2 * CELL_RADIUS


def find_label_box(cells: str, middle: Vector) -> Box:
    """The room of a label about its middle."""
    width, height = measure_label(cells)
    return Box(
        middle.x - width / 2, middle.y - height / 2, middle.x + width / 2, middle.y + height / 2
    )


def draw_label(cells: str, middle: Vector) -> tuple[Disc, ...]:
    """The dots of a label about its middle."""
    box = find_label_box(cells, middle)
    first = Vector(box.left + CELL_RADIUS, box.top - CELL_RADIUS)
    return tuple(
        Disc(first + step, CELL_RADIUS, None, "black")
        for place, cell in enumerate(cells)
        for step in _list_steps(ord(cell) - _FIRST_CELL, place * CELL)
    )


def _list_steps(bits: int, along: float) -> Iterator[Vector]:
    """From the place of the first dot of a label to each dot of a cell."""
    for bit, (column, row) in _DOTS.items():
        if bits & bit:
            yield Vector(along + column * CELL_DOT, -row * CELL_DOT)
