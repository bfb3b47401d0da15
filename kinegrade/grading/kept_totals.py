"""Nobody loses by a new marking: the total that was announced stands where the new one would be
lower.

Totals are compared, not single answers: who loses two points in one question and gains three in
another has gained. A total counts by its share of what there was to get, so that leaving out a void
question takes nothing from anybody.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from math import ceil
from typing import TypeVar

from kinegrade.grading.amounts import PLACES, amount_text
from kinegrade.grading.marks import ClassGrades, Grade
from kinegrade.grading.marks_folder import Total
from kinegrade.tables import Complaint

Grades = TypeVar("Grades", bound=ClassGrades)


@dataclass(frozen=True, slots=True)
class Kept:
    """A student whose earlier total stands; `grade` is the one by the new marking alone."""

    grade: Grade
    before: Total
    stands: Fraction

    @property
    def reason(self) -> str:
        """Why the total is not the sum of the questions."""
        earlier = f"{amount_text(self.before.points)} of {amount_text(self.before.out_of)}"
        now = f"{amount_text(self.grade.total)} of {amount_text(self.grade.out_of)}"
        return f"nobody is lowered: {earlier} before, {now} by this marking"


def never_lower(marks: Grades, before: Mapping[str, Total]) -> tuple[Grades, tuple[Kept, ...]]:
    """The marks in which nobody's share of the points is below the earlier one, and whose total
    that changes.

    Works on `Marks`, or on `ClassGrades` alone.
    """
    kept = {each.grade.student: each for each in _kept(marks, before)}
    grades = tuple(
        replace(grade, kept=kept[grade.student].stands) if grade.student in kept else grade
        for grade in marks.grades
    )
    known = {grade.student for grade in marks.grades}
    strangers = [_stranger(student) for student in before if student not in known]
    return replace(marks, grades=grades, complaints=(*strangers, *marks.complaints)), tuple(
        kept.values()
    )


def _kept(marks: ClassGrades, before: Mapping[str, Total]) -> Iterator[Kept]:
    """Compared as both are written, or the rounding of a third of a point would look like a
    loss.
    """
    for grade in marks.grades:
        earlier = before.get(grade.student)
        if earlier is None or not grade.out_of:
            continue
        if Fraction(amount_text(grade.total)) < earlier.share * grade.out_of:
            yield Kept(grade, earlier, _rounded_up(earlier.share * grade.out_of))


def _rounded_up(amount: Fraction) -> Fraction:
    """To as many places as are written, so that the share does not fall either."""
    return Fraction(ceil(amount * 10**PLACES), 10**PLACES)


def _stranger(student: str) -> Complaint:
    problem = f'student "{student}" has marks before, and is not in the exam'
    return Complaint("grades.csv", None, "student", "", problem, "nothing to be kept")
