"""Where quantities that are small along a cycle have sharp peaks: the nearer, the higher."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinegrade.motion.path import Array

_BESIDE = 2  # positions on either side of a peak, over which it is seen to be one
_SHARPER = 2.0  # times what it is there; one over the distance is three times as much
_PLACES = 9  # of a window, about the highest of which the next one is
_ROUNDS = 16


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
