"""What is predicted for the papers of an exam: by its draws alone, before anyone has answered."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeAlias

from kinegrade.draws.deck import Combination
from kinegrade.exam.setting.kept_exam import KeptExam
from kinegrade.exam.setting.setting import Exam
from kinegrade.numbers.tolerance import LEAST_CARRY
from kinegrade.students.difficulty import Difficulty

Predicted: TypeAlias = dict[str, dict[str, float]]  # by student and question, or answer column
Draws: TypeAlias = Mapping[str, Mapping[str, Combination]]  # the values by question and student


def find_difficulty(exam: Exam, question: str) -> Difficulty:
    """What is predicted for draws of a question of an exam, by its asks with their points."""
    asks = next(each.asks for each in exam.bank.questions if each.identifier == question)
    return Difficulty(exam.filters[question].separation, {ask.name: ask.points for ask in asks})


def predict_kept(kept: KeptExam, draws: Draws) -> Predicted:
    """For each student of an exam folder, by question, the points that one mistake costs on the
    average: worked out from the values that the folder keeps.

    Raises BankError, ExamError.
    """
    predicted: Predicted = {}
    for name, by_student in draws.items():
        found = find_difficulty(kept.unkeyed, name).predict([*by_student.values()])
        for student, points in zip(by_student, found.tolist(), strict=True):
            predicted.setdefault(student, {})[name] = points
    return predicted


def bound_coarse_rounding(kept: KeptExam, draws: Draws) -> Predicted:
    """For each student of an exam folder, by answer column, how far off in the ask's unit an answer
    may be when everything is rounded too coarsely: to three significant figures, or one less than
    the exam asks for. Infinite where that is not known.

    Raises BankError, ExamError.
    """
    coarse = min(LEAST_CARRY, kept.bank.carry - 1)
    bounds: Predicted = {}
    for name, by_student in draws.items():
        drawn = [*by_student.values()]
        for ask, rounding in kept.unkeyed.filters[name].dealt.round_draws(drawn, coarse).items():
            for student, bound in zip(by_student, rounding.bound.tolist(), strict=True):
                bounds.setdefault(student, {})[f"{name}.{ask}"] = bound
    return bounds


def list_draws(kept: KeptExam) -> Draws:
    """The draws of an exam folder, of the questions whose key has all values. Raises BankError,
    ExamError.
    """
    filters = kept.unkeyed.filters
    draws: dict[str, dict[str, Combination]] = {name: {} for name in filters}
    for line in kept.exam.keys.lines():
        for each in line.questions:
            known, values = filters.get(each.question), each.values
            if known is not None and values.keys() == known.template.parameters.keys():
                draws[each.question][line.student] = values
    return {name: found for name, found in draws.items() if found}
