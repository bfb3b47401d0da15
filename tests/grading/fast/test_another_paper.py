"""Who answered several questions as is right on one other paper is found, and nobody else."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from kinegrade.exam.folder.keys import NOT_ASKED
from kinegrade.exam.folder.papers import Paper
from kinegrade.exam.keyed_exam import KeyedExam
from kinegrade.grading.fast.another_paper import PapersAnswered
from tests.grading.sitting_class import SittingClass, honest_slips, sitting_class

RIGHT = Fraction(1, 100)  # of an answer: the tolerance of these papers
ROUNDED = Fraction(1003, 1000)


def found(sitting: SittingClass, place: int, given: Mapping[str, Fraction]) -> list[str]:
    """The questions that are found of a student who answers so, and else rightly."""
    papers, asks = PapersAnswered(sitting.exam), sitting.exam.asks
    own = {ask.column: sitting.key(place, ask.column) for ask in asks}
    typed = own | given
    numbers = np.array([float(typed[ask.column]) for ask in asks])
    wrong = [
        abs(typed[ask.column] - own[ask.column]) > RIGHT * abs(own[ask.column]) for ask in asks
    ]
    shared = papers.find_shared(list(sitting.exam.papers())[place], numbers, np.array(wrong))
    return [asks[question.start].question for question in shared]


def answers_of(
    sitting: SittingClass, other: int, questions: Collection[str]
) -> dict[str, Fraction]:
    """What is right on a paper in these questions, rounded a little otherwise."""
    return {
        ask.column: ROUNDED * sitting.key(other, ask.column)
        for ask in sitting.exam.asks
        if ask.question in questions
    }


@pytest.mark.parametrize("students", [30, 300])
def test_the_answers_of_another_paper_are_found(students: int) -> None:
    sitting = sitting_class(students, 1)
    questions = ["q1", "q3", "q4"]
    for place in (0, 7, students - 2):
        assert found(sitting, place, answers_of(sitting, place + 1, questions)) == questions


def test_one_question_tells_nothing() -> None:
    sitting = sitting_class(30, 1)
    assert found(sitting, 0, answers_of(sitting, 1, ["q1"])) == []


def test_questions_of_different_papers_tell_nothing() -> None:
    sitting = sitting_class(30, 1)
    given = {
        **answers_of(sitting, 1, ["q1"]),
        **answers_of(sitting, 2, ["q3"]),
        **answers_of(sitting, 3, ["q4"]),
    }
    assert found(sitting, 0, given) == []


def test_a_question_with_an_answer_of_ones_own_is_none_of_another_paper() -> None:
    sitting = sitting_class(100, 1)
    given = answers_of(sitting, 1, ["q1", "q2", "q3", "q4"])
    for own in (Fraction(77), sitting.key(0, "q4.a")):
        assert found(sitting, 0, {**given, "q4.a": own}) == ["q1", "q2", "q3"]


@pytest.mark.sampled(2, by="students")
@pytest.mark.parametrize(("students", "classes"), [(30, 12), (300, 1)])
def test_who_errs_or_misreads_numbers_is_never_found(students: int, classes: int) -> None:
    for seed in range(classes):
        sitting = sitting_class(students, seed)
        wrong = honest_slips(sitting, seed)
        assert [place for place in range(students) if found(sitting, place, wrong(place))] == []


def test_the_papers_of_a_pool_are_others_too() -> None:
    class WithPool(KeyedExam):
        def variants(self) -> tuple[Paper, ...]:
            return tuple(whole.exam.papers())[30:]

    whole = sitting_class(60, 1)
    few = SittingClass(WithPool(whole.exam.asks, whole.exam.examinees[:30]), whole.drawn[:30])
    given = answers_of(whole, 40, ["q1", "q3", "q4"])
    assert found(few, 0, given) == ["q1", "q3", "q4"]
    assert (
        found(SittingClass(KeyedExam(few.exam.asks, few.exam.examinees), few.drawn), 0, given) == []
    )


@pytest.mark.parametrize("students", [30, 300])
def test_rows_of_others_are_found_among_the_suspect_as_one_by_one(students: int) -> None:
    sitting = sitting_class(students, 1)
    papers, every = PapersAnswered(sitting.exam), list(sitting.exam.papers())
    columns = [ask.column for ask in sitting.exam.asks]
    keys = np.array(
        [[float(sitting.key(place, column)) for column in columns] for place in range(students)]
    )
    chance = np.random.default_rng(7)
    typed = keys * chance.choice([1.0, 1.003, 1.4], size=keys.shape, p=[0.6, 0.2, 0.2])
    slipped = slice(students // 2, None)
    typed[slipped] = np.roll(keys, 1, axis=0)[slipped]
    typed[chance.random(keys.shape) < 0.1] = np.nan
    with np.errstate(invalid="ignore"):
        wrong = np.abs(typed - keys) > 0.01 * np.abs(keys)
    owners = [
        papers.find_owner(paper, numbers, amiss)
        for paper, numbers, amiss in zip(every, typed, wrong, strict=True)
    ]
    suspect = papers.list_suspect(typed, wrong)
    assert {row for row, owner in enumerate(owners) if owner} <= {*suspect}
    assert sum(map(bool, owners)) > students // 4
    assert len(suspect) < students


def test_rows_of_others_are_found_where_papers_hold_different_alternatives() -> None:
    """Even papers hold the second question, odd ones the third; rows slip by two lines."""
    whole, held = sitting_class(40, 1), ("q2", "q3")
    examinees = tuple(
        replace(
            each,
            keys={
                column: NOT_ASKED if column.startswith(held[place % 2]) else key
                for column, key in each.keys.items()
            },
        )
        for place, each in enumerate(whole.exam.examinees)
    )
    exam = KeyedExam(whole.exam.asks, examinees)
    papers, every = PapersAnswered(exam), list(exam.papers())
    keys = np.array([paper.keys.list_values() for paper in every])
    typed = keys.copy()
    typed[20:] = np.roll(keys, 2, axis=0)[20:]
    typed[20:, :3] = np.nan  # the first question is left out
    wrong = np.abs(typed - keys) > 0.01 * np.abs(keys)
    owners = [
        papers.find_owner(paper, numbers, amiss)
        for paper, numbers, amiss in zip(every, typed, wrong, strict=True)
    ]
    assert [row for row, owner in enumerate(owners) if owner] == [*range(20, 40)]
    assert {*range(20, 40)} <= {*papers.list_suspect(typed, wrong)}
