"""The results of a term: each student's exams put together by a plan, and the grade of the sum.

An exam that a student did not sit counts as nothing, and is told apart from one without a point.
One from which a student is excused does not count: a part is the best of the others, and a part of
which nothing is left leaves its weight to the other parts, each in proportion to its own. So does
one of which a student is excused from every exam that lists them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence, Set
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
    of all in which the student has a row, `excused` the names of exams that do not count. `parts`
    are shares by part, None where a part does not count; `total` is their weighted sum; `grade` is
    "" where there is no scale.
    """

    student: str
    name: str
    listed: Mapping[str, StudentTotal]
    sat: Mapping[str, StudentTotal]
    excused: frozenset[str]
    parts: Mapping[str, Fraction | None]
    total: Fraction
    grade: str


@dataclass(frozen=True, slots=True)
class _Counted:
    """What counts of a part: `best` totals, or fewer where the student sat fewer. Its `share` of
    the points is exact but for the rounding of the totals, which took at most `hidden` from it.
    """

    weight: Fraction
    best: int
    totals: tuple[StudentTotal, ...]

    @property
    def share(self) -> Fraction:
        return sum((each.share for each in self.totals), Fraction(0)) / self.best

    @property
    def hidden(self) -> Fraction:
        rounded = (bound_rounding(0) / each.out_of for each in self.totals if each.out_of)
        return sum(rounded, Fraction(0)) / self.best


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
    excused = plan.find_uncounted(student)
    sat = {
        name: total for name, total in listed.items() if total.is_present and name not in excused
    }
    counted = {part.name: _count(part, listed.keys(), sat, excused) for part in plan.parts}
    total, hidden = _add_up([each for each in counted.values() if each is not None])
    name = next((each.name for each in listed.values() if each.name), "")
    grade = "" if scale is None else _find_grade(scale, total + hidden, is_absent=not sat)
    parts = {part: None if each is None else each.share for part, each in counted.items()}
    return TermResult(student, name, listed, sat, excused, parts, total, grade)


def _count(
    part: Part, listed: Set[str], sat: Mapping[str, StudentTotal], excused: frozenset[str]
) -> _Counted | None:
    """What counts of a part, the best totals by share; None where nothing does."""
    names = [name for name in part.marks if name not in excused]
    best = min(part.best, len(names))
    is_excused = len(names) < len(part.marks) and listed.isdisjoint(names)
    if not best or is_excused:
        return None
    there = sorted((sat[name] for name in names if name in sat), key=lambda total: -total.share)
    return _Counted(part.weight, best, tuple(there[:best]))


def _add_up(counted: Sequence[_Counted]) -> tuple[Fraction, Fraction]:
    """The weighted sum of shares, and how much the rounding of the written totals may have taken
    from it: whoever reached a bound exactly, with thirds of points, has reached it.
    """
    weight = sum((each.weight for each in counted), Fraction(0))
    if not weight:
        return Fraction(0), Fraction(0)
    total = sum((each.weight * each.share for each in counted), Fraction(0))
    hidden = sum((each.weight * each.hidden for each in counted), Fraction(0))
    return total / weight, hidden / weight


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
