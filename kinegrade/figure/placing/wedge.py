"""Where the letter of an angle may stand: between the sides of the angle, or of their
prolongations, and on the same side as its arc of everything that passes between them.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import pi, sin

import numpy as np
from numpy.typing import NDArray

from kinegrade.figure.placing.extent import measure_symbol
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.place import LOST, Floats, Wish, list_spots_along_arc
from kinegrade.figure.plane import polar
from kinegrade.figure.scene import Bow

_APART = 0.4  # millimetres kept between the letter and a side
_FARTHEST = 27.0  # millimetres from the vertex: beyond, a letter belongs to no angle
_AWAY = 0.8  # demerit of a millimetre between the arc and a letter that has no room at it
_SHARES = np.array((0.5, 0.4, 0.6, 0.3, 0.7))  # of the angle
_ENDS = np.array((0.13, 0.87))  # of the angle, for a letter near an end of a long arc
_LATEST = 3.0  # millimetres from its arc at which a letter is lost
# Millimetres beyond the narrowest place with room
_STEPS = np.array((0.0, 1.0, 2.0, 3.5, 5.0, 7.0, 9.0, 11.0))


def list_spots_in_wedge(symbol: str, bow: Bow) -> Wish:
    """Spots for the symbol of an angle: at its arc, where the angle is wide enough for it, and
    last, where it is lost, outside the angle.
    """
    along = list_spots_along_arc(symbol, bow)
    spots, narrow = along.spots, measure_narrow(symbol, bow)
    if narrow > bow.radius / 2:
        spots = np.concatenate((spots, _list_wide_spots(bow, narrow)))
    spots = np.concatenate((spots, _list_end_spots(symbol, bow)))
    steps = spots - np.array(bow.centre)
    away = np.hypot(steps[:, 0], steps[:, 1]) - bow.radius
    late = np.maximum(np.abs(away) - max(measure_symbol(symbol)), 0.0)
    demerits = _AWAY * late + LOST * (late > _LATEST)
    demerits = demerits + LOST * rate_outside(symbol, spots, bow)
    order = np.argsort(demerits.round(6), kind="stable")
    return Wish(symbol, spots[order], demerits=demerits[order])


def measure_narrow(symbol: str, bow: Bow, half: float = 0.0) -> float:
    """How far from the vertex the middle of a symbol has to stand on the bisector, in millimetres,
    beside a bar about one side that is `half` as wide.
    """
    widening = max(sin(min(abs(bow.sweep), pi) / 2), 1e-3)
    return (max(_measure_reaches(symbol, bow)) + half / 2) / widening


def _list_wide_spots(bow: Bow, narrow: float) -> Floats:
    """Spots at the bisector and beside it from where the angle is wide enough."""
    distances = narrow + _STEPS
    angles = bow.start + bow.sweep * _SHARES
    toward = np.stack((np.cos(angles), np.sin(angles)), axis=1)
    steps = distances[distances < _FARTHEST, None, None] * toward
    return np.asarray(np.array(bow.centre) + steps.reshape(-1, 2))


def _list_end_spots(symbol: str, bow: Bow) -> Floats:
    """Spots outside the arc near its ends, where a bar runs across the middle of the angle."""
    angles = bow.start + bow.sweep * _ENDS
    toward = np.stack((np.cos(angles), np.sin(angles)), axis=1)
    levels = bow.radius + _APART + np.abs(toward) @ np.array(measure_symbol(symbol)) / 2
    return np.asarray(np.array(bow.centre) + toward * levels[:, None])


def rate_outside(symbol: str, spots: Floats, bow: Bow) -> Floats:
    """For each spot 0 where a symbol stands wholly between the sides of the angle (beyond half a
    turn: beside one of them), else 1.
    """
    depths = (spots - np.array(bow.centre)) @ np.array(_find_inward(bow)).T
    beyond = depths - _measure_reaches(symbol, bow) < -1e-6
    out = beyond.any(axis=1) if abs(bow.sweep) <= pi else beyond.all(axis=1)
    return np.asarray(out, dtype=float)


def rate_parted(spots: Floats, bow: Bow, lines: Sequence[Segment]) -> Floats:
    """For each spot 1 where a line passes between it and the arc, else 0."""
    steps = spots - np.array(bow.centre)
    distances = np.maximum(np.hypot(steps[:, 0], steps[:, 1]), 1e-9)
    return rate_cut_off(
        spots, np.array(bow.centre) + steps * (bow.radius / distances)[:, None], lines
    )


def rate_cut_off(spots: Floats, feet: Floats, lines: Sequence[Segment]) -> Floats:
    """For each spot 1 where a line passes between it and its foot, else 0."""
    if not lines:
        return np.zeros(len(spots))
    starts, ends = np.array(lines).transpose(1, 0, 2)
    parted = _lie_apart(starts, ends, spots, feet) & _lie_apart(spots, feet, starts, ends).T
    return np.asarray(parted.any(axis=1), dtype=float)


def _lie_apart(starts: Floats, ends: Floats, ones: Floats, others: Floats) -> NDArray[np.bool_]:
    """For each pair of points (rows) whether it lies on both sides of each line (columns)."""
    across = (ends - starts)[:, ::-1] * np.array((-1.0, 1.0))
    levels = [points @ across.T - (starts * across).sum(axis=1) for points in (ones, others)]
    return np.asarray(levels[0] * levels[1] < 0)


def _measure_reaches(symbol: str, bow: Bow) -> tuple[float, float]:
    """How far the middle of a symbol has to stay from either side, in millimetres."""
    wide, high = measure_symbol(symbol)
    first, last = [(abs(x) * wide + abs(y) * high) / 2 + _APART for x, y in _find_inward(bow)]
    return first, last


def _find_inward(bow: Bow) -> tuple[tuple[float, float], ...]:
    """The normals of the first and the last side that point into the angle."""
    turn = pi / 2 if bow.sweep > 0 else -pi / 2
    first, last = polar(bow.start + turn), polar(bow.start + bow.sweep - turn)
    return (first.x, first.y), (last.x, last.y)
