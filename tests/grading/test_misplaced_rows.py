"""Rows in another order, without their decimal marks, or of another student are told with where
they are right; honest mistakes are not taken for them.
"""

from __future__ import annotations

from random import Random

import numpy as np
import pytest

from kinegrade.grading.fast.another_paper import group_places
from kinegrade.grading.misplaced import rows
from kinegrade.grading.misplaced.rows import MisplacedRows
from tests.grading.sitting_class import WRONG
from tests.grading.typed_class import INTERVALS, KEY, SITTING, STUDENTS, TITLES, answer
from tests.said import said

ASKS = range(len(TITLES))
QUESTIONS = group_places(SITTING.exam.asks)


def find(numbers: np.ndarray) -> list[tuple[int | None, str]]:
    """The lines that are told, and the reasons."""
    students = SITTING.exam.students
    found = MisplacedRows(
        INTERVALS, np.arange(len(students)), students, answer(numbers), ASKS, QUESTIONS
    )
    return [(each.line, said(each.problem)) for each in found.list_complaints()]


def test_a_row_in_the_order_of_another_paper_is_told() -> None:
    numbers = KEY.copy()
    numbers[7] = np.roll(KEY[7], 3)
    width = len(TITLES)
    problem = (
        f"{width} of its {width} wrong answers are right in another column of the same paper - "
        "perhaps the row was typed in another order"
    )
    assert find(numbers) == [(9, problem)]


def test_a_row_that_slipped_by_a_cell_is_told() -> None:
    numbers = KEY.copy()
    numbers[3, 2:] = np.r_[np.nan, KEY[3, 2:-1]]
    ((line, problem),) = find(numbers)
    assert line == 5
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


def test_two_rows_exchanged_by_students_who_erred_are_told() -> None:
    numbers = KEY.copy()
    numbers[[11, 12]] = numbers[[12, 11]]
    numbers[11:13, [2, 6]] *= 1.37
    right, others = len(TITLES) - 2, (SITTING.exam.students[12], SITTING.exam.students[11])
    assert find(numbers) == [
        (
            line,
            f'{right} of the {len(TITLES)} numbers are right on the paper of "{other}", and 0 on '
            "the own one - perhaps rows or papers were mixed up",
        )
        for line, other in zip((13, 14), others, strict=True)
    ]


def test_a_student_with_another_version_is_told_though_many_have_it() -> None:
    version = np.arange(STUDENTS) % 3
    key, intervals = KEY[version], [each.at(version) for each in INTERVALS]
    numbers = key.copy()
    numbers[7] = KEY[2]
    numbers[7, [0, 4]] *= 1.37
    students = SITTING.exam.students
    found = MisplacedRows(
        intervals, np.arange(3), students, answer(numbers, intervals), ASKS, QUESTIONS
    )
    (told,) = found.list_complaints()
    right = len(TITLES) - 2
    assert told.line == 9
    assert said(told.problem).startswith(f"{right} of the {len(TITLES)} numbers are right on the")


def test_a_student_with_another_version_who_erred_in_most_is_told_if_two_questions_fit() -> None:
    version = np.arange(STUDENTS) % 3
    key, intervals = KEY[version], [each.at(version) for each in INTERVALS]
    numbers, erred = key.copy(), [ask for ask in ASKS if ask % 2]
    numbers[7] = KEY[2]
    numbers[7, erred] *= 1.37
    students = SITTING.exam.students
    found = MisplacedRows(
        intervals, np.arange(3), students, answer(numbers, intervals), ASKS, QUESTIONS
    )
    (told,) = found.list_complaints()
    right = len(TITLES) - len(erred)
    assert said(told.problem).startswith(f"{right} of the {len(TITLES)} numbers are right on the")
    numbers[7] = KEY[2] * 1.37
    numbers[7, list(QUESTIONS[0])] = KEY[2, list(QUESTIONS[0])]
    found = MisplacedRows(
        intervals, np.arange(3), students, answer(numbers, intervals), ASKS, QUESTIONS
    )
    assert not list(found.list_complaints())


def test_a_row_that_lost_its_decimal_marks_is_told() -> None:
    numbers = KEY.copy()
    marked = [f"{value:.4g}" for value in KEY[5]]
    numbers[5] = [float(text.replace(".", "")) for text in marked]
    lost = sum("." in text for text in marked)
    assert find(numbers) == [
        (
            7,
            f"{lost} of its {lost} wrong answers are right with a decimal mark in them - perhaps "
            "it was lost",
        )
    ]


def test_two_wrong_answers_without_a_decimal_mark_tell_nothing() -> None:
    numbers = KEY.copy()
    numbers[5, :2] = np.rint(1000 * KEY[5, :2])
    assert find(numbers) == []


def test_rows_of_a_large_class_are_held_against_papers_though_few_differ(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(rows, "_TOGETHER", 10)
    version = np.arange(STUDENTS) % 12
    key, intervals = KEY[version], [each.at(version) for each in INTERVALS]
    numbers = key.copy()
    numbers[37] = KEY[9]
    numbers[37, [0, 4]] *= 1.37
    students = SITTING.exam.students
    found = MisplacedRows(
        intervals, np.arange(12), students, answer(numbers, intervals), ASKS, QUESTIONS
    )
    (told,) = found.list_complaints()
    assert told.line == 39
    assert f'on the paper of "{students[9]}"' in said(told.problem)
