"""Strokes of sliders and swings of rockers, and how long their ways there and back take."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from kinegrade.mechanics.vector import Vector
from kinegrade.motion.ends import Closed, Limit
from kinegrade.motion.path import Array, MotionPath, Placement

_POSITIONS = 1441
_PARTS = 33
_ZOOMS = 9
_STILL = 1e-9

Reading = Callable[[Placement], tuple[Array, Array]]


@dataclass(frozen=True)
class Swing:
    """How far a point on a fixed line, or a body about a fixed pin, goes between its two ends.

    `extent` is in m, or in rad for a body; then the input's displacement at both ends, and the time
    ratio: that of the longer of the ways there and back to the shorter one at a constant speed of
    the input, None where it does not turn.
    """

    name: str
    is_angle: bool
    extent: float
    at_least: float
    at_greatest: float
    time_ratio: float | None


def find_swings(path: MotionPath) -> tuple[Swing, ...]:
    """The strokes and swings of a path that is closed or lies between dead points; none of what
    stands still or turns fully.
    """
    ends = (path.start or path.end, path.end)
    if not all(isinstance(end, Limit | Closed) for end in ends):
        return ()
    found = (
        _measure_swing(path, name, is_angle, read) for name, is_angle, read in _list_readings(path)
    )
    return tuple(swing for swing in found if swing is not None)


def _list_readings(path: MotionPath) -> Iterator[tuple[str, bool, Reading]]:
    """What slides on fixed lines or turns about fixed pins, each with its position and rate."""
    mechanism = path.motion.frames.mechanism
    seen: set[str] = set()
    for body in mechanism.bodies:
        for point, line in mechanism.find_guides(body.name):
            if point not in seen:
                seen.add(point)
                length = math.hypot(line.direction.x, line.direction.y)
                yield point, False, _read_point(point, body.name, line.direction / length)
    driven = set(path.input.leading.list_bodies()[:1]) if path.input.is_angle else set()
    for body in mechanism.bodies:
        if body.name in mechanism.find_pivots() and body.name not in driven:
            yield body.name, True, _read_body(body.name)


def _read_point(point: str, body: str, along: Vector) -> Reading:
    def read(placement: Placement) -> tuple[Array, Array]:
        motion = placement.motion
        return along.dot(motion.points[point]), along.dot(motion.velocity(point, body))

    return read


def _read_body(body: str) -> Reading:
    def read(placement: Placement) -> tuple[Array, Array]:
        rates = placement.path.system.rates
        turning = next(each for each in rates if (each.kind, each.body) == ("turning", body))
        angle = np.asarray(placement.at.coordinates[turning])
        return angle, np.asarray(placement.motion.omega(body))

    return read


def _measure_swing(path: MotionPath, name: str, is_angle: bool, read: Reading) -> Swing | None:
    """The swing of what is read; None where that stands still or turns fully."""
    moved = path.spread(_POSITIONS)
    values = np.broadcast_to(read(path.place(moved))[0], moved.shape)
    extent = float(values.max() - values.min())
    size = 1.0 if is_angle else path.size
    if extent < _STILL * size or (is_angle and abs(values[-1] - values[0]) > math.pi):
        return None
    ends = [_refine(path, read, moved, int(find(values))) for find in (np.argmin, np.argmax)]
    least, greatest = read(path.place(np.array(ends)))[0]
    ratio = _compare_ways(path, *ends)
    return Swing(name, is_angle, float(greatest - least), ends[0], ends[1], ratio)


def _refine(path: MotionPath, read: Reading, moved: Array, number: int) -> float:
    """The displacement beside a position at which the rate is zero, or that of an end at which it
    is not; the end of a closed path lies beside its beginning.
    """
    last = len(moved) - 1
    beside = [(max(number - 1, 0), min(number + 1, last))]
    if path.is_closed and number in (0, last):
        beside = [(0, 1), (last - 1, last)]
    found = (_find_rest(path, read, moved[low], moved[high]) for low, high in beside)
    return next((each for each in found if each is not None), float(moved[number]))


def _find_rest(path: MotionPath, read: Reading, low: float, high: float) -> float | None:
    """The displacement between two others at which the rate is zero, None where there is none."""
    for _ in range(_ZOOMS):
        inner = np.linspace(low, high, _PARTS)
        rates = np.broadcast_to(read(path.place(inner))[1], inner.shape)
        changes = np.flatnonzero(np.diff(np.sign(rates)) != 0)
        if not changes.size:
            return None
        low, high = inner[changes[0]], inner[changes[0] + 1]
    return float((low + high) / 2)


def _compare_ways(path: MotionPath, least: float, greatest: float) -> float | None:
    """The time ratio of an input that turns once in a closed cycle."""
    turn, end = path.input.period, path.end
    if turn is None or not isinstance(end, Closed) or end.turns != 1:
        return None
    there = (greatest - least) % turn
    return max(there, turn - there) / min(there, turn - there)
