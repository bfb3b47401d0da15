"""Questions that a student answered as is right on one other paper of the exam.

Some answers of another paper follow from each other on any paper: a magnitude from its components,
a velocity from a rate where a length is the same. They were not carried on from an own value, so
`block_judge` gives no follow-through for them.

One question tells nothing: a number misread gives all the answers of a paper that has that number,
and in a large class a wrong number is right on some paper by chance. So at least two questions have
to fit the same paper, each with all its numeric answers, and the Poisson distribution has to make
that rarer than the level for this student. How often a question fits by chance is the least of how
often each of its wrong answers does, and all of them together, on the papers of the exam.

A row that was typed one line too low is another student's as a whole: all its numbers are right on
that paper. `find_owner` finds whose it is, whatever questions it has; that changes no mark.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import groupby, zip_longest
from math import prod

import numpy as np
from numpy.typing import NDArray

from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.papers import Paper
from kinegrade.exam.folder.sitting import Sitting
from kinegrade.grading.fast.bounds import Flags, Numbers, Places
from kinegrade.grading.fast.intervals import Intervals, SortedIntervals, list_intervals
from kinegrade.grading.fast.paper_cells import PaperCells, list_cells
from kinegrade.grading.poisson import QUESTIONS_THAT_TELL, find_tail

_LEVEL = 0.02
_NUMBERS_THAT_TELL = 2  # at least, of a row that is held to be another student's
_WIDENED = 20  # times a tolerance: how densely right answers lie in a small class


@dataclass(frozen=True, slots=True)
class _Fitting:
    """Which papers the answers to a question fit, and how often a paper does so by chance."""

    question: range
    papers: Flags
    share: float


@dataclass(frozen=True)
class PapersAnswered:
    """The papers of a sitting, read once an answer is held against them."""

    sitting: Sitting

    @cached_property
    def questions(self) -> Sequence[range]:
        """The positions of each question's asks among all asks."""
        return group_places(self.sitting.asks)

    @cached_property
    def intervals(self) -> list[Intervals]:
        """Those of each ask, on the papers of the students and of a pool. Raises ExamError where
        the papers cannot be read.
        """
        return list_intervals(self.sitting)

    @cached_property
    def different(self) -> Places:
        """The first student of each lot that has the same paper, as where there are versions."""
        values = [each.value[: len(self.sitting.students)] for each in self.intervals]
        if any(len(np.unique(each)) == len(each) for each in values):
            return np.arange(len(self.sitting.students))
        first: Places = np.unique(np.column_stack(values), axis=0, return_index=True)[1]
        first.sort()
        return first

    @cached_property
    def _students(self) -> list[Intervals]:
        """The intervals on the different papers of students."""
        count = len(self.different)
        all_differ = count == len(self.sitting.students)
        return [each.at(slice(count) if all_differ else self.different) for each in self.intervals]

    @cached_property
    def _sorted(self) -> dict[int, SortedIntervals]:
        """Those of each ask that were put in the order of their values."""
        return {}

    def _sort(self, ask: int) -> SortedIntervals:
        """Those of an ask in that order, put so when they are first asked for."""
        if ask not in self._sorted:
            self._sorted[ask] = SortedIntervals.of(self._students[ask])
        return self._sorted[ask]

    @cached_property
    def _cells(self) -> list[PaperCells]:
        """By asks of different questions together: those of one follow from each other."""
        asks = (ask for each in zip_longest(*self.questions) for ask in each if ask is not None)
        whole = [ask for ask in asks if self._students[ask].is_plain]
        return list_cells(whole, self._students)

    def find_shared(self, paper: Paper, numbers: Numbers, wrong: Flags) -> Sequence[range]:
        """The questions that a student answered as is right on one other paper; `numbers` are the
        student's by ask, NaN where there is none, and `wrong` where they are on the own `paper`.

        Raises ExamError where the papers cannot be read.
        """
        own = np.array(paper.keys.list_values(), dtype=np.float64)
        tried = [question for question in self.questions if wrong[list(question)].any()]
        if len(tried) < QUESTIONS_THAT_TELL:
            return ()
        found = [self._fitting(question, own, numbers, wrong) for question in tried]
        counts = np.sum([each.papers for each in found], axis=0)
        other = int(counts.argmax())
        count, mean = int(counts[other]), sum(each.share for each in found)
        if count < QUESTIONS_THAT_TELL or len(counts) * find_tail(count, mean) > _LEVEL:
            return ()
        return [each.question for each in found if each.papers[other]]

    def list_suspect(self, numbers: NDArray[np.float64], wrong: NDArray[np.bool_]) -> list[int]:
        """The rows for which `find_owner` may find somebody: those with two wrong numbers of which
        some paper has all numbers, and those where that cannot be told at a glance.

        Raises ExamError where the papers cannot be read.
        """
        amiss = wrong & ~np.isnan(numbers)
        rows = np.flatnonzero(amiss.sum(axis=1) >= _NUMBERS_THAT_TELL)
        for cells in self._cells if len(rows) else ():
            rows = rows[cells.may_have(numbers[rows])]
        if not len(rows):
            return []
        # Any number of a row will do to look for papers by, and few asks to put in order
        plain = ~np.isnan(numbers[rows]) & np.array([not each.period for each in self._students])
        first = plain.argmax(axis=1)
        told = plain.any(axis=1)
        found = [rows[~told]]
        for ask in np.unique(first[told]).tolist():
            these = rows[told & (first == ask)]
            found.append(these[self._have_all(numbers[these], ask)])
        return sorted(np.concatenate(found).tolist())

    def _have_all(self, numbers: NDArray[np.float64], ask: int) -> Places:
        """The rows of which some paper has the number of this ask, and all others that tell."""
        rows, papers = self._sort(ask).pair(numbers[:, ask])
        for other, intervals in enumerate(self._students):
            if other == ask or intervals.period or not len(rows):
                continue
            fits = intervals.may_fit(numbers[rows, other], papers)
            rows, papers = rows[fits], papers[fits]
        return np.unique(rows)

    def find_owner(self, paper: Paper, numbers: Numbers, wrong: Flags) -> str:
        """The student on whose paper all numbers of a row are right, at least two of which are
        wrong on its own `paper`; "" where there is none, or where chance explains it.

        Raises ExamError where the papers cannot be read.
        """
        amiss = np.flatnonzero(wrong & ~np.isnan(numbers)).tolist()
        if len(amiss) < _NUMBERS_THAT_TELL:
            return ""
        others = self._list_candidates(numbers, amiss)
        for ask in [*amiss, *np.flatnonzero(~wrong & ~np.isnan(numbers)).tolist()]:
            others = others[self._students[ask].at(others).fit(numbers[[ask]])[0]]
            if not len(others):
                return ""
        by_chance = len(self.different) * prod(self._nearby(numbers, amiss))
        owner = self.sitting.students[self.different[others.min()]]
        return owner if owner != paper.student and by_chance <= _LEVEL else ""

    def _list_candidates(self, numbers: Numbers, amiss: Sequence[int]) -> Places:
        """The different papers on which the first of these numbers without full turns may be right;
        all where each has full turns.
        """
        for ask in amiss:
            if not self._students[ask].period:
                return self._sort(ask).list_near(float(numbers[ask]))
        return np.arange(len(self.different))

    def _nearby(self, numbers: Numbers, amiss: Sequence[int]) -> Iterator[float]:
        """For each of these numbers the share of different papers on which it would be right by
        chance; the paper that is found does not count.
        """
        for ask in amiss:
            intervals, answer = self._students[ask], numbers[[ask]]
            found = intervals.fit(answer).sum() - 1
            around = intervals.widened(_WIDENED).fit(answer).sum() / _WIDENED
            yield float(max(found, around)) / len(intervals.value)

    def _fitting(self, question: range, own: Numbers, numbers: Numbers, wrong: Flags) -> _Fitting:
        differ = [self.intervals[ask].differ(own[[ask]])[0] for ask in question]
        fits: Flags = np.any(differ, axis=0)
        for ask in question:
            if not np.isnan(numbers[ask]):
                fits &= self.intervals[ask].fit(numbers[[ask]])[0]
        together = max(1, int(fits.sum())) / len(fits)
        return _Fitting(question, fits, min([together, *self._shares(question, numbers, wrong)]))

    def _shares(self, question: range, numbers: Numbers, wrong: Flags) -> Iterator[float]:
        """The share of all papers on which each wrong answer is right, or would be if as many of
        their answers lay next to it as lie around it.
        """
        for ask in question:
            if wrong[ask]:
                intervals, answer = self.intervals[ask], numbers[[ask]]
                around = intervals.widened(_WIDENED).fit(answer).mean() / _WIDENED
                yield max(intervals.fit(answer).mean(), around)


def group_places(asks: Sequence[Ask]) -> Sequence[range]:
    """The positions of each question's asks among all asks."""
    groups = groupby(range(len(asks)), lambda place: asks[place].question)
    return [range(places[0], places[-1] + 1) for places in (list(group) for _, group in groups)]
