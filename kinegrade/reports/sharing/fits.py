"""Which papers an answer fits: what would be right on each paper of a class, or what a known
mistake leads to there.

Decided in double precision, for all answers to one ask at once. `sharing` counts the results, and
no student is marked by them. Values at or next to zero are left out, because they fit everywhere.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinegrade.grading.fast.bounds import Numbers, Places, Rules


@dataclass(frozen=True)
class Windows:
    """What fits the papers at one ask: numbers from `low` to `high`, in the ask's unit, fit the
    paper at position `paper`; in the order of `low`.

    `period` is a full turn where full turns do not matter, otherwise 0.
    """

    paper: NDArray[np.int32]
    low: Numbers
    high: Numbers
    period: float

    @classmethod
    def of(cls, paper: Places, low: Numbers, high: Numbers, period: float) -> Windows:
        """These windows, in their order."""
        order = np.argsort(low)
        return cls(paper[order].astype(np.int32), low[order], high[order], period)

    @cached_property
    def _reach(self) -> Numbers:
        """How far each window or one before it reaches."""
        reach: Numbers = np.maximum.accumulate(self.high)
        return reach

    @cached_property
    def _most(self) -> int:
        """How many windows a paper has, at most."""
        return int(np.bincount(self.paper).max(initial=1))

    def fits(self, answers: Numbers) -> tuple[Places, NDArray[np.int32]]:
        """Positions of answers, and of the papers that each of them fits; a pair may occur several
        times.
        """
        numbers = self._turn(answers)
        first = np.searchsorted(self._reach, numbers, "left")
        count = np.maximum(np.searchsorted(self.low, numbers, "right") - first, 0)
        answer = np.repeat(np.arange(len(count)), count)
        behind = np.arange(len(answer)) - np.repeat(np.cumsum(count) - count, count)
        window = first[answer] + behind
        inside = self.high[window] >= numbers[answer]
        return answer[inside], self.paper[window[inside]]

    def count_least(self, answers: Numbers) -> Numbers:
        """How many papers each of these answers fits at least, and more than none if it fits any;
        NaN fits none.
        """
        numbers = self._turn(answers)
        begun = np.searchsorted(self.low, numbers, "right")
        least: Numbers = np.ceil(
            (begun - np.searchsorted(np.sort(self.high), numbers, "left")) / self._most
        )
        return least

    def papers(self, answer: float) -> frozenset[int]:
        """The positions of the papers that one answer fits."""
        _, papers = self.fits(np.array([answer]))
        return frozenset(papers.tolist())

    def _turn(self, answers: Numbers) -> Numbers:
        return answers % self.period if self.period else answers


def find_windows(paper: Places, value: Numbers, rules: Rules, period: float) -> Windows:
    """What agrees with these values, by the rule of the paper that each belongs to; `rules` are in
    the order of the papers.

    Tolerances are those printed on the papers.
    """
    bounds = rules.at(paper).bounds(value)
    low, high = bounds.low, bounds.high
    proper = (low > 0) | (high < 0)
    return _unroll(paper[proper], value[proper], low[proper], high[proper], period)


def _unroll(paper: Places, value: Numbers, low: Numbers, high: Numbers, period: float) -> Windows:
    """The windows; for cyclic angles, those of the first turn with copies one turn below and
    above.
    """
    if not period:
        return Windows.of(paper, low, high, 0.0)
    shift = value % period - value
    turns: Any = [(low + shift + turn, high + shift + turn) for turn in (-period, 0.0, period)]
    lows, highs = (np.concatenate(bounds) for bounds in zip(*turns, strict=True))
    return Windows.of(np.tile(paper, 3), lows, highs, period)
