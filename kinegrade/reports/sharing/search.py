"""The search for pairs of students whose answers fit, and what chance alone would give.

`sharing` says what is counted, and why.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from kinegrade.exam.folder.keys import NOT_ASKED, Examinee, KeyedExam
from kinegrade.grading.fast.bounds import Numbers
from kinegrade.grading.poisson import QUESTIONS_THAT_TELL, find_tail
from kinegrade.reports.sharing.fits import Windows, find_windows
from kinegrade.reports.sharing.wrong_answers import WrongAnswers

_CELLS = 4_000_000  # pairs of students examined together, to bound memory
_COUNTS = 2  # right answers, and right answers or mistakes


@dataclass(frozen=True, slots=True)
class SharedAnswer:
    """An answer in `column` that fits another paper; `as_key` is whether it would be right there,
    otherwise it fits as a mistake.
    """

    column: str
    typed: str
    as_key: bool


@dataclass(frozen=True, slots=True)
class Pair:
    """A student whose wrong answers fit another student's paper, and how many are expected to by
    chance.

    `as_key_expected` is the same for what would be right there alone. `chance` is how often a class
    of this size has such a pair by chance, at most 1.
    """

    student: Examinee
    other: Examinee
    answers: tuple[SharedAnswer, ...]
    wrong: int
    expected: float
    as_key_expected: float
    chance: float


@dataclass(frozen=True, slots=True)
class _Found:
    """A pair, as the positions of its students."""

    student: int
    other: int
    chance: float


@dataclass(frozen=True)
class Search:
    """The search through a class; `unlike` holds for each student the number of others with a
    different paper.
    """

    exam: KeyedExam
    wrong: WrongAnswers
    unlike: Numbers
    level: float

    @property
    def pairs(self) -> int:
        """The number of ordered pairs of students, each of which might be reported."""
        return len(self.exam.examinees) * (len(self.exam.examinees) - 1)

    @cached_property
    def _windows(self) -> tuple[tuple[Windows, Windows], ...]:
        """For each ask what would be right on each paper, and the same together with what mistakes
        lead to.
        """
        keys = [
            [examinee.keys.get(ask.column, NOT_ASKED) for examinee in self.exam.examinees]
            for ask in self.exam.asks
        ]
        return tuple(
            (find_windows(each, mistakes=False), find_windows(each, mistakes=True)) for each in keys
        )

    def found(self) -> Iterator[_Found]:
        """The pairs below the level."""
        students = self._suspects()
        size = max(1, _CELLS // len(self.exam.examinees))
        for first in range(0, len(students), size):
            yield from self.among(students[first : first + size])

    def _suspects(self) -> NDArray[np.intp]:
        """The students with unexplained wrong answers to enough questions."""
        wrong = {
            question: np.zeros(len(self.exam.examinees), dtype=bool)
            for question in self.exam.questions
        }
        for ask, numbers in zip(self.exam.asks, self.wrong.numbers, strict=True):
            wrong[ask.question] |= ~np.isnan(numbers)
        return np.flatnonzero(np.sum(list(wrong.values()), axis=0) >= QUESTIONS_THAT_TELL)

    def among(self, students: NDArray[np.intp]) -> Iterator[_Found]:
        """The pairs of these students with any other."""
        counts = [_Count.of(len(students), len(self.exam.examinees)) for _ in range(_COUNTS)]
        for question in self.exam.questions:
            asks = [place for place, ask in enumerate(self.exam.asks) if ask.question == question]
            for kind, count in enumerate(counts):
                count.add([self._fitting(students, ask, kind) for ask in asks])
        chance = np.ones(counts[0].fits.shape)
        for count in counts:
            np.minimum(
                chance, self._chances(count, count.expected / self.unlike[students]), out=chance
            )
        for row, other in np.argwhere(chance <= self.level):
            yield _Found(int(students[row]), int(other), float(chance[row, other]))

    def _fitting(self, students: NDArray[np.intp], ask: int, kind: int) -> NDArray[np.bool_]:
        """Whose answer to one ask fits which paper: a row for each of these students, a column for
        each paper.
        """
        numbers = self.wrong.numbers[ask][students]
        given = np.flatnonzero(~np.isnan(numbers))
        answer, paper = self._windows[ask][kind].fits(numbers[given])
        fits = np.zeros((len(students), len(self.exam.examinees)), dtype=bool)
        fits[given[answer], paper] = True
        fits[np.arange(len(students)), students] = False
        return fits

    def _chances(self, count: _Count, expected: Numbers) -> Numbers:
        """For each pair how often a class has so many fits by chance; 1 where too few questions are
        involved.
        """
        most = int(count.fits.max(initial=0))
        tests = _COUNTS * self.pairs
        table = np.array(
            [
                [min(1.0, tests * find_tail(fits, mean)) for fits in range(most + 1)]
                for mean in expected
            ]
        )
        chance: Numbers = np.take_along_axis(table, count.fits.astype(np.intp), axis=1)
        return np.where(count.questions >= QUESTIONS_THAT_TELL, chance, 1.0)

    def pair(self, found: _Found) -> Pair:
        """A pair with everything reported about it."""
        student, other = found.student, found.other
        given = {
            ask: float(numbers[student])
            for ask, numbers in enumerate(self.wrong.numbers)
            if not np.isnan(numbers[student])
        }
        fits = [
            {
                ask: self._windows[ask][kind].papers(answer) - {student}
                for ask, answer in given.items()
            }
            for kind in range(_COUNTS)
        ]
        as_key, any_way = fits
        answers = tuple(
            SharedAnswer(
                self.exam.asks[ask].column, self.wrong.typed[student, ask], other in as_key[ask]
            )
            for ask in given
            if other in any_way[ask]
        )
        expected = [sum(map(len, each.values())) / float(self.unlike[student]) for each in fits]
        return Pair(
            self.exam.examinees[student],
            self.exam.examinees[other],
            answers,
            len(given),
            expected[1],
            expected[0],
            found.chance,
        )


@dataclass
class _Count:
    """For each student and paper how many answers fit, and to how many questions; for each student
    how many papers the answers fit in all.
    """

    fits: NDArray[np.uint16]
    questions: NDArray[np.uint16]
    expected: Numbers

    @classmethod
    def of(cls, students: int, papers: int) -> _Count:
        """A count of nothing yet."""
        fits, questions = (np.zeros((students, papers), dtype=np.uint16) for _ in range(2))
        return cls(fits, questions, np.zeros(students))

    def add(self, fitting: Sequence[NDArray[np.bool_]]) -> None:
        """Adds the asks of one question."""
        for fits in fitting:
            self.fits += fits
            self.expected += fits.sum(axis=1)
        self.questions += np.any(fitting, axis=0)
