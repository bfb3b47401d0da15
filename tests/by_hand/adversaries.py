"""Sheets that nobody worked for, and what they earn."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Mapping
from dataclasses import dataclass
from random import Random
from statistics import mean

from tests.by_hand.class_list import TAUGHT
from tests.by_hand.pad import Answers
from tests.by_hand.school import Exam, Paper, Question, Typed

NO_FOLLOW_THROUGH = "credit = { follow-through = 0 }"
MEAN = 0.05  # of a paper's points: what a pattern may earn in the mean
MORE = 0.1  # of them: what a sheet may earn more than without follow-through


@dataclass(frozen=True)
class Earned:
    """What a sheet earns, as shares of its paper's points: with follow-through, and without."""

    followed: float
    alone: float


def earn(exam: Exam, sheets: int) -> Mapping[str, list[Earned]]:
    """By pattern what so many sheets earn, or as many as there are papers; they take turns."""
    patterns = list_patterns(exam)
    names = list(patterns)
    papers = exam.papers[: sheets * len(names)]
    chosen = {paper.student: names[paper.place % len(names)] for paper in papers}

    def fill(paper: Paper, question: Question) -> Answers:
        name = chosen.get(paper.student)
        return patterns[name](paper, question) if name else {}

    followed, alone = (_share(exam, fill, policy) for policy in ("", NO_FOLLOW_THROUGH))
    found = defaultdict(list)
    for student, name in chosen.items():
        found[name].append(Earned(followed[student], alone[student]))
    return found


def too_much(found: Mapping[str, list[Earned]]) -> Mapping[str, list[Earned]]:
    """The patterns that earn more than they may."""
    return {
        name: sheets
        for name, sheets in found.items()
        if mean(sheet.followed for sheet in sheets) > MEAN
        or max(sheet.followed - sheet.alone for sheet in sheets) > MORE
    }


def _share(exam: Exam, fill: Typed, policy: str) -> Mapping[str, float]:
    points: Counter[str] = Counter()
    for mark in exam.mark(fill, policy=policy, complaints=True):
        points[mark.paper.student] += mark.points / mark.paper.points
    return points


def _everywhere(number: float) -> Typed:
    return lambda paper, question: dict.fromkeys(question.right, number)


def _scaled(factor: float) -> Typed:
    return lambda paper, question: {ask: factor * value for ask, value in question.right.items()}


def _random(paper: Paper, question: Question) -> Answers:
    """Three figures and a sign, of any size that answers have."""
    chance = Random(f"{paper.student} {question.number}")
    return {
        ask: chance.choice((-1, 1)) * chance.randint(100, 999) * 10.0 ** chance.randint(-4, 0)
        for ask in question.right
    }


def _carried(factor: float) -> Typed:
    """So many times the right value in the first ask from which others are worked out, and in those
    what follows from it by the textbook.
    """

    def fill(paper: Paper, question: Question) -> Answers:
        edges = [
            edge
            for edge in TAUGHT[question.template].follows
            if {edge.earlier, edge.later} <= set(question.right)
        ]
        leading = {edge.earlier for edge in edges}
        first = next((ask for ask in question.right if ask in leading), None)
        if first is None:
            return {}
        own = factor * question.right[first]
        later = {
            edge.later: edge.formula(question.givens, own)
            for edge in edges
            if edge.earlier == first
        }
        return {first: own, **later}

    return fill


def _neighbours(exam: Exam) -> Typed:
    """What is right on the next paper."""

    def fill(paper: Paper, question: Question) -> Answers:
        neighbour = exam.papers[(paper.place + 1) % len(exam.papers)]
        return neighbour.question(question.number).right

    return fill


def list_patterns(exam: Exam) -> Mapping[str, Typed]:
    """All ways to fill a sheet in that exam, by name."""
    return {
        "0": _everywhere(0.0),
        "1": _everywhere(1.0),
        "minus 2": _everywhere(-2.0),
        "huge": _everywhere(1e9),
        "tiny": _everywhere(1e-9),
        "random": _random,
        "a fiftieth": _scaled(0.02),
        "a hundred times": _scaled(100.0),
        "carried on from 500 times": _carried(500.0),
        "the neighbour's paper": _neighbours(exam),
    }
