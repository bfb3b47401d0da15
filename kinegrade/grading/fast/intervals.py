"""The intervals in which answers are right on the papers of an exam, in double precision: which
papers an answer fits, of all of them at once.

`other_papers` and `another_paper` search by them; no answer is right or wrong by them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinegrade.exam.folder.columns.gathering import read_right_answers
from kinegrade.exam.folder.columns.runs import list_runs
from kinegrade.exam.folder.papers import RightAnswers
from kinegrade.exam.folder.sitting import Sitting
from kinegrade.grading.fast.bounds import Flags, Numbers, Places, tabulate_rules

SAME = 1e-9  # relative: values further apart than this are different
_NEGATIVE = 2**15  # from here on, two bytes begin with the bit of the minus sign
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

    def at(self, papers: Places | slice) -> Intervals:
        """Those of these papers; of a slice they share the memory."""
        return Intervals(self.value[papers], self.low[papers], self.high[papers], self.period)

    def fit(self, answers: Numbers) -> Flags:
        """Which answers are right on which papers: a row for each answer."""
        return self._hold(answers[:, None] - self.value)

    def fit_beside(self, answers: Numbers, papers: Places) -> Flags:
        """Which answers are right on the paper beside each."""
        own = self.at(papers)
        return own._hold(answers - own.value)

    @property
    def is_plain(self) -> bool:
        """Whether every paper asks this, and no turns are right too."""
        return not (self.period or np.isnan(self.value).any())

    def list_fits(self, answers: Numbers) -> tuple[Places, Places]:
        """Each answer, by its place, beside each of the papers on which it is right."""
        if not self.is_plain:
            places, papers = np.nonzero(self.fit(answers))
            return places, papers
        places, papers = SortedIntervals.of(self).pair(answers)
        fits = self.fit_beside(answers[places], papers)
        return places[fits], papers[fits]

    def reach(self) -> tuple[Numbers, Numbers]:
        """How far answers may be from the values, below and above."""
        ends = self.low - self.value, self.high - self.value
        slack = _SLACK * np.abs(self.value)
        return np.minimum(*ends) - slack, np.maximum(*ends) + slack

    def turn(self, away: Numbers) -> Numbers:
        """Distances from the values without full turns."""
        if not self.period:
            return away
        turned: Numbers = (away + self.period / 2) % self.period - self.period / 2
        return turned

    def _hold(self, away: Numbers) -> Flags:
        """Which of these distances from the values are within the intervals."""
        away, (below, above) = self.turn(away), self.reach()
        held: Flags = (away >= below) & (away <= above)
        return held

    def may_fit(self, answers: Numbers, papers: Places) -> Flags:
        """False where an answer is certainly wrong on the paper beside it, full turns aside; a
        blank may be anything.
        """
        slack = SAME * np.abs(answers)
        beyond: Flags = self.low[papers] > answers + slack
        beyond |= self.high[papers] < answers - slack
        return ~beyond

    def differ(self, values: Numbers) -> Flags:
        """On which papers another answer is right than each of these: a row for each of them."""
        away: Flags = np.abs(self.value - values[:, None]) > SAME * np.abs(self.value)
        return away


@dataclass(frozen=True, slots=True)
class SortedIntervals:
    """The intervals of one ask in the rough order of their values, in which those that hold an
    answer stand close together: `papers` have them, `up_to` is the highest end so far, `from_on`
    the lowest beginning from there on; papers that do not ask it stand last. Full turns are no part
    of it.
    """

    papers: Places
    up_to: Numbers
    from_on: Numbers

    @classmethod
    def of(cls, intervals: Intervals) -> SortedIntervals:
        """Those of all its papers."""
        papers = np.argsort(rank_roughly(intervals.value), kind="stable")
        room = _SLACK * np.abs(intervals.value[papers])
        low, high = intervals.low[papers] - room, intervals.high[papers] + room
        up_to = np.fmax.accumulate(np.maximum(low, high))
        from_on = np.fmin.accumulate(np.minimum(low, high)[::-1])[::-1]
        return cls(papers, up_to, from_on)

    def find_ranges(self, answers: Numbers) -> tuple[Places, Places]:
        """Where the papers on which each answer may be right begin and end in that order: all on
        which it is, and few others.
        """
        slack = SAME * np.abs(answers)
        begins = np.searchsorted(self.up_to, answers - slack, side="left")
        ends = np.searchsorted(self.from_on, answers + slack, side="right")
        return begins, np.maximum(begins, ends)

    def list_near(self, answer: float) -> Places:
        """The papers on which an answer may be right."""
        [begin], [end] = self.find_ranges(np.array([answer]))
        near: Places = self.papers[begin:end]
        return near

    def pair(self, answers: Numbers) -> tuple[Places, Places]:
        """Each answer, by its place, beside each of the papers on which it may be right."""
        begins, ends = self.find_ranges(answers)
        counts = ends - begins
        near = self.papers[list_runs(begins, counts)]
        return np.repeat(np.arange(len(answers)), counts), near


@dataclass(frozen=True, slots=True)
class AsksBeside:
    """The intervals of all asks on the papers beside some answers: in `values`, and in how far
    `below` and `above` them is right, a row for each ask.
    """

    intervals: Sequence[Intervals]
    values: Numbers
    below: Numbers
    above: Numbers

    @classmethod
    def of(cls, intervals: Sequence[Intervals], papers: Places) -> AsksBeside:
        """Those of these papers."""
        own = [each.at(papers) for each in intervals]
        below, above = zip(*(each.reach() for each in own), strict=True)
        return cls(own, np.stack([each.value for each in own]), np.stack(below), np.stack(above))

    def fit(self, answers: Numbers) -> Flags:
        """Which answers are right on the paper beside each: a row for each ask."""
        away = answers - self.values
        for ask, each in enumerate(self.intervals):
            if each.period:
                away[ask] = each.turn(away[ask])
        held: Flags = (away >= self.below) & (away <= self.above)
        return held


def rank_roughly(numbers: Numbers) -> NDArray[np.uint16]:
    """Numbers that stand in the order of these as far as their first two digits tell it; thousands
    of them are put in order in a seventh of the time.

    >>> rank_roughly(np.array([-2.0, 0.0, 1.0, 1.001, 1.1])).tolist()
    [16383, 32768, 49024, 49024, 49036]
    """
    with np.errstate(over="ignore"):
        bits = numbers.astype(np.float32).view(np.uint32) >> 16
    signed = np.where(bits < _NEGATIVE, bits + _NEGATIVE, 2 * _NEGATIVE - 1 - bits)
    return signed.astype(np.uint16)


def list_intervals(exam: Sitting) -> list[Intervals]:
    """Those of each ask on the papers of an exam, and then on those of its pool. Raises ExamError
    where the papers cannot be read.
    """
    parts = [(_list_ends(part), part.periods) for part in read_right_answers(exam)]
    each = zip(*(ends for ends, _ in parts), strict=True)
    turned = [np.concatenate(numbers, axis=1) for numbers in each]
    periods = (max(own) for own in zip(*(own for _, own in parts), strict=True))
    return [*map(Intervals, *turned, periods)]


def _list_ends(part: RightAnswers) -> tuple[Numbers, Numbers, Numbers]:
    """The values of some papers, and where their intervals begin and end: a row for each ask."""
    bounds = tabulate_rules(part.rules).bounds(part.values.reshape(-1))
    each = part.values, bounds.low, bounds.high
    turned = (numbers.reshape(part.values.shape).T for numbers in each)
    values, low, high = map(np.ascontiguousarray, turned)
    return values, low, high
