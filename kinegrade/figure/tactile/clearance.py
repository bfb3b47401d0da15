"""How far apart two things are on paper, from the edge of one to the edge of the other.

A thing is rows of straight strokes: the two ends of each, and half its width.
"""

from __future__ import annotations

from functools import lru_cache
from itertools import pairwise
from typing import assert_never

import numpy as np
from numpy.typing import NDArray

from kinegrade.figure.scene import Bow, Box, Disc, Label, Outline, Pen, Primitive, Strokes
from kinegrade.mechanics.vector import Vector

Rows = NDArray[np.float64]
_STEP = 0.09  # radians between two points of an arc: 0.1 mm from its chord at a radius of 100 mm


@lru_cache(maxsize=4096)
def list_rows(primitive: Primitive) -> Rows:
    """The strokes of a primitive; a disc without a pen is one as wide as the disc."""
    match primitive:
        case Disc(centre, radius, pen):
            if pen is None:
                return _make_rows([(centre, centre)], radius)
            circle = Bow(centre, radius, 0.0, 2 * np.pi, pen).path(_STEP)
            return _make_rows(list(pairwise(circle)), _half(pen))
        case Bow(pen=pen):
            return _make_rows(list(pairwise(primitive.path(_STEP))), _half(pen))
        case Strokes(lines, pen):
            return _make_rows(list(lines), _half(pen))
        case Outline(corners, pen):
            ends = (*corners, corners[0]) if primitive.closed else corners
            return _make_rows(list(pairwise(ends)), _half(pen))
        case Label():
            return list_box_rows(
                Box(
                    primitive.centre.x - primitive.width / 2,
                    primitive.centre.y - primitive.height / 2,
                    primitive.centre.x + primitive.width / 2,
                    primitive.centre.y + primitive.height / 2,
                )
            )
        case _:
            assert_never(primitive)


def list_box_rows(box: Box) -> Rows:
    """The sides of a box and a diagonal, which crosses whatever lies within."""
    corners = [
        Vector(box.left, box.bottom),
        Vector(box.right, box.bottom),
        Vector(box.right, box.top),
        Vector(box.left, box.top),
    ]
    diagonals = [(corners[0], corners[2]), (corners[1], corners[3])]
    return _make_rows([*pairwise((*corners, corners[0])), *diagonals], 0.0)


def measure_gap(one: Rows, other: Rows) -> float:
    """The least distance between the edges of two things; not positive where they meet."""
    first, second = one[:, None, :], other[None, :, :]
    ends = [
        _measure_to_stroke(first[..., 0:2], second),
        _measure_to_stroke(first[..., 2:4], second),
        _measure_to_stroke(second[..., 0:2], first),
        _measure_to_stroke(second[..., 2:4], first),
    ]
    apart = np.minimum.reduce(ends)
    apart = np.where(_cross(first, second), 0.0, apart)
    return float((apart - first[..., 4] - second[..., 4]).min())


def _half(pen: Pen | None) -> float:
    return pen.width / 2 if pen else 0.0


def _make_rows(lines: list[tuple[Vector, Vector]], half: float) -> Rows:
    return np.array([(start.x, start.y, end.x, end.y, half) for start, end in lines])


def _measure_to_stroke(points: Rows, strokes: Rows) -> Rows:
    """From points to the middle lines of strokes."""
    start, step = strokes[..., 0:2], strokes[..., 2:4] - strokes[..., 0:2]
    size = (step**2).sum(axis=-1)
    share = ((points - start) * step).sum(axis=-1) / np.where(size > 0, size, 1.0)
    nearest = start + np.clip(share, 0.0, 1.0)[..., None] * step
    return np.asarray(np.hypot(*np.moveaxis(points - nearest, -1, 0)))


def _cross(one: Rows, other: Rows) -> NDArray[np.bool_]:
    """Whether the middle lines of strokes cross."""
    return np.asarray(_divides(one, other) & _divides(other, one))


def _divides(line: Rows, stroke: Rows) -> NDArray[np.bool_]:
    """Whether the ends of a stroke lie on both sides of a line."""
    along = line[..., 2:4] - line[..., 0:2]
    sides = [
        along[..., 0] * (stroke[..., end + 1] - line[..., 1])
        - along[..., 1] * (stroke[..., end] - line[..., 0])
        for end in (0, 2)
    ]
    return np.asarray(sides[0] * sides[1] < 0)
