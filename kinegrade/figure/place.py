"""Where labels go: last, against everything drawn, at the first of their candidate spots that is free."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import pi

import numpy as np
from numpy.typing import NDArray

from kinegrade.figure.extent import symbol_size
from kinegrade.figure.plane import length
from kinegrade.figure.scene import (
    BOLD,
    THIN,
    Bow,
    Disc,
    Label,
    Outline,
    Primitive,
    Strokes,
    box_of,
)
from kinegrade.mechanics.vector import Vector

Floats = NDArray[np.float64]

CLEARANCE = 0.25  # millimetres kept free around a label
FARTHER = 0.04  # cost of each later spot: a hundred of them weigh as much as one thin line covered
LABEL_WEIGHT = 3.0  # a symbol on a line hurts more than a line across a line
NEAR_SPOTS = 20  # spots looked at when alternatives of a mark are compared
COST_LABEL, COST_BOLD, COST_FIRM, COST_THIN = 1000.0, 100.0, 10.0, 4.0
_TURNS = np.array((2, 6, -2, -6, 4, -4, 0, 8, 1, 3, 5, 7, -1, -3, -5, -7)) * (pi / 8)
_TOWARD = np.stack((np.cos(_TURNS), np.sin(_TURNS)), axis=1).round(9)
_RINGS = np.array((1.2, 2.0, 3.2, 4.8, 6.8, 9.0))


@dataclass(frozen=True)
class Wish:
    """A label to be placed: its symbol and the centres it may have (rows x, y), the best first."""

    symbol: str
    spots: Floats


class Obstacles:
    """What is drawn so far, ready to be asked what a box would cover; never changed, only extended."""

    def __init__(self, primitives: Iterable[Primitive] = (), base: Obstacles | None = None) -> None:
        lines: list[tuple[float, ...]] = []
        circles: list[tuple[float, ...]] = []
        boxes: list[tuple[float, ...]] = []
        for primitive in primitives:
            if isinstance(primitive, Label):
                box = box_of(primitive)
                boxes.append((box.left, box.bottom, box.right, box.top))
            elif isinstance(primitive, Disc):
                circles.append(_ring(primitive))
            else:
                lines.extend(_segments(primitive))
        self._lines: Floats = _stacked(base._lines if base else None, lines, 6)
        self._circles: Floats = _stacked(base._circles if base else None, circles, 5)
        self._boxes: Floats = _stacked(base._boxes if base else None, boxes, 4)

    def with_drawn(self, primitives: Iterable[Primitive]) -> Obstacles:
        """These obstacles and some more."""
        return Obstacles(primitives, self)

    def costs(self, boxes: Floats) -> Floats:
        """For each row left, bottom, right, top the sum of what it covers; zero when the box is free."""
        return self._over_lines(boxes) + self._over_circles(boxes) + self._over_boxes(boxes)

    def along(self, paths: Sequence[Sequence[Vector]], width: float = 1.2) -> Floats:
        """For each path the cost of drawing something thin along it."""
        costs = self.costs(boxes_about(np.array([point for path in paths for point in path]), width, width))
        return np.add.reduceat(costs, np.cumsum([0, *(len(path) for path in paths[:-1])]))

    def cheapest(self, wishes: Sequence[Wish]) -> Floats:
        """For each wish the cost of its best spot."""
        sizes = [symbol_size(wish.symbol) for wish in wishes]
        boxes = [
            boxes_about(wish.spots[:NEAR_SPOTS], *size) for wish, size in zip(wishes, sizes, strict=True)
        ]
        counts = [len(rows) for rows in boxes]
        costs = self.costs(np.concatenate(boxes)) + np.concatenate(
            [FARTHER * np.arange(count) for count in counts]
        )
        return np.minimum.reduceat(costs, np.cumsum([0, *counts[:-1]]))

    def label(self, wish: Wish) -> Label:
        """The label at the first free spot of its wish, or where it covers least."""
        width, height = symbol_size(wish.symbol)
        costs = self.costs(boxes_about(wish.spots, width + 2 * CLEARANCE, height + 2 * CLEARANCE))
        best = int(np.argmin(LABEL_WEIGHT * costs + FARTHER * np.arange(len(costs))))
        return Label(wish.symbol, Vector(*wish.spots[best].tolist()), width, height)

    def _over_lines(self, boxes: Floats) -> Floats:
        """Lines clipped against the boxes (Liang and Barsky), each box grown by half the pen."""
        lines = _near(self._lines, boxes)
        first, last = np.zeros((len(boxes), len(lines))), np.ones((len(boxes), len(lines)))
        for axis in (0, 1):
            start, step = lines[:, axis], lines[:, 2 + axis] - lines[:, axis]
            pace = 1.0 / np.where(np.abs(step) < 1e-9, 1e-9, step)
            one = (boxes[:, [axis]] - lines[:, 4] - start) * pace
            two = (boxes[:, [axis + 2]] + lines[:, 4] - start) * pace
            first = np.maximum(first, np.minimum(one, two))
            last = np.minimum(last, np.maximum(one, two))
        return np.asarray((first <= last) @ lines[:, 5])

    def _over_circles(self, boxes: Floats) -> Floats:
        """A box meets a circle's line when its nearest point is within and its farthest point without."""
        x, y, radius, half, cost = self._circles.T
        left, bottom, right, top = (boxes[:, [column]] for column in range(4))
        nearest = np.hypot(
            np.maximum(0, np.maximum(left - x, x - right)), np.maximum(0, np.maximum(bottom - y, y - top))
        )
        farthest = np.hypot(np.maximum(x - left, right - x), np.maximum(y - bottom, top - y))
        return np.asarray(((nearest <= radius + half) & (farthest >= radius - half)) @ cost)

    def _over_boxes(self, boxes: Floats) -> Floats:
        left, bottom, right, top = (boxes[:, [column]] for column in range(4))
        across = (left < self._boxes[:, 2]) & (self._boxes[:, 0] < right)
        upward = (bottom < self._boxes[:, 3]) & (self._boxes[:, 1] < top)
        return np.asarray((across & upward).sum(axis=1) * COST_LABEL)


def place(wishes: Iterable[Wish], obstacles: Obstacles) -> tuple[Label, ...]:
    """A label for each wish, in order, none on another one."""
    labels: tuple[Label, ...] = ()
    for wish in wishes:
        labels += (obstacles.label(wish),)
        obstacles = obstacles.with_drawn(labels[-1:])
    return labels


def around(symbol: str, anchor: Vector, gap: float = 0.0, away: Vector | None = None) -> Floats:
    """Spots for a symbol around a point, in sixteen directions, nearest first, towards `away` first."""
    half = np.array(symbol_size(symbol)) / 2
    toward = (
        _TOWARD if away is None else _TOWARD[np.argsort(-(_TOWARD @ np.array(away)).round(6), kind="stable")]
    )
    reach = (half / np.maximum(np.abs(toward), 1e-9)).min(axis=1)
    steps = toward * (gap + _RINGS[:, None] + reach)[:, :, None]
    return np.asarray(np.array(anchor) + steps.reshape(-1, 2))


def beside(symbol: str, start: Vector, end: Vector, gap: float = 0.5) -> Floats:
    """Spots for a symbol beside a line, near its middle first, on either side."""
    width, height = symbol_size(symbol)
    line = end - start
    across = line.turned() / length(line) if length(line) > 1e-9 else Vector(0.0, 1.0)
    reach = gap + abs(across.x) * width / 2 + abs(across.y) * height / 2
    along = np.array(start) + np.outer((0.5, 0.38, 0.62, 0.26, 0.74, 0.12, 0.88, -0.15, 1.15), line)
    offsets = np.array([[reach + more, -reach - more] for more in (0.0, 1.2, 2.6)])
    spots: Floats = np.add(along[None, :, None, :], offsets[:, None, :, None] * np.array(across))
    return spots.reshape(-1, 2)


def boxes_about(middle: Floats, width: float, height: float) -> Floats:
    """Boxes of one size about centres (rows x, y), as rows left, bottom, right, top."""
    half = np.array((width / 2, height / 2))
    return np.concatenate((middle - half, middle + half), axis=1)


def _near(lines: Floats, boxes: Floats) -> Floats:
    """The lines that come near any of the boxes: most do not, and clipping is what costs."""
    low, high = boxes[:, :2].min(axis=0) - 1.0, boxes[:, 2:].max(axis=0) + 1.0
    one, two = lines[:, :2], lines[:, 2:4]
    return np.asarray(lines[((np.maximum(one, two) >= low) & (np.minimum(one, two) <= high)).all(axis=1)])


def _stacked(base: Floats | None, rows: list[tuple[float, ...]], columns: int) -> Floats:
    added = np.array(rows, dtype=float).reshape(-1, columns)
    return added if base is None else np.concatenate((base, added)) if rows else base


def _ring(disc: Disc) -> tuple[float, ...]:
    """A small filled disc counts whole, a larger one by its line only."""
    solid = disc.fill in ("black", "white") and disc.radius < 3
    pen = disc.pen.width / 2 if disc.pen else 0.0
    half = disc.radius if solid else pen
    cost = COST_BOLD if solid or pen >= BOLD.width / 2 else COST_FIRM
    return (disc.centre.x, disc.centre.y, disc.radius, half, cost)


def _segments(primitive: Strokes | Outline | Bow) -> list[tuple[float, ...]]:
    pen = primitive.pen
    width = pen.width if pen else 0.0
    cost = COST_BOLD if width >= BOLD.width else COST_FIRM if width > THIN.width else COST_THIN
    if isinstance(primitive, Strokes):
        pairs = list(primitive.lines)
    else:
        path = primitive.path() if isinstance(primitive, Bow) else primitive.corners
        closing = path[:1] if isinstance(primitive, Outline) and primitive.closed else ()
        pairs = list(zip(path, path[1:] + closing, strict=False))
    return [(start.x, start.y, end.x, end.y, width / 2, cost) for start, end in pairs]
