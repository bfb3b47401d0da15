"""A student's total, worked out in one place and in this order: the points of the machine and of
the hand, never below an earlier total that stands; and of the total the grade.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from kinegrade.grade_scale.scale import Scale
from kinegrade.grading.kept_totals import never_lower
from kinegrade.grading.marks import ClassGrades
from kinegrade.marks_folder.rows import Grade, KeptTotal, StudentTotal


@dataclass(frozen=True, slots=True)
class TotalTerms:
    """What totals depend on beside the marks: `earlier` totals stand where they are higher, None
    where a total may fall; `scale` gives the grades, None where there are none.
    """

    earlier: Mapping[str, StudentTotal] | None = None
    scale: Scale | None = None


def work_out_totals(
    marks: ClassGrades, terms: TotalTerms
) -> tuple[ClassGrades, tuple[KeptTotal, ...]]:
    """The marks with their totals and grades as they stand, and the earlier totals that do."""
    kept: tuple[KeptTotal, ...] = ()
    if terms.earlier is not None:
        marks, kept = never_lower(marks, terms.earlier)
    if terms.scale is None:
        return marks, kept
    grades = tuple(replace(each, grade=find_grade(each, terms.scale)) for each in marks.grades)
    return replace(marks, grades=grades), kept


def find_grade(total: Grade, scale: Scale) -> str:
    """The grade of a total; the word for absent students where nothing was answered."""
    if total.absent and total.kept is None:
        return scale.absent
    return scale.find_step(total.share).grade
