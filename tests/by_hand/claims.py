"""What is claimed of the marks of students written by hand, and the answers that refute it.

Each claim gives a `Count`: how many answers were tried, by what they are, and those that failed. In
a turn every paper of the exam is typed and marked once; from one turn to the next a student goes on
to another method, mistake or wrong value of those that are written.
"""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TypeVar

from tests.by_hand.class_list import TAUGHT
from tests.by_hand.pad import EXACT, Answers, Edge, Method, Pad, attempt
from tests.by_hand.school import Exam, Mark, Paper, Question

NEAR = 1e-6  # of the right answer: what a machine's rounding leaves between two ways of working
ZERO = 1e-12  # in any unit: what a machine's rounding leaves of zero
OPPOSITE = -1.0  # the factor of a wrong sign
STRIDE = 37  # a prime: whatever there is to choose from, every student comes to all of it
VANISHING = 1 / 20  # of the right answer: from less nothing follows

Choice = TypeVar("Choice")
Dealt = dict[tuple[str, str], Choice]  # by student and question
Named = tuple[str, Method]
Wrong = tuple[str, str, float]  # mistake, ask, value
Own = tuple[Edge, float]  # and the factor by which the earlier value is wrong


@dataclass
class Count:
    """Answers tried and answers that failed, under the name of what was tried."""

    tried: Counter[str] = field(default_factory=Counter)
    failed: defaultdict[str, list[Mark]] = field(default_factory=lambda: defaultdict(list))

    def add(self, where: str, kept: bool, mark: Mark) -> None:
        """One more answer."""
        self.tried[where] += 1
        if not kept:
            self.failed[where].append(mark)

    @property
    def share(self) -> float:
        """The share of all answers that failed."""
        return sum(map(len, self.failed.values())) / max(1, self.tried.total())

    def beyond(self, share: float) -> set[str]:
        """The names under which more than that share failed."""
        return {
            where for where, those in self.failed.items() if len(those) > share * self.tried[where]
        }

    @property
    def worst_paper(self) -> float:
        """The most points that were lost on one paper, by all ways together."""
        lost: defaultdict[str, float] = defaultdict(float)
        for marks in self.failed.values():
            for mark in marks:
                lost[mark.paper.student] += mark.lost
        return max(lost.values(), default=0)

    def __str__(self) -> str:
        """What failed, most first, each with one of the answers."""
        rows = sorted(self.failed.items(), key=lambda row: -len(row[1]) / self.tried[row[0]])
        return "\n".join(
            f"{where}: {len(marks)} of {self.tried[where]}, as {marks[0]}" for where, marks in rows
        )


def honest(exam: Exam, figures: int = EXACT) -> Count:
    """Honest students, every paper by every method: who rounds every operation, and what is typed,
    to so many figures has full marks.
    """
    found = Count()
    for turn in range(max(len(_methods(question)) for question in exam.papers[0].questions)):
        chosen = _dealt(exam, turn, _methods)

        def typed(paper: Paper, question: Question, chosen: Dealt[Named] = chosen) -> Answers:
            _, method = chosen[paper.student, question.number]
            return method(question.givens, Pad(figures))

        for mark in exam.mark(typed, figures):
            name, _ = chosen[mark.paper.student, mark.question.number]
            found.add(f"{mark.question.template} {mark.ask} by {name}", mark.lost == 0, mark)
    return found


def mistaken(exam: Exam, turns: int) -> Count:
    """Who makes one mistake, and types one of the answers that it changes, gets nothing for it and
    is told its name.
    """
    found = Count()
    for turn in range(turns):
        chosen = _dealt(exam, turn, _mistakes)

        def typed(paper: Paper, question: Question, chosen: Dealt[Wrong] = chosen) -> Answers:
            if (paper.student, question.number) not in chosen:
                return {}
            _, ask, value = chosen[paper.student, question.number]
            return {ask: value}

        # whole columns may be wrong: that is complained of
        for mark in exam.mark(typed, complaints=True):
            name, _, _ = chosen[mark.paper.student, mark.question.number]
            kept = mark.points == 0 and name in mark.names
            found.add(f"{mark.question.template} {name}", kept, mark)
    return found


def following(exam: Exam, turns: int) -> Count:
    """Who goes on rightly from a wrong value of one ask to another one is charged for one of them:
    which of the two led to the other does not stand on the paper.

    Not where what follows vanishes beside the right answer, nor where it happens to be the same
    number as the wrong one: the program says that nothing follows there. A wrong sign is followed
    all the same.
    """
    found = Count()
    for turn in range(turns):
        chosen = _dealt(exam, turn, _edges)

        def typed(paper: Paper, question: Question, chosen: Dealt[Own] = chosen) -> Answers:
            if (paper.student, question.number) not in chosen:
                return {}
            edge, factor = chosen[paper.student, question.number]
            own = factor * question.right[edge.earlier]
            return {edge.earlier: own, edge.later: edge.formula(question.givens, own)}

        # who is wrong in the same ask may be all who typed it: that is complained of
        marks = exam.mark(typed, complaints=True)
        full = {
            (mark.paper.student, mark.question.number, mark.ask) for mark in marks if not mark.lost
        }
        for mark in marks:
            student, number = mark.paper.student, mark.question.number
            edge, factor = chosen[student, number]
            own = factor * mark.question.right[edge.earlier]
            repeated = factor != OPPOSITE and math.isclose(abs(float(mark.typed)), abs(own))
            if mark.ask == edge.later and not repeated and not _vanishes(mark):
                where = f"{mark.question.template} {edge}"
                kept = not mark.lost or (student, number, edge.earlier) in full
                found.add(where, kept, mark)
    return found


def _vanishes(mark: Mark) -> bool:
    return abs(float(mark.typed)) < VANISHING * abs(mark.question.right[mark.ask])


def _dealt(exam: Exam, turn: int, choices: Callable[[Question], Sequence[Choice]]) -> Dealt[Choice]:
    """What each student does with each question, of what there is to choose from."""
    dealt = {}
    for paper in exam.papers:
        for question in paper.questions:
            open_ones = choices(question)
            if open_ones:
                place = (paper.place + STRIDE * turn) % len(open_ones)
                dealt[paper.student, question.number] = open_ones[place]
    return dealt


def _methods(question: Question) -> list[Named]:
    return list(TAUGHT[question.template].methods.items())


def _mistakes(question: Question) -> list[Wrong]:
    """The answers that a mistake changes by more than a machine's rounding; who is stuck has none."""
    return [
        (name, ask, 0.0 if abs(value) < ZERO else value)
        for name, mistake in TAUGHT[question.template].mistakes.items()
        for ask, value in (attempt(mistake, question.givens) or {}).items()
        if ask in question.right and _differ(value, question.right[ask])
    ]


def _edges(question: Question) -> list[Own]:
    """What may be followed among the asks of the paper."""
    return [
        (edge, factor)
        for edge in TAUGHT[question.template].follows
        for factor in edge.factors
        if {edge.earlier, edge.later} <= set(question.right)
    ]


def _differ(value: float, right: float) -> bool:
    return abs(value - right) > NEAR * max(abs(value), abs(right)) + ZERO
