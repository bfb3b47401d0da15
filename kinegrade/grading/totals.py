"""A student's total, worked out in one place and in this order: the points of the machine and of
the hand, without what being late and trying again costs, never below an earlier total that stands;
and of the total the grade.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial

import msgspec

from kinegrade.grade_scale.scale import Scale
from kinegrade.grading.kept_totals import EarlierTotals, never_lower
from kinegrade.grading.lateness.rule import NO_PENALTIES, Penalties
from kinegrade.grading.marks import ClassGrades
from kinegrade.marks_folder.rows import Grade, KeptTotal, Submission, Subtracted


@dataclass(frozen=True, slots=True)
class TotalTerms:
    """What totals depend on beside the marks: `penalties` are subtracted; `earlier` totals stand
    where they are higher, None where a total may fall; `scale` gives the grades, None where there
    are none.
    """

    penalties: Penalties = NO_PENALTIES
    earlier: EarlierTotals | None = None
    scale: Scale | None = None


@dataclass(frozen=True, slots=True)
class Totals:
    """The marks with their totals and grades as they stand, the earlier totals that do, and what
    was subtracted.
    """

    marks: ClassGrades
    kept: tuple[KeptTotal, ...]
    subtracted: tuple[Subtracted, ...]


def work_out_totals(marks: ClassGrades, terms: TotalTerms) -> Totals:
    """The totals of a class from its marks."""
    grades = marks.grades.changed(partial(_subtract, penalties=terms.penalties))
    subtracted = tuple(
        _describe(each, terms.penalties, each.submission)
        for each in (grades if terms.penalties.are_any else ())
        if each.subtracted and each.submission is not None
    )
    marks = replace(marks, grades=grades)
    kept: tuple[KeptTotal, ...] = ()
    if terms.earlier is not None:
        marks, kept = never_lower(marks, terms.earlier)
    if terms.scale is not None:
        marks = replace(marks, grades=marks.grades.changed(partial(_give_grade, scale=terms.scale)))
    return Totals(marks, kept, subtracted)


def _subtract(total: Grade, penalties: Penalties) -> Grade:
    """A total without what its submission costs, to as many places as are written."""
    if total.submission is None:
        return total
    points = penalties.subtract(total.submission, total.total, total.out_of)
    return msgspec.structs.replace(total, subtracted=points) if points else total


def _describe(total: Grade, penalties: Penalties, submission: Submission) -> Subtracted:
    """What was subtracted, and the shares that it is."""
    late, tries = penalties.find_shares(submission)
    return Subtracted(total.student, total.name, submission, total.subtracted, late, tries)


def _give_grade(total: Grade, scale: Scale) -> Grade:
    return msgspec.structs.replace(total, grade=find_grade(total, scale))


def find_grade(total: Grade, scale: Scale) -> str:
    """The grade of a total; the word for absent students where nothing was answered."""
    if total.absent and total.kept is None:
        return scale.absent
    return scale.find_step(total.share).grade
