"""Rows of which most numbers are wrong where they stand, and right elsewhere: in another column of
the same paper, without the decimal mark that was lost, or on the paper of another student.

A row is told if more of its numbers are right there than chance explains, which is measured on
papers that have nothing to do with it. No mark is changed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple, TypeAlias

import numpy as np

from kinegrade.files.tables import Complaint
from kinegrade.grading.fast.bounds import Flags, Numbers, Places
from kinegrade.grading.fast.intervals import AsksBeside, Intervals
from kinegrade.grading.misplaced.class_answers import ClassAnswers
from kinegrade.grading.poisson import QUESTIONS_THAT_TELL, find_tail
from kinegrade.language.message import Message, Quoted

_LEAST_WRONG = 3  # answers of a row: fewer may be right elsewhere by chance
_MOST_OF_THEM = 0.6
_MANY_OF_THEM = 0.4  # where none is right on the own paper, and two questions are elsewhere
_LEVEL = 0.01  # chance that any row of a class is told without reason
_FARTHER = (3, 4, 5, 6, 7, 8)  # lines off, on whose papers numbers are right by chance
_SHIFTS = np.array(
    [10.0, 100.0, 1e3, 1e4, 1e5, 1e6]
)  # what a lost decimal mark multiplies a number by
_TOGETHER = 2000  # papers that rows are held against: they are exchanged with rows nearby
_WIDENED = 20  # times a tolerance: how densely right answers lie in a small class


# By the papers beside some rows: which answers to an ask fit them
_Fit: TypeAlias = Callable[[Places], Callable[[int, Numbers], Flags]]


class _Elsewhere(NamedTuple):
    """A row that is right elsewhere, and what is said of it."""

    row: int
    problem: Message


@dataclass(frozen=True)
class MisplacedRows:
    """The answers of a class beside its papers, which are in the order of the rows, and of which
    those of `different` are no two alike; `students` are their ids, `asks` those that are looked
    at, `questions` the asks of each.
    """

    intervals: Sequence[Intervals]
    different: Places
    students: Sequence[str]
    answers: ClassAnswers
    asks: Sequence[int]
    questions: Sequence[range]

    def list_complaints(self) -> Iterator[Complaint]:
        """A complaint for each row that is right elsewhere, which says where."""
        if not len(self._rows):
            return
        told: dict[int, _Elsewhere] = {}
        for found in (self._find_exchanged(), self._find_unpointed(), self._find_of_others()):
            for each in found:
                told.setdefault(each.row, each)
        for row in sorted(told):
            yield self.answers.complain(row, told[row].problem, Message("marking.check-row"))

    @cached_property
    def _wrong(self) -> Flags:
        wrong: Flags = self.answers.wrong[:, self.asks]
        return wrong

    @cached_property
    def _right(self) -> Flags:
        """Which numbers have full credit."""
        right: Flags = (self.answers.given & ~self.answers.wrong)[:, self.asks]
        return right

    @cached_property
    def _rows(self) -> Places:
        """The rows of which most numbers are wrong, and enough of them."""
        counts = self._wrong.sum(axis=1)
        return np.flatnonzero((counts >= _LEAST_WRONG) & (counts > self._right.sum(axis=1)))

    def _find_exchanged(self) -> Iterator[_Elsewhere]:
        """The rows that are right in other columns of their own papers."""
        for row, count, wrong in self._choose(self._fit_other_columns):
            problem = Message("marking.row-misplaced", count=count, wrong=wrong)
            yield _Elsewhere(row, problem)

    def _find_unpointed(self) -> Iterator[_Elsewhere]:
        """The rows whose whole numbers are right with a decimal mark in them."""
        for row, count, wrong in self._choose(self._fit_with_marks):
            problem = Message("marking.row-unpointed", count=count, wrong=wrong)
            yield _Elsewhere(row, problem)

    def _fit_other_columns(self, papers: Places) -> Callable[[int, Numbers], Flags]:
        """Which answers are right in another place of the paper beside each."""
        beside = AsksBeside.of(self.intervals, papers)

        def fit(ask: int, answers: Numbers) -> Flags:
            fits: Flags = beside.fit(answers)
            fits[ask] = False
            found: Flags = np.any(fits, axis=0)
            return found

        return fit

    def _fit_with_marks(self, papers: Places) -> Callable[[int, Numbers], Flags]:
        """Which whole numbers are right on the paper beside each with a decimal mark in them."""

        def fit(ask: int, answers: Numbers) -> Flags:
            fits: Flags = answers == np.rint(answers)
            whole = np.flatnonzero(fits)
            shifted = answers[whole] / _SHIFTS[:, None]
            fits[whole] = self.intervals[ask].fit_beside(shifted, papers[whole]).any(axis=0)
            return fits

        return fit

    def _choose(self, fit: _Fit) -> Iterator[tuple[int, int, int]]:
        """The rows of which more fits than on papers of lines farther off, with how much and of how
        many wrong numbers.
        """
        wrong = self._wrong[self._rows].sum(axis=1)
        found = self._count(fit, self._rows)
        papers = [(self._rows + far) % len(self.answers.numbers) for far in _FARTHER]
        by_chance = sum(int(self._count(fit, each).sum()) for each in papers) + 1
        share = by_chance / (len(papers) * int(wrong.sum()) + 1)
        for row, count, of in zip(self._rows.tolist(), found.tolist(), wrong.tolist(), strict=True):
            enough = count >= max(_LEAST_WRONG, _MOST_OF_THEM * of)
            if enough and len(self._rows) * find_tail(count, share * of) <= _LEVEL:
                yield row, count, of

    def _count(self, fit: _Fit, papers: Places) -> Places:
        """How many wrong numbers of each row fit the paper beside it."""
        counts, fit_ask = np.zeros(len(self._rows), dtype=np.intp), fit(papers)
        for place, ask in enumerate(self.asks):
            fits = fit_ask(ask, self.answers.numbers[self._rows, ask])
            counts += fits & self._wrong[self._rows, place]
        return counts

    def _find_of_others(self) -> Iterator[_Elsewhere]:
        """The rows that are mostly right on the paper of another student, but not wholly: those are
        told where they stand.
        """
        for rows, papers in self._list_blocks():
            yield from self._find_owners(rows, papers)

    def _list_blocks(self) -> Iterator[tuple[Places, Places]]:
        """The rows, and the different papers that they are held against."""
        if len(self.different) <= _TOGETHER:
            yield self._rows, self.different
            return
        blocks = self._rows // _TOGETHER
        for block in np.unique(blocks).tolist():
            nearest = int(np.searchsorted(self.different, block * _TOGETHER))
            first = min(nearest, len(self.different) - _TOGETHER)
            yield self._rows[blocks == block], self.different[first : first + _TOGETHER]

    def _find_owners(self, rows: Places, papers: Places) -> Iterator[_Elsewhere]:
        """The same, of these rows on these papers."""
        given = self.answers.given[rows][:, self.asks].sum(axis=1)
        counts = np.zeros((len(rows), len(papers)), dtype=np.uint16)
        for ask in self.asks:
            fits = self.intervals[ask].at(papers).list_fits(self.answers.numbers[rows, ask])
            counts[fits] += 1
        best, most, right = counts.argmax(axis=1), counts.max(axis=1), self._right[rows].sum(axis=1)
        mostly = most >= np.maximum(_LEAST_WRONG, _MOST_OF_THEM * given)
        many = (most >= np.maximum(_LEAST_WRONG, _MANY_OF_THEM * given)) & (right == 0)
        for place in np.flatnonzero((mostly | many) & (most > right) & (most < given)).tolist():
            row, count = int(rows[place]), int(most[place])
            if not mostly[place] and not self._fits_questions(row, int(papers[best[place]])):
                continue
            mean = self._expect_by_chance(row, papers)
            if len(rows) * len(papers) * find_tail(count, mean) <= _LEVEL:
                other = Quoted(self.students[papers[best[place]]])
                kinds = {"count": count, "given": int(given[place]), "right": int(right[place])}
                problem = Message("marking.row-mostly-of-another", **kinds, other=other)
                yield _Elsewhere(row, problem)

    def _fits_questions(self, row: int, paper: int) -> bool:
        """Whether answers to several questions of a row are right on a paper: a number misread may
        give all those to one question.
        """
        own = np.array([paper])
        fitting = {
            ask
            for ask in self.asks
            if self.intervals[ask].fit_beside(self.answers.numbers[[row], ask], own)[0]
        }
        touched = sum(not fitting.isdisjoint(question) for question in self.questions)
        return touched >= QUESTIONS_THAT_TELL

    def _expect_by_chance(self, row: int, papers: Places) -> float:
        """How many answers of a row are right by chance on one of these papers."""
        answers = ((ask, self.answers.numbers[[row], ask]) for ask in self.asks)
        return sum(_measure_density(self.intervals[ask].at(papers), each) for ask, each in answers)


def _measure_density(intervals: Intervals, answer: Numbers) -> float:
    """The share of papers on which an answer is right by chance: not counting the one that is
    looked for, or as densely as right answers lie around it.
    """
    by_chance = max(int(intervals.fit(answer).sum()) - 1, 0) / len(intervals.value)
    return max(by_chance, float(intervals.widened(_WIDENED).fit(answer).mean()) / _WIDENED)
