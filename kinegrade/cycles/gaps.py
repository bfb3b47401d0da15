"""Where quantities break off along a cycle: at a position in which a direction that they are taken
along has no length, or in which they are nothing divided by nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinegrade.cycles.peaks import find_peaks
from kinegrade.motion.path import Array

ASIDE = 1e-4  # of the input's range: nearer to a gap, rounding may show
_NOTICED = 1e-4  # of what a quantity takes over the cycle
_ROUNDED = 1e-6  # of what it usually is
_NOTHING = 1e-6  # in its unit: near singular positions rounding leaves almost as much of zero
_DECISIVE = 10.0  # times what is noticed: by so much, last digits decide what a quantity is
_HALVINGS = 32
_NEARER = 8.0  # how much nearer the second of two places beside a gap is
_GROWS = 3.0  # times what it is at the first one, where a quantity grows beyond bounds

Rows = NDArray[np.intp]


class _Stretches(NamedTuple):
    """Parts of the cycle over each of which one quantity changes much: its row, the displacements
    at both ends, and its values there.
    """

    rows: Rows
    low: Array
    high: Array
    at_low: Array
    at_high: Array

    def select(self, which: NDArray[np.bool_]) -> _Stretches:
        """Some of them."""
        rows, low, high, at_low, at_high = self
        return _Stretches(rows[which], low[which], high[which], at_low[which], at_high[which])


@dataclass(frozen=True, eq=False)
class GapSearch:
    """`read` gives rows of values at displacements of the input, one for each quantity, which are
    known at the displacements `moved`, and `read_shaken` those of motions that are alike to within
    rounding; `periods` are what makes no difference: a turn for angles, else infinity.
    """

    read: Callable[[Array], Array]
    read_shaken: Callable[[Array], Array]
    periods: Array
    moved: Array

    def find(self) -> list[tuple[float, ...]]:
        """For each quantity the displacements at which it has no value, though it has some on both
        sides; not those at which it grows beyond bounds.
        """
        with np.errstate(all="ignore"):
            jumps = self._find_jumps()
            peaks = find_peaks(self._sway, self.moved, _DECISIVE * self._noticed)
            return [
                tuple(
                    place
                    for place in self._merge(np.concatenate([jumps[row], peaks[row]]))
                    if self._is_bounded(row, place)
                )
                for row in range(len(self.periods))
            ]

    def find_swaying(self, places: Array) -> NDArray[np.bool_]:
        """For each quantity whether at these displacements it has no value because last digits
        decide what it is.
        """
        with np.errstate(all="ignore"):
            swaying = self._sway(places) > _DECISIVE * self._noticed[:, None]
            for row, number in np.argwhere(swaying):
                swaying[row, number] = self._is_bounded(int(row), float(places[number]))
        return np.asarray(swaying)

    @cached_property
    def _values(self) -> Array:
        return self.read(self.moved)

    @cached_property
    def _noticed(self) -> Array:
        """Which changes of each quantity may be jumps."""
        noticed = np.array([_find_noticed(row) for row in self._values])
        return np.where(np.isfinite(self.periods), _NOTICED * self.periods, noticed)

    def _sway(self, moved: Array) -> Array:
        """How much last digits change; nothing where there is no value at all."""
        swayed = self._subtract(self.read_shaken(moved), self.read(moved), self.periods[:, None])
        return np.where(np.isfinite(swayed), swayed, 0.0)

    def _find_jumps(self) -> list[Array]:
        """For each quantity the displacements at which it jumps, or may."""
        values, noticed = self._values, self._noticed
        changes = self._subtract(values[:, 1:], values[:, :-1], self.periods[:, None])
        rows, places = np.nonzero(_find_uneven(changes, noticed[:, None]))
        at_low, at_high = values[rows, places], values[rows, places + 1]
        low, high = self.moved[places], self.moved[places + 1]
        found = _Stretches(rows, low, high, at_low, at_high)
        for _ in range(_HALVINGS):
            found = self._halve(found, noticed)
        return [found.high[found.rows == row] for row in range(len(values))]

    def _halve(self, stretches: _Stretches, noticed: Array) -> _Stretches:
        """The halves over which the quantities change more, as far as that is still much."""
        rows, low, high, at_low, at_high = stretches
        if not rows.size:
            return stretches
        middle = (low + high) / 2
        places, which = np.unique(middle, return_inverse=True)
        at_middle = self.read(places)[rows, which]
        before = self._subtract(at_middle, at_low, self.periods[rows])
        after = self._subtract(at_high, at_middle, self.periods[rows])
        first = before >= after
        halves = _Stretches(
            rows,
            np.where(first, low, middle),
            np.where(first, middle, high),
            np.where(first, at_low, at_middle),
            np.where(first, at_middle, at_high),
        )
        return halves.select(np.maximum(before, after) > noticed[rows])

    def _subtract(self, first: Array, second: Array, periods: Array) -> Array:
        """By how much values differ; infinite where one of them is not finite."""
        apart = first - second
        turns = np.where(np.isfinite(periods), np.round(apart / periods) * periods, 0.0)
        return np.where(np.isfinite(apart), np.abs(apart - turns), np.inf)

    def _merge(self, places: Array) -> Iterator[float]:
        """The places in their order, each once, without the ends of the input's range."""
        first, last = self.moved[0], self.moved[-1]
        aside = ASIDE * (last - first)
        before = first
        for place in np.sort(places).tolist():
            if place > before + aside and place < last - aside:
                yield place
                before = place

    def _is_bounded(self, row: int, place: float) -> bool:
        """Whether a quantity stays finite on both sides of a place."""
        aside = ASIDE * (self.moved[-1] - self.moved[0])
        beside = np.array([-aside, -aside / _NEARER, aside / _NEARER, aside])
        values = np.abs(self.read(place + beside)[row])
        grows = values[1:3] > _GROWS * values[[0, 3]] + self._noticed[row]
        return bool(np.isfinite(values).all() and not grows.any())


def _find_uneven(changes: Array, noticed: Array) -> NDArray[np.bool_]:
    """Which changes are so much, and so unlike those on either side, that a jump may be in them."""
    apart = np.abs(np.diff(changes, axis=1, prepend=np.nan, append=np.nan))
    uneven = np.fmax(apart[:, :-1], apart[:, 1:]) > noticed / 2
    return (changes > noticed) & (uneven | ~np.isfinite(changes))


def _find_noticed(values: Array) -> float:
    """Which changes of a quantity may be jumps: what rounding leaves is none."""
    known = values[np.isfinite(values)]
    if not known.size:
        return np.inf
    low, usual, high = np.percentile(known, [5, 50, 95])
    return float(max(_NOTICED * (high - low), _ROUNDED * abs(usual), _NOTHING))
