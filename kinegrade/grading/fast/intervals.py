"""The intervals in which answers are right on the papers of an exam, in double precision: which
papers an answer fits, of all of them at once.

`other_papers` and `another_paper` search by them; no answer is right or wrong by them.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from kinegrade.exam.folder.columns.gathering import read_periods, read_rules, read_values
from kinegrade.exam.folder.keys import Paper
from kinegrade.grading.fast.bounds import Flags, Numbers, Places, tabulate_rules

_SAME = 1e-9  # relative: values further apart than this are different
_SLACK = 1e-12  # of the right answer: what rounding in doubles may do to a bound


@dataclass(frozen=True, slots=True)
class Intervals:
    """The interval in which an answer to one ask is right, for each paper; `period` is a full turn,
    or 0.
    """

    value: Numbers
    low: Numbers
    high: Numbers
    period: float

    def moved(self, factor: float) -> Intervals:
        """The same intervals around other values."""
        return Intervals(self.value * factor, self.low * factor, self.high * factor, self.period)

    def widened(self, factor: float) -> Intervals:
        """Intervals so many times as wide, around the same values."""
        low, high = (self.value + factor * (end - self.value) for end in (self.low, self.high))
        return Intervals(self.value, low, high, self.period)

    def at(self, papers: Places) -> Intervals:
        """Those of these papers."""
        return Intervals(self.value[papers], self.low[papers], self.high[papers], self.period)

    def fit(self, answers: Numbers) -> Flags:
        """Which answers are right on which papers: a row for each answer."""
        away = answers[:, None] - self.value
        if self.period:
            away = (away + self.period / 2) % self.period - self.period / 2
        ends = self.low - self.value, self.high - self.value
        slack = _SLACK * np.abs(self.value)
        return (away >= np.minimum(*ends) - slack) & (away <= np.maximum(*ends) + slack)

    def differ(self, values: Numbers) -> Flags:
        """On which papers another answer is right than each of these: a row for each of them."""
        away: Flags = np.abs(self.value - values[:, None]) > _SAME * np.abs(self.value)
        return away


def list_intervals(papers: Iterable[Paper], asks: int) -> list[Intervals]:
    """Those of each ask. Raises ExamError where the papers cannot be read."""
    values, rules, periods = [], [], [0.0] * asks
    for paper in papers:
        values.append(read_values(paper.keys))
        rules.append(read_rules(paper.keys))
        periods = [
            max(period, float(own or 0))
            for period, own in zip(periods, read_periods(paper.keys), strict=True)
        ]
    columns = np.array(values, dtype=np.float64).reshape(-1, asks)
    bounds = tabulate_rules(rules).bounds(columns.reshape(-1))
    low, high = (each.reshape(columns.shape) for each in (bounds.low, bounds.high))
    return [
        Intervals(columns[:, ask].copy(), low[:, ask].copy(), high[:, ask].copy(), period)
        for ask, period in enumerate(periods)
    ]
