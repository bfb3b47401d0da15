"""Which positions of a cycle are baked: as many as it takes for those between them to be true."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from operator import itemgetter

import numpy as np

from kinegrade.cycles.centrodes import list_unpinned_bodies
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.vector import Vector
from kinegrade.motion.ends import Open
from kinegrade.motion.path import Array, MotionPath, Placement
from kinegrade.motion.placing import Placing
from kinegrade.practice.skeleton import Guide, list_guides

NEIGHBOURS = 8  # positions of which the script makes the one between them
_COUNTS = (36, 72, 144, 288)  # positions of a turn, or of a swing
_MOST = 288  # of all turns, in a table of the usual number of rows; more where there are fewer
_USUAL_ROWS = 12
_TURNS = 2  # of an input after which the mechanism never is as it was: the rest is much the same
_TRUE = 0.00003  # of the drawing's longer side: what interpolated positions may be off
_SURE = 0.0003  # the same, from where on velocity poles are not to be told
_FAR = 2.0  # sizes of the mechanism that a point may go
_ON_LINE = 1e-9  # of the mechanism's size
_MARKED = 5.0  # sizes of the mechanism, from a body's point to its mark
_BEYOND = 0.06  # sizes of the mechanism: of a guide behind the last place of what moves there


@dataclass(frozen=True, eq=False)
class PoseTable:
    """Positions at displacements of the input: `places` has coordinates in m, one row for each,
    `marks` those of what is not drawn; `tells_poles` where they are close enough for
    velocity poles.
    """

    placement: Placement
    places: Array
    marks: Array
    tells_poles: bool = False

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
    tried: list[tuple[float, PoseTable]] = []
    for moved in _list_choices(path):
        table = _tabulate(path, moved)
        tried.append((_find_error(path, table) / table.extent, table))
        if tried[-1][0] <= _TRUE:
            break
    error, best = min(tried, key=itemgetter(0))
    return replace(best, tells_poles=error <= _SURE)


def _list_choices(path: MotionPath) -> Iterator[Array]:
    """Displacements, the fewest first: evenly spread, or closer where parts almost jump."""
    low, high = _find_way(path)
    turns = max(1, round((high - low) / path.input.period)) if path.input.period else 1
    for count in dict.fromkeys(min(_find_most(path), each * turns) for each in _COUNTS):
        yield _spread(path, count, path.spread)
        if not isinstance(path.end, Open):
            yield _spread(path, count, path.spread_by_length)


def _find_most(path: MotionPath) -> int:
    """How many positions are baked at most: gears that turn often are few points, and take many."""
    mechanism = path.motion.frames.mechanism
    places = len(mechanism.points) + 2 * len(list_guides(mechanism))
    rows = 2 * (places + len(list_unpinned_bodies(path)))
    return max(_MOST, _MOST * _USUAL_ROWS // rows)


def _find_way(path: MotionPath) -> tuple[float, float]:
    """From where to where the input goes."""
    low, high = path.bounds
    if path.input.period is None or not isinstance(path.end, Open):
        return low, high
    return low, min(high, low + _TURNS * path.input.period)


def _spread(path: MotionPath, count: int, spread: Callable[[int], Array]) -> Array:
    """About so many displacements, those of positions that are near."""
    if path.is_closed:
        return spread(count + 1)[:-1]
    endless = isinstance(path.end, Open)
    moved = np.linspace(*_find_way(path), count) if endless else spread(count)
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
    places, marks = (
        np.array(list(list_rows(path, placement))).reshape(-1, len(moved))
        for list_rows in (_list_rows, _list_marks)
    )
    return PoseTable(placement, places, marks)


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
        held = [*along, *_list_held(path, guide)]
        for reach in (min(held) - beyond, max(held) + beyond):
            yield from _broadcast(now + ahead * float(reach), shape)


def _list_held(path: MotionPath, guide: Guide) -> Iterator[float]:
    """How far along a guide, m, the points of its body are that lie on it: it reaches to them."""
    motion, line = path.motion, guide.line
    length = float(np.hypot(line.direction.x, line.direction.y))
    if guide.of == GROUND:
        return
    for point in motion.frames.mechanism.body(guide.of).points:
        from_line = motion.points[point] - line.point
        if abs(from_line.cross(line.direction)) < _ON_LINE * path.size * length:
            yield float(from_line.dot(line.direction)) / length


def _list_marks(path: MotionPath, placement: Placement) -> Iterator[Array]:
    """x and y of a place of each body that no pin holds, far from its first point: velocity poles
    are found by both, and the farther it is, the less of a slow rotation is lost in rounding.
    """
    placing = Placing(path.motion.frames, placement.at)
    beside = Vector(_MARKED * path.size, 0.0)
    for body in list_unpinned_bodies(path):
        mark = placing.place(body.name, path.motion.points[body.points[0]] + beside)
        yield from _broadcast(mark, placement.moved.shape)


def _broadcast(point: Vector, shape: tuple[int, ...]) -> Iterator[Array]:
    for component in point:
        yield np.broadcast_to(np.asarray(component, dtype=float), shape)


def _find_error(path: MotionPath, table: PoseTable) -> float:
    """How far positions halfway between are off when interpolated as the script does, m."""
    low, high = path.bounds
    gain = high - low if path.is_closed else None
    between = np.clip(_interpolate(table.moved[None, :], gain)[0], low, high)
    count, loop = 2 * len(path.motion.points), 0.0 if path.is_closed else None
    rows = np.concatenate([table.places[:count], table.marks / _MARKED])
    found = _tabulate(path, between)
    expected = np.concatenate([found.places[:count], found.marks / _MARKED])
    return float(np.abs(_interpolate(rows, loop) - expected).max())


def _interpolate(rows: Array, gain: float | None) -> Array:
    """Values halfway between neighbours by the polynomial through those about them; rows go on
    behind their end, more by `gain`, where that is not None.
    """
    count = rows.shape[1]
    width = min(NEIGHBOURS, count)
    before = (width - 1) // 2
    if gain is None:
        starts = np.clip(np.arange(count - 1) - before, 0, count - width)
        shares = np.arange(count - 1) + 0.5 - starts
    else:
        rows = np.concatenate([rows - gain, rows, rows + gain], axis=1)
        starts, shares = np.arange(count) + count - before, np.full(count, before + 0.5)
    near = rows[:, starts[:, None] + np.arange(width)]
    return np.asarray((near * _weigh(shares, width)).sum(axis=2))


def _weigh(places: Array, count: int) -> Array:
    """The weights with which values at 0, 1, 2 ... give those at these places (Lagrange)."""
    numbers = np.arange(count)
    apart = numbers[:, None] - numbers + np.eye(count)
    ahead = np.where(np.eye(count, dtype=bool), 1.0, places[:, None, None] - numbers)
    return np.asarray((ahead / apart).prod(axis=2))
