"""Columns exchanged, in another unit or without signs, and rows in another order are told with what
they fit; honest mistakes and hard questions are not taken for them.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from random import Random

import numpy as np
import pytest

from kinegrade.grading.class_answers import ClassAnswers
from kinegrade.grading.fast.another_paper import PapersAnswered
from kinegrade.grading.fast.intervals import Intervals
from kinegrade.grading.misplaced_answers import MisplacedAnswers
from tests.grading.sitting_class import WRONG, sitting_class
from tests.said import said

STUDENTS = 40
SITTING = sitting_class(STUDENTS, 5)
TITLES = [ask.column for ask in SITTING.exam.asks]
KEY = np.array(
    [[float(SITTING.key(place, title)) for title in TITLES] for place in range(STUDENTS)]
)
V, OMEGA, A = (TITLES.index(title) for title in ("q1.v", "q1.omega", "q1.a"))


INTERVALS = PapersAnswered(SITTING.exam).intervals
TURNED = np.arange(STUDENTS) % 3 == 0  # whose right answer is negative where a column has both


def find(
    numbers: np.ndarray, intervals: Sequence[Intervals] = INTERVALS
) -> list[tuple[int | None, str, str]]:
    """The lines, columns and reasons of all that is told of a class."""
    places = np.arange(STUDENTS)
    fits = [each.fit_beside(numbers[:, ask], places) for ask, each in enumerate(intervals)]
    files, lines = ["answers.csv"] * STUDENTS, list(range(2, STUDENTS + 2))
    none = np.zeros(numbers.shape, dtype=bool)
    answers = ClassAnswers(numbers, np.column_stack(fits), none, none, files, lines)
    found = MisplacedAnswers(intervals, TITLES, answers).list_complaints()
    return [(each.line, each.column, said(each.problem)) for each in found]


def turn_some(positive: Intervals) -> Intervals:
    """The same, negative for the students of TURNED."""
    low = np.where(TURNED, -positive.high, positive.low)
    high = np.where(TURNED, -positive.low, positive.high)
    return Intervals(np.where(TURNED, -1, 1) * positive.value, low, high, positive.period)


def exchange(numbers: np.ndarray) -> None:
    numbers[:, [V, OMEGA]] = numbers[:, [OMEGA, V]]


def turn_signs(numbers: np.ndarray) -> None:
    numbers[:, A] *= -1


def type_in_millimetres(numbers: np.ndarray) -> None:
    numbers[:, V] *= 1000


def type_per_minute(numbers: np.ndarray) -> None:
    numbers[:, OMEGA] *= 60 / (2 * np.pi)


@pytest.mark.parametrize(
    ("type_wrongly", "told"),
    [
        (exchange, [("q1.v", "as answers to q1.omega"), ("q1.omega", "as answers to q1.v")]),
        (turn_signs, [("q1.a", "with the other sign")]),
        (type_in_millimetres, [("q1.v", "multiplied by 0.001")]),
        (type_per_minute, [("q1.omega", "multiplied by 0.1047")]),
    ],
)
def test_a_column_typed_wrongly_is_told_with_what_it_fits(
    type_wrongly: Callable[[np.ndarray], None], told: list[tuple[str, str]]
) -> None:
    numbers = KEY.copy()
    type_wrongly(numbers)
    assert find(numbers) == [
        (None, column, f"0 of the 40 numbers are right, and 40 would be {what}")
        for column, what in told
    ]


BOTH_SIGNS = [turn_some(each) if ask == A else each for ask, each in enumerate(INTERVALS)]


def test_minus_signs_lost_in_a_column_of_both_signs_are_told() -> None:
    told = "no number has a minus sign; 14 answers need one, and 14 are right but for it"
    assert find(KEY, BOTH_SIGNS) == [(None, "q1.a", told)]


@pytest.mark.parametrize("factor", [-1.0, 1.37])
def test_nothing_is_told_of_signs_that_are_there_or_explain_nothing(factor: float) -> None:
    numbers = KEY.copy()
    numbers[TURNED, A] *= factor
    assert find(numbers, BOTH_SIGNS) == []


def test_a_column_that_fits_nothing_is_told_as_its_key_may_be_wrong() -> None:
    numbers = KEY.copy()
    numbers[:, A] *= 1.37
    assert find(numbers) == [
        (
            None,
            "q1.a",
            "0 of the 40 numbers are right - perhaps the column holds something else, or its key "
            "is wrong",
        )
    ]


def test_nine_wrong_answers_of_one_column_tell_nothing() -> None:
    numbers = KEY.copy()
    numbers[:, A] = np.nan
    numbers[:9, A] = 1.37 * KEY[:9, A]
    assert find(numbers) == []


def test_a_row_in_the_order_of_another_paper_is_told() -> None:
    numbers = KEY.copy()
    numbers[7] = np.roll(KEY[7], 3)
    width = len(TITLES)
    problem = (
        f"{width} of its {width} wrong answers are right in another column of the same paper - "
        "perhaps the row was typed in another order"
    )
    assert find(numbers) == [(9, "", problem)]


def test_a_row_that_slipped_by_a_cell_is_told() -> None:
    numbers = KEY.copy()
    numbers[3, 2:] = np.r_[np.nan, KEY[3, 2:-1]]
    ((line, column, problem),) = find(numbers)
    assert (line, column) == (5, "")
    assert problem.startswith(f"{len(TITLES) - 3} of its {len(TITLES) - 3} wrong answers")


@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("mistaken", [0.1, 0.3, 0.5])
def test_honest_mistakes_are_not_told(seed: int, mistaken: float) -> None:
    chance, numbers = Random(f"{seed} {mistaken}"), KEY.copy()
    for row in numbers:
        for ask in range(len(TITLES)):
            if chance.random() < mistaken:
                row[ask] *= chance.choice(WRONG) * chance.uniform(0.97, 1.03)
    assert find(numbers) == []
