"""Which positions of a cycle are baked: as many as it takes for those between them to be true."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from kinegrade.mechanics.vector import Vector
from kinegrade.motion.ends import Open
from kinegrade.motion.path import Array, MotionPath, Placement
from kinegrade.motion.placing import Placing
from kinegrade.practice.skeleton import list_guides

_COUNTS = (36, 72, 144)  # positions of a turn, or of a swing
_MOST = 288
_TURNS = 2  # of an input after which the mechanism never is as it was: the rest is much the same
_TRUE = 0.0005  # of the drawing's longer side: what interpolated positions may be off
_FAR = 2.0  # sizes of the mechanism that a point may go
_BEYOND = 0.06  # sizes of the mechanism: of a guide behind the last place of what moves there


@dataclass(frozen=True, eq=False)
class PoseTable:
    """Positions at displacements of the input: `places` has coordinates in m, one row for each."""

    placement: Placement
    places: Array

    @property
    def moved(self) -> Array:
        """The displacements."""
        return self.placement.moved

    @property
    def extent(self) -> float:
        """The longer side of all that moves, m."""
        return float(max(np.ptp(self.places[0::2]), np.ptp(self.places[1::2]), 1e-9))


def choose_poses(path: MotionPath) -> PoseTable:
    """Positions of the path, as many as it takes for those between to be true; of one on which
    points go far away, those nearby.
    """
    low, high = _find_way(path)
    turns = max(1, round((high - low) / path.input.period)) if path.input.period else 1
    for count in _COUNTS:
        table = _tabulate(path, _spread(path, min(_MOST, count * turns)))
        if count * turns >= _MOST or _find_error(path, table) <= _TRUE * table.extent:
            break
    return table


def _find_way(path: MotionPath) -> tuple[float, float]:
    """From where to where the input goes."""
    low, high = path.bounds
    if path.input.period is None or not isinstance(path.end, Open):
        return low, high
    return low, min(high, low + _TURNS * path.input.period)


def _spread(path: MotionPath, count: int) -> Array:
    """About so many displacements, those of positions that are near."""
    if path.is_closed:
        return path.spread(count + 1)[:-1]
    endless = isinstance(path.end, Open)
    moved = np.linspace(*_find_way(path), count) if endless else path.spread(count)
    points = path.place(moved).frames.mechanism.points.values()
    start = path.motion.points.values()
    ways = [
        np.broadcast_to(np.hypot(now.x - then.x, now.y - then.y), moved.shape)
        for now, then in zip(points, start, strict=True)
    ]
    far = moved[np.array(ways).max(axis=0) > _FAR * path.size]
    before, after = far[far < 0].max(initial=-np.inf), far[far > 0].min(initial=np.inf)
    return np.asarray(moved[(moved > before) & (moved < after)])


def _tabulate(path: MotionPath, moved: Array) -> PoseTable:
    placement = path.place(moved)
    return PoseTable(placement, np.array(list(_list_rows(path, placement))))


def _list_rows(path: MotionPath, placement: Placement) -> Iterator[Array]:
    """x and y of each point, then of the ends of each guide, which are those of its whole way."""
    shape = placement.moved.shape
    places = placement.frames.mechanism.points
    for point in places.values():
        yield from _broadcast(point, shape)
    placing, beyond = Placing(path.motion.frames, placement.at), _BEYOND * path.size
    for guide in list_guides(path.motion.frames.mechanism):
        direction = guide.line.direction
        unit = direction / float(np.hypot(direction.x, direction.y))
        now = placing.place(guide.of, guide.line.point)
        ahead = placing.place(guide.of, guide.line.point + unit) - now
        along = np.broadcast_to((places[guide.rider] - now).dot(ahead), shape)
        for reach in (along.min() - beyond, along.max() + beyond):
            yield from _broadcast(now + ahead * float(reach), shape)


def _broadcast(point: Vector, shape: tuple[int, ...]) -> Iterator[Array]:
    for component in point:
        yield np.broadcast_to(np.asarray(component, dtype=float), shape)


def _find_error(path: MotionPath, table: PoseTable) -> float:
    """How far positions halfway between are off when interpolated as the script does, m."""
    moved = table.moved
    if path.is_closed:
        low, high = path.bounds
        step = (high - low) / len(moved)
        between = moved + step / 2
        rows = np.concatenate([table.places[:, -1:], table.places, table.places[:, :2]], axis=1)
    else:
        inputs = moved[None, :]
        between = _interpolate(inputs)[0]
        rows = table.places
    count = 2 * len(path.motion.points)
    found = _tabulate(path, between).places[:count]
    return float(np.abs(_interpolate(rows[:count]) - found).max())


def _interpolate(rows: Array) -> Array:
    """Values halfway between neighbours, but for the first and last, by the cubic through four."""
    return np.asarray((9 * (rows[:, 1:-2] + rows[:, 2:-1]) - rows[:, :-3] - rows[:, 3:]) / 16)
