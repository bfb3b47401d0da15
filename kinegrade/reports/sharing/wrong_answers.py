"""The wrong answers of a class that no known mistake explains, as arrays."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import isfinite

import numpy as np

from kinegrade.errors import ExamError
from kinegrade.exam.folder.sitting import Sitting
from kinegrade.grading.fast.bounds import Numbers
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.marks_folder.cells import explain_edited
from kinegrade.marks_folder.layout import ANSWERS
from kinegrade.marks_folder.rows import MarkedAnswer

_UNEXPLAINED = ("wrong", "another paper")


@dataclass(frozen=True)
class WrongAnswers:
    """Unexplained wrong answers, one array per ask: numbers by the students' positions, NaN for all
    other answers.

    `typed` holds what was typed, by student and ask.
    """

    numbers: Sequence[Numbers]
    typed: dict[tuple[int, int], str]


def find_wrong_answers(exam: Sitting, answers: Iterable[MarkedAnswer]) -> WrongAnswers:
    """The unexplained ones. Raises ExamError where an answer does not belong to the exam."""
    students = {student: place for place, student in enumerate(exam.students)}
    columns = {ask.column: place for place, ask in enumerate(exam.asks)}
    numbers = [np.full(len(students), np.nan) for _ in columns]
    typed: dict[tuple[int, int], str] = {}
    faults: dict[Fault, None] = {}
    for answer in answers:
        student, ask = students.get(answer.student), columns.get(answer.column)
        number = _read_number(answer)
        if student is None or ask is None or number is None:
            faults[_explain(answer, student, ask)] = None
        elif answer.verdict in _UNEXPLAINED and not answer.mistakes and number and isfinite(number):
            numbers[ask][student] = number
            typed[student, ask] = answer.typed
    if faults:
        raise ExamError(*faults)
    return WrongAnswers(numbers, typed)


def _read_number(answer: MarkedAnswer) -> float | None:
    """The number that was read, NaN where there is none; None for anything that is not a number."""
    try:
        return float(answer.read_as or "nan")
    except ValueError:
        return None


def _explain(answer: MarkedAnswer, student: int | None, ask: int | None) -> Fault:
    if student is None:
        return _explain_stranger(Message("marks.unknown-student", name=Quoted(answer.student)))
    if ask is None:
        return _explain_stranger(Message("marks.unknown-ask", name=Quoted(answer.column)))
    place = Message(
        "marks.answer-place",
        file=ANSWERS.name,
        student=Quoted(answer.student),
        column=answer.column,
    )
    return explain_edited(place, Message("marks.not-number", cell=Quoted(answer.read_as[:40])))


def _explain_stranger(problem: Message) -> Fault:
    return Fault(ANSWERS.name, problem, Message("marks.of-this-exam"), Message("marks.name-exam"))
