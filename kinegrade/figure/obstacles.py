"""What is drawn so far, as columns of numbers, ready to be asked what a rectangle laid over it would cover.

Costs are whole numbers, so that a sum does not depend on the order of its terms, and what merely touches is
free by a margin far above rounding: the same figure comes out on every machine.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import accumulate
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinegrade.figure.scene import (
    BOLD,
    THIN,
    Bow,
    Disc,
    Label,
    Outline,
    Primitive,
    Strokes,
)
from kinegrade.mechanics.vector import Vector

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
Segment = tuple[Vector, Vector]

COST_LABEL, COST_BOLD, COST_FIRM, COST_THIN = 1000.0, 100.0, 10.0, 4.0
TOUCH = 1e-6  # millimetres by which two things may overlap and still only touch
ROOM, SHARED_ROOM = 0.8, 0.6  # millimetres to be kept free on either side of a mark; less for thin lines
LEAST = 1e-9  # millimetres: a step that is shorter goes nowhere
SAME_AXIS = 0.05  # millimetres within which two lines count as one


class Obstacles:
    """Lines and rings, each a column of numbers; never changed, only extended.

    A line has x, y of its start, the steps dx, dy to its end, their negative inverses, half of its pen's width, its
    cost, and the box it lies in: left, bottom, right, top. A ring has x, y, inner radius, outer radius, cost, and its
    box.
    """

    def __init__(self, primitives: Iterable[Primitive] = (), base: Obstacles | None = None) -> None:
        lines: list[tuple[float, ...]] = []
        rings: list[tuple[float, ...]] = []
        for primitive in primitives:
            if isinstance(primitive, Label):
                lines.extend(_label(primitive))
            elif isinstance(primitive, Disc):
                rings.append(_ring(primitive))
            else:
                lines.extend(_segments(primitive))
        self._lines: Floats = _joined(base._lines if base else None, lines, 12)
        self._rings: Floats = _joined(base._rings if base else None, rings, 9)

    def with_drawn(self, primitives: Iterable[Primitive]) -> Obstacles:
        """These obstacles and some more."""
        return Obstacles(primitives, self)

    def under_boxes(self, centres: Floats, width: float, height: float) -> Floats:
        """For an upright box about each centre (rows x, y) the sum of what it covers; zero when it is free."""
        across, upward = centres[:, :1], centres[:, 1:]
        half_width, half_height = width / 2, height / 2
        lower, upper = centres.min(axis=0), centres.max(axis=0)
        box = (lower[0] - half_width, lower[1] - half_height, upper[0] + half_width, upper[1] + half_height)
        x, y, _, _, pace_x, pace_y, pen, cost = _near(self._lines, box)
        covered = _clipped(_crossing(x - across, pace_x, half_width + pen),
                           _crossing(y - upward, pace_y, half_height + pen)) @ cost
        x, y, inner, outer, cost = _near(self._rings, box)
        if len(cost):
            covered += _encircled((x - across, y - upward), (half_width, half_height), inner, outer) @ cost
        return np.asarray(covered)

    def along(self, paths: Sequence[Sequence[Segment]], shared: bool) -> Floats:
        """For each path of straight pieces the cost of drawing something thin along it.

        What a path meets counts once; when lines may be shared, a thin line on the axis of a piece not at all.
        """
        costs = np.zeros(len(paths))
        owners = [number for number, path in enumerate(paths) if path]
        if owners:
            pieces = np.array([(*start, *end) for path in paths for start, end in path], dtype=float)
            starts = [0, *accumulate(len(paths[owner]) for owner in owners[:-1])]
            for met, cost in self._under_strips(pieces, SHARED_ROOM if shared else ROOM, shared):
                costs[owners] += np.logical_or.reduceat(met, starts) @ cost
        return costs

    def joins(self, start: Vector, end: Vector, gap: float) -> bool:
        """Whether a straight line is drawn between two points, to within a gap at either end."""
        size = float(np.hypot(*(end - start)))
        if size < 2 * gap:
            return False
        toward = (end - start) / size
        line_x, line_y, dx, dy = self._lines[:4]
        near, near_off = _turned(line_x - start.x, line_y - start.y, *toward)
        far, far_off = _turned(line_x + dx - start.x, line_y + dy - start.y, *toward)
        on_axis = (np.abs(near_off) < SAME_AXIS) & (np.abs(far_off) < SAME_AXIS)
        ends = (np.abs(np.minimum(near, far)) <= gap) & (np.abs(np.maximum(near, far) - size) <= gap)
        return bool((on_axis & ends).any())

    def _under_strips(
        self, pieces: Floats, half: float, shared: bool
    ) -> tuple[tuple[Flags, Floats], tuple[Flags, Floats]]:
        """Which lines and rings, and at what cost, are met by strips whose axes are the pieces (x, y, x, y)."""
        (start_x, start_y), (end_x, end_y) = pieces.T[:2, :, None], pieces.T[2:, :, None]
        middle_x, middle_y = (start_x + end_x) / 2, (start_y + end_y) / 2
        step_x, step_y = end_x - start_x, end_y - start_y
        size = np.maximum(np.hypot(step_x, step_y), TOUCH)
        toward = step_x / size, step_y / size
        reach = float(size.max()) / 2 + half
        box = (middle_x.min() - reach, middle_y.min() - reach, middle_x.max() + reach, middle_y.max() + reach)
        x, y, dx, dy, _, _, pen, cost = _near(self._lines, box)
        along, off = _turned(x - middle_x, y - middle_y, *toward)
        further, sideways = _turned(dx, dy, *toward)
        met = _clipped(_crossing(along, _pace(further), size / 2 + pen), _crossing(off, _pace(sideways), half + pen))
        if shared:
            met &= (np.abs(off) > SAME_AXIS) | (np.abs(off + sideways) > SAME_AXIS) | (cost > COST_THIN)
        x, y, inner, outer, ring_cost = _near(self._rings, box)
        centre = _turned(x - middle_x, y - middle_y, *toward)
        return (met, cost), (_encircled(centre, (size / 2, half), inner, outer), ring_cost)


def _near(things: Floats, box: tuple[float, float, float, float]) -> Floats:
    """The lines or rings that come near a box, without their own boxes: most do not, and clipping is what costs."""
    left, bottom, right, top = box
    own = things[-4:]
    within = (own[2] >= left) & (own[3] >= bottom) & (own[0] <= right) & (own[1] <= top)
    return things[:-4].compress(within, axis=1)


def _pace(step: Floats) -> Floats:
    """The negative inverse of steps; of next to nothing for those of none."""
    return np.asarray(-1.0 / np.where(np.abs(step) < LEAST, LEAST, step))


def _crossing(start: Floats, pace: Floats, half: Floats) -> tuple[Floats, Floats]:
    """Where on its way, in shares of the step, a coordinate enters and leaves the band about zero."""
    middle, reach = start * pace, (half - TOUCH) * np.abs(pace)
    return middle - reach, middle + reach


def _clipped(across: tuple[Floats, Floats], upward: tuple[Floats, Floats]) -> Flags:
    """Whether lines meet boxes, from where they cross the bands of either coordinate (Liang and Barsky)."""
    first = np.maximum(np.maximum(across[0], upward[0]), 0.0)
    return np.asarray(first <= np.minimum(np.minimum(across[1], upward[1]), 1.0))


def _encircled(centre: tuple[Floats, Floats], half: tuple[Any, Any], inner: Floats, outer: Floats) -> Flags:
    """Whether rings meet boxes about the origin: the box's nearest point within, its farthest without."""
    x, y, reach_x, reach_y = np.abs(centre[0]), np.abs(centre[1]), half[0] - TOUCH, half[1] - TOUCH
    near = np.maximum(x - reach_x, 0.0) ** 2 + np.maximum(y - reach_y, 0.0) ** 2
    return np.asarray((near <= outer**2) & ((x + reach_x) ** 2 + (y + reach_y) ** 2 >= inner**2))


def _turned(x: Any, y: Any, along: Any, across: Any) -> tuple[Floats, Floats]:
    """The components of vectors along and across a direction."""
    return x * along + y * across, y * along - x * across


def _joined(base: Floats | None, found: list[tuple[float, ...]], numbers: int) -> Floats:
    added = np.array(found, dtype=float).reshape(-1, numbers).T
    return added if base is None else np.concatenate((base, added), axis=1) if found else base


def _label(label: Label) -> list[tuple[float, ...]]:
    """A label's box as its longer middle line, with a pen as wide as the box is narrow, and its diagonals.

    The middle line is exact against upright boxes; the diagonals reach the corners for strips at an angle.
    """
    half = min(label.width, label.height) / 2
    along, rise = Vector(label.width / 2, label.height / 2), Vector(label.width / 2, -label.height / 2)
    middle = Vector(along.x - half, along.y - half)
    reaches = ((middle, half), (along, 0.0), (rise, 0.0))
    return [_line(label.centre - reach, label.centre + reach, pen, COST_LABEL) for reach, pen in reaches]


def _line(start: Vector, end: Vector, pen: float, cost: float) -> tuple[float, ...]:
    (x, y), (to_x, to_y) = start, end
    left, right = (x, to_x) if x < to_x else (to_x, x)
    bottom, top = (y, to_y) if y < to_y else (to_y, y)
    dx, dy = to_x - x, to_y - y
    pace = -1.0 / (dx if abs(dx) >= LEAST else LEAST), -1.0 / (dy if abs(dy) >= LEAST else LEAST)
    return (x, y, dx, dy, *pace, pen, cost, left - pen, bottom - pen, right + pen, top + pen)


def _ring(disc: Disc) -> tuple[float, ...]:
    """A small filled disc counts whole, a larger one by its line only."""
    pen = disc.pen.width / 2 if disc.pen else 0.0
    solid = disc.fill in ("black", "white") and disc.radius < 3
    cost = COST_BOLD if solid or pen >= BOLD.width / 2 else COST_FIRM
    (x, y), outer = disc.centre, disc.radius + pen
    inner = 0.0 if solid else max(disc.radius - pen, 0.0)
    return (x, y, inner, outer, cost, x - outer, y - outer, x + outer, y + outer)


def _segments(primitive: Strokes | Outline | Bow) -> list[tuple[float, ...]]:
    width = primitive.pen.width if primitive.pen else 0.0
    cost = COST_BOLD if width >= BOLD.width else COST_FIRM if width > THIN.width else COST_THIN
    return [_line(start, end, width / 2, cost) for start, end in _pieces(primitive)]


def _pieces(primitive: Strokes | Outline | Bow) -> Iterable[Segment]:
    if isinstance(primitive, Strokes):
        return primitive.lines
    path = primitive.path() if isinstance(primitive, Bow) else primitive.corners
    closing = path[:1] if isinstance(primitive, Outline) and primitive.closed else ()
    return zip(path, path[1:] + closing, strict=False)
