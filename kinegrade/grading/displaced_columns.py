"""Columns of an answer sheet that were sorted or moved alone, so that each number stands beside
another student.

`DisplacedColumns` watches a marking for `grade`, block by block. A column was sorted if its numbers
stand in order from the first line to the last and most of them are wrong; it slipped where a run of
its numbers is wrong on the own papers and right on those of the line above or below. How often that
happens by chance is measured on papers of lines farther off.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from kinegrade.exam.folder.keys import Ask
from kinegrade.files.tables import Complaint
from kinegrade.grading.class_answers import ClassAnswers
from kinegrade.grading.fast.another_paper import PapersAnswered
from kinegrade.grading.fast.bounds import Flags, Numbers, Places
from kinegrade.grading.fast.intervals import Intervals
from kinegrade.grading.marks import MarkedBlock
from kinegrade.language.message import Message

_LEAST_SORTED = 10  # numbers in order: fewer may be so by chance
_LEAST_MOVED = 4  # wrong numbers in a run
_LEVEL = 0.01  # chance that any column of a class is told without reason
_FARTHER = (3, 4, 5, 6, 7, 8)  # lines off, on whose papers numbers are right by chance
_STEPS = (1, -1)  # a line down, a line up


class _Run(NamedTuple):
    """Numbers that slipped by a line: how many, on which lines the first and the last stand."""

    step: int
    length: int
    first: int
    last: int


@dataclass
class DisplacedColumns:
    """What has been seen so far of each row: its numbers, which of them are right or void, and its
    file and line, 0 where it has none.
    """

    asks: tuple[Ask, ...]
    numbers: list[Numbers] = field(default_factory=list)
    right: list[Flags] = field(default_factory=list)
    files: list[str] = field(default_factory=list)
    lines: list[int] = field(default_factory=list)

    def watched(self, blocks: Iterable[MarkedBlock]) -> Iterator[MarkedBlock]:
        """The same blocks, noted on their way."""
        for block in blocks:
            judged, width = block.judged, len(self.asks)
            self.numbers.append(judged.cells.values.reshape(-1, width))
            self.right.append(judged.are("right", "void", "accepted").reshape(-1, width))
            self.files += judged.rows.files
            self.lines += judged.rows.lines.tolist()
            yield block
            del block, judged  # so that the next takes its place

    def put_together(self) -> ClassAnswers:
        """All rows, after all blocks have been watched."""
        numbers, right = np.concatenate(self.numbers), np.concatenate(self.right)
        return ClassAnswers(numbers, right, self.files, self.lines)

    def list_complaints(
        self, papers: PapersAnswered, columns: Sequence[str]
    ) -> Iterator[Complaint]:
        """A complaint for each column that was sorted or slipped, after all blocks have been
        watched. Raises ExamError where the papers cannot be read.
        """
        ranks = {file: rank for rank, file in enumerate(sorted({*self.files}))}
        order = np.lexsort((self.lines, [ranks[file] for file in self.files]))
        order = order[np.array(self.lines)[order] > 0]
        if len(order) < _LEAST_MOVED:
            return
        numbers = np.concatenate(self.numbers)[order]
        wrong = ~np.concatenate(self.right)[order] & ~np.isnan(numbers)
        for ask, title in enumerate(columns):
            own, amiss = numbers[:, ask], wrong[:, ask]
            if _is_sorted(own, amiss):
                yield self._complain_of_order(order, title, own, amiss)
            elif amiss.sum() >= _LEAST_MOVED:
                run = _Column(papers.intervals[ask], own, amiss, order).find_run(len(columns))
                if run is not None:
                    yield self._complain_of_run(order, title, run)

    def _complain_of_order(
        self, order: Places, title: str, numbers: Numbers, wrong: Flags
    ) -> Complaint:
        count = int((~np.isnan(numbers)).sum())
        problem = Message("marking.column-sorted", count=count, wrong=int(wrong.sum()))
        return self._complain(order[0], title, problem)

    def _complain_of_run(self, order: Places, title: str, run: _Run) -> Complaint:
        first, last = (self.lines[order[each]] for each in (run.first, run.last))
        kind = "down" if run.step > 0 else "up"
        where = {"first": str(first), "last": str(last)}
        problem = Message(f"marking.column-moved-{kind}", count=run.length, **where)
        return self._complain(order[run.first], title, problem)

    def _complain(self, row: int, title: str, problem: Message) -> Complaint:
        done = Message("marking.check-column")
        return Complaint(self.files[row], self.lines[row], title, "", problem, done)


def _is_sorted(numbers: Numbers, wrong: Flags) -> bool:
    """Whether the numbers of a column stand in order, most of them wrong."""
    given = numbers[~np.isnan(numbers)]
    if len(np.unique(given)) < _LEAST_SORTED or 2 * wrong.sum() <= len(given):
        return False
    steps = np.diff(given)
    return bool((steps >= 0).all() or (steps <= 0).all())


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
        fits, wrong = self._fit_beside(step)[given], self.wrong[given]
        runs = np.cumsum(~fits)
        moved = fits & wrong
        counts = np.bincount(runs[moved], minlength=1)
        rows = given[moved & (runs == counts.argmax())]
        if not len(rows):
            return _Run(step, 0, 0, 0)
        return _Run(step, len(rows), int(rows[0]), int(rows[-1]))

    def _measure_chance(self) -> float:
        """The share of wrong numbers that are right on papers of lines farther off."""
        found = [self._fit_beside(step * far)[self.wrong] for step in _STEPS for far in _FARTHER]
        fits = np.concatenate(found)
        return float(fits.sum() + 1) / (len(fits) + 1)

    def _fit_beside(self, step: int) -> Flags:
        """Which numbers are right on the paper of the line so far above; none where there is no
        such line.
        """
        beside = np.roll(self.papers, step)
        fits = self.intervals.fit_beside(self.numbers, beside)
        if step > 0:
            fits[:step] = False
        else:
            fits[step:] = False
        return fits
