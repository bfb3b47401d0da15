"""The search for pairs of students whose answers fit, and what chance alone would give.

`sharing` says what is counted, and why.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinegrade.exam.folder.asks import list_questions
from kinegrade.grading.fast.bounds import Flags, Numbers, Places
from kinegrade.grading.poisson import QUESTIONS_THAT_TELL, find_tail
from kinegrade.reports.sharing.class_keys import ClassKeys, Person
from kinegrade.reports.sharing.wrong_answers import WrongAnswers

_CELLS = 4_000_000  # pairs of students examined together, to bound memory
_NEARLY = 1.001  # times the level: what rounding may do to a chance
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

    student: Person
    other: Person
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
    """The search through a class, for pairs whose chance is at most the level."""

    keys: ClassKeys
    wrong: WrongAnswers
    level: float

    @property
    def students(self) -> int:
        """How many there are."""
        return len(self.keys.people)

    @property
    def pairs(self) -> int:
        """The number of ordered pairs of students, each of which might be reported."""
        return self.students * (self.students - 1)

    @property
    def questions(self) -> Sequence[str]:
        """What was asked."""
        return list_questions(self.keys.asks)

    def found(self) -> Iterator[_Found]:
        """The pairs below the level."""
        students = self._suspects()
        size = max(1, _CELLS // self.students)
        for first in range(0, len(students), size):
            yield from self.among(students[first : first + size])

    def _suspects(self) -> Places:
        """The students with unexplained wrong answers to enough questions, and to enough papers."""
        wrong = {question: np.zeros(self.students, dtype=bool) for question in self.questions}
        for ask, numbers in zip(self.keys.asks, self.wrong.numbers, strict=True):
            wrong[ask.question] |= ~np.isnan(numbers)
        many = np.flatnonzero(np.sum(list(wrong.values()), axis=0) >= QUESTIONS_THAT_TELL)
        return many[np.any([self._may_tell(many, kind) for kind in range(_COUNTS)], axis=0)]

    def _may_tell(self, students: Places, kind: int) -> Flags:
        """False only where no pair of a student is below the level, even if all answers that fit
        any paper fitted one, and each of them no more papers than it does at least.
        """
        fitting, papers = np.zeros(len(students), dtype=np.intp), np.zeros(len(students))
        for windows, numbers in zip(self.keys.windows, self.wrong.numbers, strict=True):
            least = windows[kind].count_least(numbers[students])
            fitting += least > 0
            papers += np.maximum(least - 1, 0)  # the own paper does not count
        means = papers / self.keys.unlike[students]
        tails = map(find_tail, fitting.tolist(), means.tolist())
        rarest = np.fromiter(tails, dtype=np.float64, count=len(students))
        may: Flags = _COUNTS * self.pairs * rarest <= _NEARLY * self.level
        return may

    def among(self, students: Places) -> Iterator[_Found]:
        """The pairs of these students with any other."""
        counts = [_Count.of(len(students), self.students) for _ in range(_COUNTS)]
        for question in self.questions:
            asks = [place for place, ask in enumerate(self.keys.asks) if ask.question == question]
            for kind, count in enumerate(counts):
                count.add([self._fitting(students, ask, kind) for ask in asks])
        chance = np.ones(counts[0].fits.shape)
        for count in counts:
            means = count.expected / self.keys.unlike[students]
            np.minimum(chance, self._chances(count, means), out=chance)
        for row, other in np.argwhere(chance <= self.level):
            yield _Found(int(students[row]), int(other), float(chance[row, other]))

    def _fitting(self, students: Places, ask: int, kind: int) -> Flags:
        """Whose answer to one ask fits which paper: a row for each of these students, a column for
        each paper.
        """
        numbers = self.wrong.numbers[ask][students]
        given = np.flatnonzero(~np.isnan(numbers))
        answer, paper = self.keys.windows[ask][kind].fits(numbers[given])
        fits = np.zeros((len(students), self.students), dtype=bool)
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
                ask: self.keys.windows[ask][kind].papers(answer) - {student}
                for ask, answer in given.items()
            }
            for kind in range(_COUNTS)
        ]
        as_key, any_way = fits
        answers = tuple(
            SharedAnswer(
                self.keys.asks[ask].column, self.wrong.typed[student, ask], other in as_key[ask]
            )
            for ask in given
            if other in any_way[ask]
        )
        expected = [
            sum(map(len, each.values())) / float(self.keys.unlike[student]) for each in fits
        ]
        return Pair(
            self.keys.people[student],
            self.keys.people[other],
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

    def add(self, fitting: Sequence[Flags]) -> None:
        """Adds the asks of one question."""
        for fits in fitting:
            self.fits += fits
            self.expected += fits.sum(axis=1)
        self.questions += np.any(fitting, axis=0)
