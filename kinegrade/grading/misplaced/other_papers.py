"""Whether a class answered papers other than those by which it is marked: a pool, or papers handed
out in a different order.

This costs a count as long as most answers are right or explained; only if they are not, the answers
of some students are compared with all papers of the exam.

An answer is foreign if all numeric answers of its student to its question are right on one other
paper, and not all of them are right on the student's paper. In a large class many wrong numbers are
right on some paper by chance. How often is measured on papers that no student had, whose keys are
moved by a few per cent.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinegrade.errors import ExamError
from kinegrade.grading.fast.another_paper import PapersAnswered
from kinegrade.grading.fast.bounds import Flags, Numbers
from kinegrade.grading.fast.intervals import Intervals
from kinegrade.grading.misplaced.class_answers import ClassAnswers
from kinegrade.language.message import Fault, Message

_LOOKED_AT = 400  # students, evenly across the class: enough for a share, few enough for any class
_LEAST = 4  # answers: fewer say nothing about a class
_BY_CHANCE = 0.5  # of the foreign answers: this many may also be foreign by chance
_MOVED = (0.93, 1.07)  # factors for keys that no student had
_MOSTLY = 0.6  # of a student's answers


def refuse_other_papers(answers: ClassAnswers, papers: PapersAnswered, file: str) -> None:
    """Raises ExamError where most answers fit papers other than those by which they are marked."""
    count = int(answers.given.sum())
    strange = int((answers.wrong & ~answers.explained).sum())
    if count < _LEAST or 2 * strange <= count:
        return
    places = np.arange(0, len(answers.numbers), max(1, len(answers.numbers) // _LOOKED_AT))
    some = _Answers(answers.numbers[places], answers.right[places], places)
    if _are_of_others(some, papers):
        problem = Message("marking.other-papers", count=count, wrong=strange)
        expected, do = Message("marking.own-answers"), Message("marking.check-rows")
        raise ExamError(Fault(file, problem, expected, do))


def _are_of_others(answers: _Answers, papers: PapersAnswered) -> bool:
    """Whether more of these answers than chance explains are right on papers of others."""
    bounds, questions = papers.intervals, papers.questions
    found = answers.foreign(bounds, questions)
    chance = _expect_by_chance(lambda moved: answers.foreign(moved, questions), bounds)
    if 2 * found > answers.count and chance <= _BY_CHANCE * found:
        return True
    swapped = answers.swapped(bounds)
    return (
        2 * swapped > answers.students
        and _expect_by_chance(answers.swapped, bounds) <= _BY_CHANCE * swapped
    )


@dataclass(frozen=True, slots=True)
class _Answers:
    """The numbers of some students, NaN where there is none, and which of them are right on the
    students' papers.

    `places` are the positions of these papers among all.
    """

    numbers: Numbers
    right: Flags
    places: NDArray[np.intp]

    @property
    def students(self) -> int:
        """The number of students who gave enough numbers to say anything."""
        return int(((~np.isnan(self.numbers)).sum(axis=1) >= _LEAST).sum())

    @property
    def count(self) -> int:
        """The number of numeric answers."""
        return int((~np.isnan(self.numbers)).sum())

    def foreign(self, bounds: Sequence[Intervals], questions: Sequence[Sequence[int]]) -> int:
        """The number of foreign answers."""
        found = 0
        for places in questions:
            given = ~np.isnan(self.numbers[:, places])
            all_right = (self.right[:, places] | ~given).all(axis=1)
            fits = self._others([bounds[place] for place in places])
            for place in places:
                blank = np.isnan(self.numbers[:, place])
                fits &= bounds[place].fit(self.numbers[:, place]) | blank[:, None]
            found += int(given[fits.any(axis=1) & ~all_right].sum())
        return found

    def swapped(self, bounds: Sequence[Intervals]) -> int:
        """The number of students who mostly gave the right answers of one other paper."""
        given = (~np.isnan(self.numbers)).sum(axis=1)
        counts = np.zeros((len(self.numbers), len(bounds[0].value)), dtype=np.uint16)
        for place, each in enumerate(bounds):
            counts += each.fit(self.numbers[:, place])
        counts[~self._others(bounds)] = 0
        most = counts.max(axis=1, initial=0)
        right = (self.right & ~np.isnan(self.numbers)).sum(axis=1)
        return int(((most >= _MOSTLY * given) & (most > right) & (given >= _LEAST)).sum())

    def _others(self, bounds: Sequence[Intervals]) -> Flags:
        """For each student the papers that differ from the student's in these asks."""
        differ = np.zeros((len(self.places), len(bounds[0].value)), dtype=np.bool_)
        for each in bounds:
            differ |= each.differ(each.value[self.places])
        return differ


def _expect_by_chance(
    count: Callable[[Sequence[Intervals]], int], bounds: Sequence[Intervals]
) -> float:
    """How many there are on papers that no student had."""
    return sum(count([each.moved(factor) for each in bounds]) for factor in _MOVED) / len(_MOVED)
