"""Where quantities along a cycle are least and greatest, and where those that are small have sharp
peaks: the nearer, the higher.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinegrade.cycles.curves import Curve, Extreme
from kinegrade.motion.path import Array

_BESIDE = 2  # positions on either side of a peak, over which it is seen to be one
_SHARPER = 2.0  # times what it is there; one over the distance is three times as much
_PLACES = 9  # of a window, about the highest of which the next one is
_ROUNDS = 16
_STEPS, _CLIMBS = 17, 7  # of a way beside a top, on which it is found, and how often
_SAME = 1e-8  # of the range of values: extremes that are one
_BETTER = 1e-4  # of that: what is more than rounding
_NOTHING = 1e-6  # of the greatest value: what rounding leaves of zero near dead points
_TOLD = 1e-7  # of the input's range: how well the place of a smooth extreme is known


class _Top(NamedTuple):
    """A position of a curve, by the row of this, beside which it may be greatest, times a sign."""

    row: int
    number: int
    sign: float


class _Windows(NamedTuple):
    """Parts of the cycle in each of which one quantity has a peak: its row, and both ends."""

    rows: NDArray[np.intp]
    low: Array
    high: Array


def find_peaks(read: Callable[[Array], Array], moved: Array, least: Array) -> list[Array]:
    """For each of the quantities, rows of what `read` gives at displacements of the input, those at
    which it has a sharp peak as high as its `least`, seen from the displacements `moved`.
    """
    windows = _find_windows(read(moved), moved)
    for _ in range(_ROUNDS):
        if windows.rows.size:
            windows = _narrow(read, windows, least)
    rows, places = windows.rows, (windows.low + windows.high) / 2
    high = _read_each(read, rows, places[:, None])[:, 0] > least[rows]
    return [places[high & (rows == row)] for row in range(len(least))]


def find_extremes(
    read: Callable[[Array], Array], curves: Sequence[Curve]
) -> list[tuple[Extreme, Extreme]]:
    """For each of the curves, of which `read` gives rows of values at displacements of the input,
    its least and its greatest value, at the first place that has it.
    """
    tops = [
        _Top(row, number, sign)
        for row, curve in enumerate(curves)
        for sign in (-1.0, 1.0)
        for number in curve.list_tops(sign)
    ]
    found = list(zip(tops, *_climb(read, curves, tops), strict=True))

    def choose(row: int, sign: float) -> Extreme:
        own = [each for each in found if (each[0].row, each[0].sign) == (row, sign)]
        return _choose_extreme(curves[row], own, sign)

    return [(choose(row, -1.0), choose(row, 1.0)) for row in range(len(curves))]


def _climb(
    read: Callable[[Array], Array], curves: Sequence[Curve], tops: Sequence[_Top]
) -> tuple[list[float], list[float]]:
    """The extremes beside tops of curves, and their places."""
    rows, signs = np.array([top.row for top in tops]), np.array([top.sign for top in tops])
    numbers, moved = np.array([top.number for top in tops]), curves[0].moved
    low, high = moved[np.maximum(numbers - 1, 0)], moved[np.minimum(numbers + 1, len(moved) - 1)]
    known = np.array([curves[top.row].values[top.number] for top in tops])
    turns = 360.0 * np.array([curve.ask.unit.degrees for curve in curves])[rows]

    def look(places: Array) -> Array:
        """The values there, of angles as the curve goes on through full turns."""
        values = _read_each(read, rows, places)
        away = np.round((known[:, None] - values) / 360.0)
        return np.asarray(values + turns[:, None] * away)

    each = np.arange(len(tops))
    for _ in range(_CLIMBS):
        places = np.linspace(low, high, _STEPS, axis=1)
        top = (signs[:, None] * look(places)).argmax(axis=1)
        low, high = (
            places[each, np.maximum(top - 1, 0)],
            places[each, np.minimum(top + 1, _STEPS - 1)],
        )
    middle = (low + high) / 2
    return look(middle[:, None])[:, 0].tolist(), middle.tolist()


def _choose_extreme(
    curve: Curve, found: Sequence[tuple[_Top, float, float]], sign: float
) -> Extreme:
    """The first of the best of what was found beside tops of a curve: a value and its place; a
    position of the curve where that is as good.
    """
    known_values = curve.values[np.isfinite(curve.values)]
    slack = _SAME * float(np.ptp(known_values))
    nothing = _NOTHING * float(np.abs(known_values).max())
    extremes = []
    for top, value, place in found:
        limit, known = curve.find_limit(top.number), float(curve.values[top.number])
        if limit is not None:
            extremes.append(Extreme(limit[1], limit[0].displacement, is_near=True))
        elif sign * value > sign * known + _BETTER * slack:
            extremes.append(Extreme(value, _round_place(place, curve.moved)))
        else:
            extremes.append(Extreme(known, float(curve.moved[top.number])))
    best = max(sign * each.value for each in extremes)
    first = next(each for each in extremes if sign * each.value >= best - slack)
    return first if abs(first.value) > nothing else replace(first, value=0.0)


def _round_place(place: float, moved: Array) -> float:
    """A place as exactly as a smooth extreme tells it."""
    step = 10.0 ** np.floor(np.log10(_TOLD * np.ptp(moved)))
    return float(np.round(place / step) * step)


def _find_windows(values: Array, moved: Array) -> _Windows:
    """Those about positions at which a quantity is greatest, and much less on both sides."""
    count = values.shape[1]

    def shift(by: int) -> Array:
        return values[:, _BESIDE + by : count - _BESIDE + by]

    greatest = shift(0) >= np.maximum(shift(-1), shift(1))
    sharp = shift(0) > _SHARPER * np.maximum(shift(-_BESIDE), shift(_BESIDE))
    rows, first = np.nonzero(greatest & sharp)
    return _Windows(rows, moved[first], moved[first + 2 * _BESIDE])


def _narrow(read: Callable[[Array], Array], windows: _Windows, least: Array) -> _Windows:
    """The quarter of each window about the highest place, as far as it still has a peak."""
    places = np.linspace(windows.low, windows.high, _PLACES, axis=1)
    heights = _read_each(read, windows.rows, places)
    each, top = np.arange(len(places)), heights[:, 1:-1].argmax(axis=1) + 1
    highest = heights[each, top]
    sharp = highest > _SHARPER * np.maximum(heights[:, 0], heights[:, -1])
    kept = sharp | (highest > least[windows.rows])
    low, high = places[each, top - 1], places[each, top + 1]
    return _Windows(windows.rows[kept], low[kept], high[kept])


def _read_each(read: Callable[[Array], Array], rows: NDArray[np.intp], places: Array) -> Array:
    """The quantity of each row at its own places."""
    every, which = np.unique(places, return_inverse=True)
    return read(every)[rows[:, None], which.reshape(places.shape)]
