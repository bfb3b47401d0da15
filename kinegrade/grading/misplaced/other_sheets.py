"""Answers to another sheet of a series, handed in for this one: right on the paper that the student
has of an exam which stands beside this one. No mark is changed.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

import numpy as np

from kinegrade.errors import KinegradeError
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.files.tables import Complaint
from kinegrade.grading.exams_beside import list_exams_around
from kinegrade.grading.fast.bounds import Numbers
from kinegrade.grading.fast.intervals import Intervals, list_intervals
from kinegrade.grading.misplaced.class_answers import ClassAnswers
from kinegrade.grading.same_key import identify_exam
from kinegrade.language.message import Message

_LEAST_WRONG = 2  # one may be right elsewhere by chance


def find_other_sheets(exam: ExamFolder, answers: ClassAnswers) -> Iterator[Complaint]:
    """A complaint for each student of whom most numbers are wrong, and all are right on the paper
    of another exam.
    """
    given, wrong = answers.given, answers.wrong.sum(axis=1)
    mostly = 2 * wrong > given.sum(axis=1)
    missed: list[int] = np.flatnonzero(mostly & (wrong >= _LEAST_WRONG)).tolist()
    students = exam.students if missed else ()
    numbers = {row: (students[row], answers.numbers[row][given[row]]) for row in missed}
    where = _find_sheets(exam, numbers)
    for row in missed:
        if row in where:
            problem = Message(
                "marking.right-on-other-sheet", count=int(wrong[row]), exam=str(where[row])
            )
            yield answers.complain(row, problem, Message("marking.check-which-sheet"))


def _find_sheets(
    exam: ExamFolder, answers: Mapping[int, tuple[str, Numbers]]
) -> Mapping[int, Path]:
    """The first exam on whose paper all is right, for each row of a student and numbers that has
    one; a copy of the same exam is none. No exam is opened when nobody is left, and no key is read
    of one that has nobody of them.
    """
    found: dict[int, Path] = {}
    around, itself = list_exams_around(exam.path), identify_exam(exam.head)
    others = (each for each in around if not itself or identify_exam(each.head) != itself)
    while len(found) < len(answers) and (other := next(others, None)) is not None:
        left = {row: own for row, own in answers.items() if row not in found}
        found |= dict.fromkeys(_list_right(other, left), exam.path.with_name(other.path.name))
    return found


def _list_right(exam: ExamFolder, answers: Mapping[int, tuple[str, Numbers]]) -> Sequence[int]:
    """The rows all of whose numbers are right somewhere on their student's paper of an exam; none
    where its key is damaged.
    """
    places = {student: place for place, student in enumerate(exam.students)}
    here = {row: own for row, own in answers.items() if own[0] in places}
    try:
        intervals = list_intervals(exam) if here else ()
    except KinegradeError:
        return ()
    return [
        row
        for row, (student, numbers) in here.items()
        if _has_all(intervals, places[student], numbers)
    ]


def _has_all(intervals: Sequence[Intervals], place: int, numbers: Numbers) -> bool:
    """Whether each of these numbers is right somewhere on the paper at that place, and not all of
    them in the same place there.
    """
    own = np.array([place])
    fits = np.array([each.at(own).fit(numbers)[:, 0] for each in intervals])
    return bool(fits.any(axis=0).all()) and int(fits.any(axis=1).sum()) >= _LEAST_WRONG
