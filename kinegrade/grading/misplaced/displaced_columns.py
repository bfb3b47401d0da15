"""Columns of an answer sheet that were sorted or moved alone, so that each number stands beside
another student.

A column was sorted if its numbers
stand in order from the first line to the last and most of them are wrong; it slipped where a run of
its numbers is wrong on the own papers and right on those of the line above or below. How often that
happens by chance is measured on papers of lines farther off.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from kinegrade.files.tables import Complaint
from kinegrade.grading.fast.bounds import Flags, Numbers, Places
from kinegrade.grading.fast.intervals import Intervals
from kinegrade.grading.misplaced.class_answers import ClassAnswers
from kinegrade.language.message import Message

_LEAST_SORTED = 10  # numbers in order: fewer may be so by chance
_LEAST_MOVED = 3  # wrong numbers in a run
_LEVEL = 0.01  # chance that any column of a class is told without reason
_FARTHER = (3, 4, 5, 6, 7, 8)  # lines off, on whose papers numbers are right by chance
_STEPS = (1, -1)  # a line down, a line up


class _Run(NamedTuple):
    """Numbers that slipped by a line: how many, on which lines the first and the last stand."""

    step: int
    length: int
    first: int
    last: int


@dataclass(frozen=True)
class DisplacedColumns:
    """The answers of a class beside its papers, which are in the order of the rows, with the
    `titles` of its columns.
    """

    intervals: Sequence[Intervals]
    titles: Sequence[str]
    answers: ClassAnswers

    def list_complaints(self) -> Iterator[Complaint]:
        """A complaint for each column that was sorted or slipped."""
        files, lines = self.answers.files, self.answers.lines
        ranks = {file: rank for rank, file in enumerate(sorted({*files}))}
        order = np.lexsort((lines, [ranks[file] for file in files]))
        order = order[np.array(lines)[order] > 0]
        if len(order) < _LEAST_MOVED:
            return
        found = self.answers.numbers, self.answers.wrong
        numbers, wrong = (np.ascontiguousarray(each[order].T) for each in found)
        for ask, (title, own, amiss) in enumerate(zip(self.titles, numbers, wrong, strict=True)):
            if _is_sorted(own, amiss):
                yield self._complain_of_order(order, title, own, amiss)
            elif amiss.sum() >= _LEAST_MOVED:
                run = _Column(self.intervals[ask], own, amiss, order).find_run(len(self.titles))
                if run is not None:
                    yield self._complain_of_run(order, title, run)

    def _complain_of_order(
        self, order: Places, title: str, numbers: Numbers, wrong: Flags
    ) -> Complaint:
        count = int((~np.isnan(numbers)).sum())
        problem = Message("marking.column-sorted", count=count, wrong=int(wrong.sum()))
        return self._complain(order[0], title, problem)

    def _complain_of_run(self, order: Places, title: str, run: _Run) -> Complaint:
        first, last = (self.answers.lines[order[each]] for each in (run.first, run.last))
        kind = "down" if run.step > 0 else "up"
        where = {"first": str(first), "last": str(last)}
        problem = Message(f"marking.column-moved-{kind}", count=run.length, **where)
        return self._complain(order[run.first], title, problem)

    def _complain(self, row: int, title: str, problem: Message) -> Complaint:
        done = Message("marking.check-column")
        return Complaint(self.answers.files[row], self.answers.lines[row], title, "", problem, done)


def _is_sorted(numbers: Numbers, wrong: Flags) -> bool:
    """Whether the numbers of a column stand in order, most of them wrong."""
    given = numbers[~np.isnan(numbers)]
    steps = np.diff(given)
    if 2 * wrong.sum() <= len(given) or not ((steps >= 0).all() or (steps <= 0).all()):
        return False
    return 1 + int(np.count_nonzero(steps)) >= _LEAST_SORTED


@dataclass(frozen=True, slots=True)
class _Column:
    """The numbers of a column in the order of their lines, which of them are wrong, and whose
    papers they are marked by.
    """

    intervals: Intervals
    numbers: Numbers
    wrong: Flags
    papers: Places

    def find_run(self, columns: int) -> _Run | None:
        """The longest run of numbers that slipped by a line; None where chance explains it."""
        runs = [self._find_longest(step) for step in _STEPS]
        longest = max(runs, key=lambda run: run.length)
        if longest.length < _LEAST_MOVED:
            return None
        tried = len(_STEPS) * columns * int(self.wrong.sum())
        by_chance = tried * self._measure_chance() ** longest.length
        return longest if by_chance <= _LEVEL else None

    def _find_longest(self, step: int) -> _Run:
        """The run in which each number is right on the paper of the line so far above, and most are
        wrong on their own.
        """
        given = np.flatnonzero(~np.isnan(self.numbers))
        wrong, fits = self.wrong[given], np.zeros(len(given), dtype=np.bool_)
        amiss, others = np.flatnonzero(wrong), np.flatnonzero(~wrong)
        fits[amiss] = self._fit_beside(step, given[amiss])
        # In a run, what is next to each of them but the last fits too: so few do that it is told
        # here for most columns
        moving = np.flatnonzero(fits)
        following = given[moving[moving < len(given) - 1] + 1]
        if self._fit_beside(step, following).sum() < _LEAST_MOVED - 1:
            return _Run(step, 0, 0, 0)
        fits[others] = self._fit_beside(step, given[others])
        runs = np.cumsum(~fits)
        moved = fits & wrong
        counts = np.bincount(runs[moved], minlength=1)
        rows = given[moved & (runs == counts.argmax())]
        if not len(rows):
            return _Run(step, 0, 0, 0)
        return _Run(step, len(rows), int(rows[0]), int(rows[-1]))

    def _measure_chance(self) -> float:
        """The share of wrong numbers that are right on papers of lines farther off."""
        rows = np.flatnonzero(self.wrong)
        found = [self._fit_beside(step * far, rows) for step in _STEPS for far in _FARTHER]
        fits = np.concatenate(found)
        return float(fits.sum() + 1) / (len(fits) + 1)

    def _fit_beside(self, step: int, rows: Places) -> Flags:
        """Which numbers of these rows are right on the paper of the line so far above; none where
        there is no such line.
        """
        beside = rows - step
        fits: Flags = (beside >= 0) & (beside < len(self.papers))
        there = np.flatnonzero(fits)
        papers = self.papers[beside[there]]
        fits[there] = self.intervals.fit_beside(self.numbers[rows[there]], papers)
        return fits
