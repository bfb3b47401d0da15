"""The results of a term: each student's exams put together by a plan, and the grade of the sum.

An exam that a student did not sit counts as nothing, and is told apart from one without a point.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from kinegrade.grade_scale.scale import Scale
from kinegrade.marks_folder.rows import ClassTotals, StudentTotal
from kinegrade.numbers.amounts import bound_rounding
from kinegrade.reports.term.plan import Part, Plan

Exams = Mapping[str, ClassTotals]  # the totals of each exam, by its name


@dataclass(frozen=True, slots=True)
class TermResult:
    """A student's term: `sat` are the totals of exams where the student was there, `listed` those
    of all in which the student has a row. `parts` are shares by part, `total` is their weighted
    sum; `grade` is "" where there is no scale.
    """

    student: str
    name: str
    listed: Mapping[str, StudentTotal]
    sat: Mapping[str, StudentTotal]
    parts: Mapping[str, Fraction]
    total: Fraction
    grade: str


def work_out_results(exams: Exams, plan: Plan, scale: Scale | None) -> tuple[TermResult, ...]:
    """The results of all students of any exam, in the order in which they first occur."""
    return tuple(
        _work_out(student, listed, plan, scale) for student, listed in _gather(exams).items()
    )


def _gather(exams: Exams) -> Mapping[str, Mapping[str, StudentTotal]]:
    """The totals of each student, by exam."""
    found: dict[str, dict[str, StudentTotal]] = {}
    for name, totals in exams.items():
        for each in totals.students:
            found.setdefault(each.student, {})[name] = each
    return found


def _work_out(
    student: str, listed: Mapping[str, StudentTotal], plan: Plan, scale: Scale | None
) -> TermResult:
    sat = {name: total for name, total in listed.items() if total.is_present}
    counted = {part.name: tuple(_choose_best(part, sat)) for part in plan.parts}
    parts = {
        part.name: sum((each.share for each in counted[part.name]), Fraction(0)) / part.best
        for part in plan.parts
    }
    total = sum((part.weight * parts[part.name] for part in plan.parts), Fraction(0))
    hidden = sum((_find_hidden(part, counted[part.name]) for part in plan.parts), Fraction(0))
    name = next((each.name for each in listed.values() if each.name), "")
    grade = "" if scale is None else _find_grade(scale, total + hidden, is_absent=not sat)
    return TermResult(student, name, listed, sat, parts, total, grade)


def _choose_best(part: Part, sat: Mapping[str, StudentTotal]) -> Iterator[StudentTotal]:
    """The best totals of a part, by share; fewer than count where the student sat fewer."""
    there = [sat[name] for name in part.marks if name in sat]
    yield from sorted(there, key=lambda total: -total.share)[: part.best]


def _find_hidden(part: Part, counted: Sequence[StudentTotal]) -> Fraction:
    """How much the rounding of the written totals may have taken from the sum: whoever reached a
    bound exactly, with thirds of points, has reached it.
    """
    rounded = (bound_rounding(0) / each.out_of for each in counted if each.out_of)
    return part.weight * sum(rounded, Fraction(0)) / part.best


def _find_grade(scale: Scale, share: Fraction, *, is_absent: bool) -> str:
    return scale.absent if is_absent else scale.find_step(share).grade


def rank_results(results: Sequence[TermResult]) -> Mapping[str, int]:
    """The rank of each student who sat anything; equal totals share one, the next is counted on."""
    there = sorted((each for each in results if each.sat), key=lambda each: -each.total)
    ranks: dict[str, int] = {}
    for place, each in enumerate(there, 1):
        before = there[place - 2] if place > 1 else None
        same = before is not None and before.total == each.total
        ranks[each.student] = ranks[before.student] if before is not None and same else place
    return ranks
