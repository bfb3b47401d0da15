"""A new marking lowers no total: an announced total stands where the new one would be lower.

Totals are compared, not single answers: a student who loses two points on one question and gains
three on another has gained. A total counts by its share of the maximum, so that leaving out a void
question costs no student anything.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import TypeVar

import msgspec

from kinegrade.files.tables import Complaint
from kinegrade.grading.marks import ClassGrades
from kinegrade.language.message import Message, Quoted
from kinegrade.marks_folder.grade_list import GradeList
from kinegrade.marks_folder.layout import GRADES
from kinegrade.marks_folder.rows import Grade, KeptTotal, StudentTotal
from kinegrade.numbers.amounts import round_up_amount, write_amount

_Grades = TypeVar("_Grades", bound=ClassGrades)


def never_lower(
    marks: _Grades, before: Mapping[str, StudentTotal]
) -> tuple[_Grades, tuple[KeptTotal, ...]]:
    """The marks in which no student's share of the points is below the earlier one, and the totals
    this changes.

    Works on `Marks`, or on `ClassGrades` alone.
    """
    kept = {each.student: each for each in _find_kept(marks, before)}
    grades = [
        msgspec.structs.replace(grade, kept=kept[grade.student].stands)
        if grade.student in kept
        else grade
        for grade in marks.grades
    ]
    known = {*marks.grades.students}
    strangers = [_complain_of_stranger(student) for student in before if student not in known]
    complaints = *strangers, *marks.complaints
    together = replace(marks, grades=GradeList.of(grades), complaints=complaints)
    return together, tuple(kept.values())


def _find_kept(marks: ClassGrades, before: Mapping[str, StudentTotal]) -> Iterator[KeptTotal]:
    """Totals are compared as they are written; otherwise rounding a third of a point would look
    like a loss.
    """
    for grade in marks.grades:
        earlier = before.get(grade.student)
        if earlier is None or not grade.out_of:
            continue
        if Fraction(write_amount(grade.total)) < earlier.share * grade.out_of:
            yield _keep_total(grade, earlier)


def _keep_total(grade: Grade, earlier: StudentTotal) -> KeptTotal:
    """With the reason why the total is not the sum of the questions."""
    reason = Message(
        "marking.total-kept",
        before=write_amount(earlier.total),
        before_out_of=write_amount(earlier.out_of),
        now=write_amount(grade.total),
        out_of=write_amount(grade.out_of),
    )
    return KeptTotal(
        grade.student,
        grade.name,
        reason,
        earlier.total,
        earlier.out_of,
        grade.total,
        grade.out_of,
        round_up_amount(earlier.share * grade.out_of),  # so that the share does not fall either
    )


def _complain_of_stranger(student: str) -> Complaint:
    problem = Message("marking.earlier-marks", student=Quoted(student))
    return Complaint(GRADES.name, None, "student", "", problem, Message("marking.nothing-kept"))
