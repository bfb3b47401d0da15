"""Answers to another sheet of a series, handed in for this one: right on the paper that the student
has of an exam which stands beside this one. No mark is changed.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple

import numpy as np

from kinegrade.errors import KinegradeError
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.files.tables import Complaint
from kinegrade.grading.class_answers import ClassAnswers
from kinegrade.grading.exams_beside import list_exams_around
from kinegrade.grading.fast.bounds import Numbers
from kinegrade.grading.fast.intervals import Intervals, list_intervals
from kinegrade.language.message import Message

_LEAST_WRONG = 2  # one may be right elsewhere by chance


class _OtherSheet(NamedTuple):
    path: Path
    students: Sequence[str]
    intervals: Sequence[Intervals]

    def has_all(self, student: str, numbers: Numbers) -> bool:
        """Whether each of these numbers is right somewhere on a student's paper."""
        if student not in self.students:
            return False
        own = np.array([self.students.index(student)])
        fits = [each.at(own).fit(numbers)[:, 0] for each in self.intervals]
        return bool(np.any(fits, axis=0).all())


def find_other_sheets(exam: ExamFolder, answers: ClassAnswers) -> Iterator[Complaint]:
    """A complaint for each student of whom most numbers are wrong, and all are right on the paper
    of another exam.
    """
    given, wrong = answers.given, answers.wrong.sum(axis=1)
    mostly = 2 * wrong > given.sum(axis=1)
    missed = np.flatnonzero(mostly & (wrong >= _LEAST_WRONG)).tolist()
    others = list(_list_others(exam)) if missed else []
    students = exam.students
    for row in missed if others else ():
        student, numbers = students[row], answers.numbers[row][given[row]]
        found = (each.path for each in others if each.has_all(student, numbers))
        if (where := next(found, None)) is not None:
            problem = Message(
                "marking.right-on-other-sheet", count=int(wrong[row]), exam=str(where)
            )
            yield answers.complain(row, problem, Message("marking.check-which-sheet"))


def _list_others(exam: ExamFolder) -> Iterator[_OtherSheet]:
    """The other exams beside this one; what is damaged there is passed over."""
    for other in list_exams_around(exam.path):
        if other.path.resolve() != exam.path.resolve():
            where = exam.path.with_name(other.path.name)
            with suppress(KinegradeError):
                yield _OtherSheet(where, other.students, list_intervals(other))
