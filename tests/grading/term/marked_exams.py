"""Totals of exams, and the command that puts a term together."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from pathlib import Path

from click.testing import Result

from kinegrade.grade_scale.scale import Scale, Step
from kinegrade.marks_folder.rows import ClassTotals, StudentTotal
from kinegrade.reports.term.plan import Plan
from kinegrade.reports.term.results import TermResult, work_out_results
from tests.small_class import kinegrade

SCALE = Scale((Step("pass", Fraction(1, 2), passes=True), Step("fail", Fraction(0), passes=False)))
WRONG = ("9", "9", "9")


def total(student: str, points: str | None, out_of: int = 10) -> StudentTotal:
    """A student's total; None for one who was absent."""
    status = "absent" if points is None else "marked"
    got = Fraction(points or 0)
    return StudentTotal(2, student, f"N{student}", {}, got, Fraction(out_of), None, status, None)


def exams(**points: Mapping[str, str | None]) -> Mapping[str, ClassTotals]:
    """Exams of 10 points by name, each with the points by student."""
    return {
        name: ClassTotals((), tuple(total(student, got) for student, got in each.items()))
        for name, each in points.items()
    }


def results(
    sat: Mapping[str, ClassTotals], plan: Plan, scale: Scale = SCALE
) -> Mapping[str, TermResult]:
    return {each.student: each for each in work_out_results(sat, plan, scale)}


PLAN = """[parts.homework]
marks = ["HW1", "HW2"]
best = 1
weight = "40 %"

[parts.FINAL]
weight = "60 %"

[scale]
kind = "german"
absent = "n.e."
"""


def run(folder: Path, output: Path, *options: str | Path, plan: str | None = None) -> Result:
    """`kinegrade term` for the three exams."""
    wishes = list(options)
    if plan is not None:
        file = output.parent / "plan.toml"
        file.write_text(plan, encoding="utf-8")
        wishes += ["--plan", file]
    marks = [folder / name / "MARKS" for name in ("HW1", "HW2", "FINAL")]
    return kinegrade("term", *marks, "-o", output, *wishes)
