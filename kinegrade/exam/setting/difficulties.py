"""What is predicted for the papers of an exam: by its draws alone, before anyone has answered."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TypeAlias

from kinegrade.draws.deck import Combination
from kinegrade.exam.setting.kept_exam import KeptExam
from kinegrade.exam.setting.setting import Exam
from kinegrade.numbers.tolerance import LEAST_CARRY
from kinegrade.students.difficulty import Difficulty

Predicted: TypeAlias = dict[str, dict[str, float]]  # by student and question, or answer column


def find_difficulty(exam: Exam, question: str) -> Difficulty:
    """What is predicted for draws of a question of an exam, by its asks with their points."""
    asks = next(each.asks for each in exam.bank.questions if each.identifier == question)
    return Difficulty(exam.filters[question].separation, {ask.name: ask.points for ask in asks})


def predict_kept(kept: KeptExam) -> Predicted:
    """For each student of an exam folder, by question, the points that one mistake costs on the
    average: worked out from the values that the folder keeps.

    Raises BankError, ExamError.
    """
    predicted: Predicted = {}
    for name, students, draws in _list_draws(kept):
        found = find_difficulty(kept.unkeyed, name).predict(draws)
        for student, points in zip(students, found.tolist(), strict=True):
            predicted.setdefault(student, {})[name] = points
    return predicted


def bound_coarse_rounding(kept: KeptExam) -> Predicted:
    """For each student of an exam folder, by answer column, how far off in the ask's unit an answer
    may be when everything is rounded too coarsely: to three significant figures, or one less than
    the exam asks for. Infinite where that is not known.

    Raises BankError, ExamError.
    """
    coarse = min(LEAST_CARRY, kept.bank.carry - 1)
    bounds: Predicted = {}
    for name, students, draws in _list_draws(kept):
        for ask, row in kept.unkeyed.filters[name].bound(draws, coarse).items():
            for student, bound in zip(students, row.tolist(), strict=True):
                bounds.setdefault(student, {})[f"{name}.{ask}"] = bound
    return bounds


def _list_draws(kept: KeptExam) -> Iterator[tuple[str, list[str], list[Combination]]]:
    """For each question the students whose key has all its values, and these values."""
    lines = list(kept.exam.lines())
    for name, question in kept.unkeyed.filters.items():
        draws = {
            line.student: each.values
            for line in lines
            for each in line.questions
            if each.question == name and each.values.keys() == question.template.parameters.keys()
        }
        if draws:
            yield name, [*draws], [*draws.values()]
