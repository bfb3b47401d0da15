"""How many students got each grade, who passed, and, where it is asked for, the ranks."""

from __future__ import annotations

from collections import Counter

from kinegrade.grade_scale.scale import Scale, Step
from kinegrade.language.catalogue import Catalogue
from kinegrade.language.message import Message
from kinegrade.marks_folder.rows import ClassTotals, StudentTotal
from kinegrade.numbers.amounts import write_amount
from kinegrade.press.class_charts import Bar
from kinegrade.press.class_sheet import GradeLine, RankLine
from kinegrade.reports.classes.figures import write_percent, write_share

_MANY = 20  # of more grades only those are listed that somebody has
_FULL = 100
_PASSED, _FAILED = "shade0", "shade4"  # of the style sheet


def count_grades(
    totals: ClassTotals, scale: Scale, catalogue: Catalogue
) -> tuple[str, tuple[GradeLine, ...]]:
    """Which share passed, and the distribution of the grades, the best first."""
    present = [each for each in totals.students if each.is_present]
    counts = Counter(each.grade for each in present)
    steps = [step for step in scale.steps if len(scale.steps) <= _MANY or counts[step.grade]]
    passed = sum(counts[step.grade] for step in scale.steps if step.passes)
    said = Message(
        "report.passed",
        count=passed,
        present=len(present),
        share=write_share(passed / len(present) if present else None, catalogue),
        absent=len(totals.students) - len(present),
    )
    most = max(counts.values(), default=1)
    lines = tuple(
        _make_line(step, counts[step.grade], most, len(present), catalogue) for step in steps
    )
    return catalogue.write(said), lines


def _make_line(step: Step, count: int, most: int, present: int, catalogue: Catalogue) -> GradeLine:
    share = write_share(count / present if present else None, catalogue)
    least = write_percent(float(_FULL * step.least), catalogue)
    bar = Bar(count / most, _PASSED if step.passes else _FAILED, f"{step.grade}: {count}")
    return GradeLine(step.grade, least, count, share, bar)


def rank_students(totals: ClassTotals, catalogue: Catalogue) -> tuple[RankLine, ...]:
    """The students who are not absent, the best first; equal shares of the points have one rank,
    and the next one is counted on.
    """
    present = [each for each in totals.students if each.is_present]
    ordered = sorted(present, key=lambda each: -each.share)
    better = Counter(each.share for each in ordered)
    ranks: dict[object, int] = {}
    before = 0
    for share, count in better.items():
        ranks[share] = before + 1
        before += count
    return tuple(_make_rank(ranks[each.share], each, catalogue) for each in ordered)


def _make_rank(rank: int, total: StudentTotal, catalogue: Catalogue) -> RankLine:
    points = write_amount(total.total).replace(".", catalogue.decimal_mark)
    return RankLine(rank, total.student, total.name, points, total.grade)
