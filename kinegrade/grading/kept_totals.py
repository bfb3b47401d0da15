"""A new marking lowers no total: an announced total stands where the new one would be lower.

Totals are compared, not single answers: a student who loses two points on one question and gains
three on another has gained. A total counts by its share of the maximum, so that leaving out a void
question costs no student anything.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Set
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Literal, TypeVar

import msgspec

from kinegrade.files.tables import Complaint
from kinegrade.grading.marks import ClassGrades
from kinegrade.language.message import Message, Part, Quoted, list_plainly
from kinegrade.marks_folder.grade_list import GradeList
from kinegrade.marks_folder.layout import GRADES
from kinegrade.marks_folder.rows import Grade, KeptTotal, StudentTotal
from kinegrade.numbers.amounts import round_up_amount, write_amount

_Grades = TypeVar("_Grades", bound=ClassGrades)


@dataclass(frozen=True)
class EarlierTotals:
    """Announced totals by student; those who `moved` got theirs for papers that are others' now."""

    by_student: Mapping[str, StudentTotal]
    moved: Set[str] = frozenset()

    @property
    def standing(self) -> Mapping[str, StudentTotal]:
        """The totals that may stand: those of students who have the papers that they had."""
        return {each: had for each, had in self.by_student.items() if each not in self.moved}

    def list_complaints(self, known: Set[str]) -> Iterator[Complaint]:
        """What is said of totals that cannot stand, `known` being the students of the exam."""
        others = [each for each in self.by_student if each in self.moved]
        if others:
            yield _complain("earlier-on-other-paper", students=list_plainly(map(Quoted, others)))
        for student in self.by_student:
            if student not in known:
                yield _complain("earlier-marks", student=Quoted(student))


def never_lower(marks: _Grades, before: EarlierTotals) -> tuple[_Grades, tuple[KeptTotal, ...]]:
    """The marks in which no student's share of the points is below the earlier one, and the totals
    this changes.

    Works on `Marks`, or on `ClassGrades` alone.
    """
    kept = {each.student: each for each in _find_kept(marks, before.standing)}
    grades = [
        msgspec.structs.replace(grade, kept=kept[grade.student].stands)
        if grade.student in kept
        else grade
        for grade in marks.grades
    ]
    complaints = *before.list_complaints({*marks.grades.students}), *marks.complaints
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


def _complain(kind: Literal["earlier-marks", "earlier-on-other-paper"], **names: Part) -> Complaint:
    problem, done = Message(f"marking.{kind}", **names), Message("marking.nothing-kept")
    return Complaint(GRADES.name, None, "student", "", problem, done)
