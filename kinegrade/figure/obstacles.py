"""What is drawn so far, as columns of numbers, ready to be asked what a rectangle laid over it would cover.

Costs are whole numbers, so that a sum does not depend on the order of its terms, and what merely touches is
free by a margin far above rounding: the same figure comes out on every machine.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

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
SAME_AXIS = 0.05  # millimetres within which two lines count as one


class Obstacles:
    """Lines and rings, each a column of numbers; never changed, only extended.

    A line has x, y of its start, the steps dx, dy to its end, half of its pen's width, its cost, and the box
    it lies in: left, bottom, right, top. A ring has x, y, inner radius, outer radius, cost.
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
        self._lines: Floats = _joined(base._lines if base else None, lines, 10)
        self._rings: Floats = _joined(base._rings if base else None, rings, 5)

    def with_drawn(self, primitives: Iterable[Primitive]) -> Obstacles:
        """These obstacles and some more."""
        return Obstacles(primitives, self)

    def under_boxes(self, centres: Floats, width: float, height: float) -> Floats:
        """For an upright box about each centre (rows x, y) the sum of what it covers; zero when it is free."""
        middles, half = centres.T[:, :, None], np.array(((width / 2,), (height / 2,)))
        lines = self._near(centres.min(axis=0) - half[:, 0], centres.max(axis=0) + half[:, 0])
        met = _clipped(lines[:2, None] - middles, lines[2:4, None], (half + lines[4])[:, None])
        rings = _encircled(self._rings[:2, None] - middles, half[:, None], self._rings[2], self._rings[3])
        return np.asarray(met @ lines[5] + rings @ self._rings[4])

    def along(self, paths: Sequence[Sequence[Segment]], shared: bool) -> Floats:
        """For each path of straight pieces the cost of drawing something thin along it.

        What a path meets counts once; when lines may be shared, a thin line on the axis of a piece not at all.
        """
        owners = np.array([number for number, path in enumerate(paths) for _ in path], dtype=int)
        costs = np.zeros(len(paths))
        if len(owners):
            pieces = np.array([(*start, *end) for path in paths for start, end in path], dtype=float)
            starts = np.flatnonzero(np.diff(owners, prepend=-1))
            for met, cost in self._under_strips(pieces, SHARED_ROOM if shared else ROOM, shared):
                costs[owners[starts]] += np.logical_or.reduceat(met, starts) @ cost
        return costs

    def joins(self, start: Vector, end: Vector, gap: float) -> bool:
        """Whether a straight line is drawn between two points, to within a gap at either end."""
        size = float(np.hypot(*(end - start)))
        if size < 2 * gap:
            return False
        toward = (end - start) / size
        line_x, line_y, dx, dy = self._lines[:4]
        near, near_off = _turned(np.array((line_x - start.x, line_y - start.y)), np.array(toward))
        far, far_off = _turned(np.array((line_x + dx - start.x, line_y + dy - start.y)), np.array(toward))
        on_axis = (np.abs(near_off) < SAME_AXIS) & (np.abs(far_off) < SAME_AXIS)
        ends = (np.abs(np.minimum(near, far)) <= gap) & (np.abs(np.maximum(near, far) - size) <= gap)
        return bool((on_axis & ends).any())

    def _under_strips(
        self, pieces: Floats, half: float, shared: bool
    ) -> tuple[tuple[Flags, Floats], tuple[Flags, Floats]]:
        """Which lines and rings, and at what cost, are met by strips whose axes are the pieces (x, y, x, y)."""
        starts, ends = pieces.T[:2, :, None], pieces.T[2:, :, None]
        middles, steps = (starts + ends) / 2, ends - starts
        size = np.maximum(np.hypot(steps[0], steps[1]), TOUCH)
        toward = steps / size
        reach = float(size.max()) / 2 + half
        lines = self._near(middles.min(axis=1)[:, 0] - reach, middles.max(axis=1)[:, 0] + reach)
        start = _turned(lines[:2, None] - middles, toward)
        step = _turned(lines[2:4, None], toward)
        met = _clipped(start, step, np.array((size / 2 + lines[4], np.broadcast_to(half + lines[4], step[1].shape))))
        if shared:
            met &= (np.abs(start[1]) > SAME_AXIS) | (np.abs(start[1] + step[1]) > SAME_AXIS) | (lines[5] > COST_THIN)
        inner, outer, ring_cost = self._rings[2:]
        around = np.array((size / 2, np.full_like(size, half)))
        rings = _encircled(_turned(self._rings[:2, None] - middles, toward), around, inner, outer)
        return (met, lines[5]), (rings, ring_cost)

    def _near(self, lower: Floats, upper: Floats) -> Floats:
        """The lines that come near a box (its corners x, y): most do not, and clipping is what costs."""
        within = (self._lines[8:] >= lower[:, None]) & (self._lines[6:8] <= upper[:, None])
        return self._lines[:6].compress(within[0] & within[1], axis=1)


def _clipped(start: Floats, step: Floats, half: Floats) -> Flags:
    """Whether lines meet boxes about the origin, given by their half sizes (Liang and Barsky); x, y come first.

    On its way, in shares of the step, a coordinate enters and leaves the band about zero.
    """
    pace = 1.0 / np.where(np.abs(step) < 1e-9, 1e-9, step)
    middle, reach = start * -pace, (half - TOUCH) * np.abs(pace)
    enters, leaves = middle - reach, middle + reach
    first = np.maximum(np.maximum(enters[0], enters[1]), 0.0)
    return np.asarray(first <= np.minimum(np.minimum(leaves[0], leaves[1]), 1.0))


def _encircled(centre: Floats, half: Floats, inner: Floats, outer: Floats) -> Flags:
    """Whether rings meet boxes about the origin: the box's nearest point within, its farthest without."""
    away, reach = np.abs(centre), half - TOUCH
    near, far = np.maximum(away - reach, 0.0) ** 2, (away + reach) ** 2
    return np.asarray((near[0] + near[1] <= outer**2) & (far[0] + far[1] >= inner**2))


def _turned(vectors: Floats, toward: Floats) -> Floats:
    """The components of vectors along and across a direction."""
    (x, y), (along, across) = vectors, toward
    return np.array((x * along + y * across, y * along - x * across))


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
    return (x, y, to_x - x, to_y - y, pen, cost, left - pen, bottom - pen, right + pen, top + pen)


def _ring(disc: Disc) -> tuple[float, ...]:
    """A small filled disc counts whole, a larger one by its line only."""
    pen = disc.pen.width / 2 if disc.pen else 0.0
    solid = disc.fill in ("black", "white") and disc.radius < 3
    cost = COST_BOLD if solid or pen >= BOLD.width / 2 else COST_FIRM
    return (*disc.centre, 0.0 if solid else max(disc.radius - pen, 0.0), disc.radius + pen, cost)


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
