"""How unlike papers are for a mixed class of students written by hand, and by chance would be.

Each of the mistakes and misreadings of a question is made independently, two of them on the average.
Who comes upon a figure that cannot be is stuck, and loses all of the question.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from itertools import permutations
from math import sqrt
from statistics import pstdev, pvariance

from tests.by_hand.class_list import TAUGHT
from tests.by_hand.pad import Mistake, Pad, attempt
from tests.by_hand.school import Exam, Question
from tests.by_hand.slips import misread

MADE = 2.0  # mistakes in a question, on the average
ALMOST = 1e-9  # of an answer: what a machine's rounding adds to a tolerance


def deviations(exam: Exam) -> tuple[float, float]:
    """The standard deviation of the papers' mean totals, in points, as they were dealt and were the
    same questions dealt independently.
    """
    lost = [[lose(question) for question in paper.questions] for paper in exam.papers]
    by_chance = sum(pvariance(column) for column in zip(*lost, strict=True))
    return pstdev(map(sum, lost)), sqrt(by_chance)


def lose(question: Question) -> float:
    """The points that the class loses on a question in the mean."""
    mistakes = [*TAUGHT[question.template].mistakes.values(), *list_misreadings(question)]
    made = MADE / len(mistakes)
    spoilt = Counter(ask for mistake in mistakes for ask in _list_wrong(question, mistake))
    return sum(points * (1 - (1 - made) ** spoilt[ask]) for ask, points in question.points.items())


def list_misreadings(question: Question) -> Iterator[Mistake]:
    """An angle taken from the other axis, a rate reversed or forgotten, one given for another of
    its unit, a sense that is not thought of.
    """
    work = next(iter(TAUGHT[question.template].methods.values()))
    for name, unit in question.units.items():
        if unit == "deg":
            yield misread(work, lambda angle: 90 - angle, name)
        elif "/s" in unit:
            yield misread(work, lambda rate: -rate, name)
            yield misread(work, lambda rate: 0.0, name)
    for name, other in permutations(question.units, 2):
        if question.units[name] == question.units[other]:
            value = question.givens[other]
            yield misread(work, lambda _, value=value: value, name)  # type: ignore[misc]
    yield lambda givens: {ask: abs(value) for ask, value in work(givens, Pad.exact()).items()}


def _list_wrong(question: Question, mistake: Mistake) -> Iterator[str]:
    """The asks of which a mistake leaves the tolerance, or all where it leads to no figure."""
    answers = attempt(mistake, question.givens)
    if answers is None:
        yield from question.points
        return
    for ask, value in answers.items():
        if ask in question.right:
            right = question.right[ask]
            if abs(value - right) > question.rooms[ask] + ALMOST * (1 + abs(right)):
                yield ask
