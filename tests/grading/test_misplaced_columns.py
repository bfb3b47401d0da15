"""Columns exchanged, in another unit or without signs are told with what they fit."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
import pytest

from kinegrade.grading.fast.intervals import Intervals
from kinegrade.grading.misplaced.columns import MisplacedColumns
from tests.grading.typed_class import INTERVALS, KEY, STUDENTS, TITLES, answer
from tests.said import said

V, OMEGA, A = (TITLES.index(title) for title in ("q1.v", "q1.omega", "q1.a"))
TURNED = np.arange(STUDENTS) % 3 == 0  # whose right answer is negative where a column has both


def find(numbers: np.ndarray, intervals: Sequence[Intervals] = INTERVALS) -> list[tuple[str, str]]:
    """The columns that are told, and the reasons."""
    found = MisplacedColumns(intervals, TITLES, answer(numbers, intervals)).list_complaints()
    return [(each.column, said(each.problem)) for each in found]


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
        (column, f"0 of the 40 numbers are right, and 40 would be {what}") for column, what in told
    ]


BOTH_SIGNS = [turn_some(each) if ask == A else each for ask, each in enumerate(INTERVALS)]


def test_minus_signs_lost_in_a_column_of_both_signs_are_told() -> None:
    told = "no number has a minus sign; 14 answers need one, and 14 are right but for it"
    assert find(KEY, BOTH_SIGNS) == [("q1.a", told)]


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
