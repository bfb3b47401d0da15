"""The answers of a class of forty, as somebody typed them, beside its papers."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from kinegrade.grading.fast.another_paper import PapersAnswered
from kinegrade.grading.fast.intervals import Intervals
from kinegrade.grading.misplaced.class_answers import ClassAnswers
from tests.grading.sitting_class import sitting_class

STUDENTS = 40
SITTING = sitting_class(STUDENTS, 5)
TITLES = [ask.column for ask in SITTING.exam.asks]
KEY = np.array(
    [[float(SITTING.key(place, title)) for title in TITLES] for place in range(STUDENTS)]
)
INTERVALS = PapersAnswered(SITTING.exam).intervals


def answer(numbers: np.ndarray, intervals: Sequence[Intervals] = INTERVALS) -> ClassAnswers:
    """What the class answered, on consecutive lines of a file."""
    places = np.arange(STUDENTS)
    fits = [each.fit_beside(numbers[:, ask], places) for ask, each in enumerate(intervals)]
    files, lines = ["answers.csv"] * STUDENTS, list(range(2, STUDENTS + 2))
    none = np.zeros(numbers.shape, dtype=bool)
    return ClassAnswers(numbers, np.column_stack(fits), none, none, files, lines)
