"""Which papers an answer fits: what would be right on each paper of a class, or what a known
mistake leads to there.

Decided in double precision, for all answers to one ask at once. `sharing` counts the results, and
no student is marked by them. Values at or next to zero are left out, because they fit everywhere.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from kinegrade.exam.folder.keys import Key
from kinegrade.grading.fast.bounds import Numbers, Places, tabulate_rules


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
        (place, float(value))
        for place, key in enumerate(keys)
        for value in (key.value, *(key.mistakes.values() if mistakes else ()))
    ]
    paper = np.array([place for place, _ in found], dtype=np.intp)
    value = np.array([number for _, number in found], dtype=np.float64)
    bounds = tabulate_rules([tuple(key.rule for key in keys)]).at(paper).bounds(value)
    low, high = bounds.low, bounds.high
    proper = (low > 0) | (high < 0)
    period = float(max((key.period or 0 for key in keys), default=0))
    return _unroll(paper[proper], value[proper], low[proper], high[proper], period)


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
