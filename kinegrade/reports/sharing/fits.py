"""Which papers an answer fits: what would be right on each paper of a class, or what a known
mistake leads to there.

Decided in double precision, for all answers to one ask at once. `sharing` counts the results, and
no student is marked by them. Values at or next to zero are left out, because they fit everywhere.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from kinegrade.exam.folder.keys import Key

Numbers: TypeAlias = NDArray[np.float64]
Places: TypeAlias = NDArray[np.intp]


@dataclass(frozen=True)
class Windows:
    """What fits the papers at one ask: numbers from `low` to `high`, in the ask's unit, fit the
    paper at position `paper`.

    `period` is a full turn where full turns do not matter, otherwise 0.
    """

    paper: Places
    low: Numbers
    high: Numbers
    period: float

    def fits(self, answers: Numbers) -> tuple[Places, Places]:
        """Positions of answers, and of the papers that each of them fits; a pair may occur several
        times.
        """
        numbers = answers % self.period if self.period else answers
        order = np.argsort(numbers)
        first = np.searchsorted(numbers[order], self.low, "left")
        count = np.searchsorted(numbers[order], self.high, "right") - first
        window = np.repeat(np.arange(len(count)), count)
        behind = np.arange(len(window)) - np.repeat(np.cumsum(count) - count, count)
        return order[first[window] + behind], self.paper[window]

    def papers(self, answer: float) -> frozenset[int]:
        """The positions of the papers that one answer fits."""
        number = answer % self.period if self.period else answer
        return frozenset(self.paper[(self.low <= number) & (number <= self.high)].tolist())


def find_windows(keys: Sequence[Key], *, mistakes: bool) -> Windows:
    """What is right by the keys of one ask, in the order of the papers; with `mistakes` also what
    these lead to.

    Tolerances are those printed on the papers.
    """
    found = [
        (place, float(value), *room)
        for place, (key, room) in enumerate(zip(keys, map(_find_room, keys), strict=True))
        for value in (key.value, *(key.mistakes.values() if mistakes else ()))
    ]
    table = np.array(found, dtype=np.float64).reshape(len(found), 5)
    paper, value = table[:, 0].astype(np.intp), table[:, 1]
    low, high = _find_bounds(value, *table[:, 2:].T)
    proper = (low > 0) | (high < 0)
    period = float(max((key.period or 0 for key in keys), default=0))
    return _unroll(paper[proper], value[proper], low[proper], high[proper], period)


def _find_room(key: Key) -> tuple[float, float, float]:
    """Relative and absolute tolerance, and the significant figures asked for, 0 for none."""
    return float(key.rule.relative), float(key.rule.absolute), float(key.rule.figures or 0)


def _find_bounds(
    value: Numbers, relative: Numbers, absolute: Numbers, figures: Numbers
) -> tuple[Numbers, Numbers]:
    """The smallest and the largest number that fit each value."""
    size = np.abs(value)
    room = np.maximum(relative * size, absolute)
    unit = 10.0 ** (np.floor(np.log10(np.where(size > 0, size, 1.0))) + 1 - figures)
    agreeing = np.where(figures > 0, np.round(value / unit) * unit, value)
    half = np.where(figures > 0, unit / 2, 0.0)
    return np.minimum(value - room, agreeing - half), np.maximum(value + room, agreeing + half)


def _unroll(paper: Places, value: Numbers, low: Numbers, high: Numbers, period: float) -> Windows:
    """The windows; for cyclic angles, those of the first turn with copies one turn below and
    above.
    """
    if not period:
        return Windows(paper, low, high, 0.0)
    shift = value % period - value
    turns: Any = [(low + shift + turn, high + shift + turn) for turn in (-period, 0.0, period)]
    lows, highs = (np.concatenate(bounds) for bounds in zip(*turns, strict=True))
    return Windows(np.tile(paper, 3), lows, highs, period)
