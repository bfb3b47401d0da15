"""The files of a marks folder: marks.csv, grades.csv, complaints.csv and the policy by which it was marked.

Called by `grade`; kept.csv says whose total is not the sum of the questions, where nobody was to be lowered. Typed
text and names are written `neutralised`, so that no cell runs as a formula in a spreadsheet; ids and numbers are
written as they are. A response longer than a thousand characters is cut.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

from kinegrade.grading.amounts import amount_text
from kinegrade.grading.marks import Grade, Mark, Marks
from kinegrade.grading.marks_folder import KEPT
from kinegrade.grading.never_lower import Kept
from kinegrade.grading.policy import Policy
from kinegrade.tables import Complaint, neutralised, shortened, write_csv

_MARKS = (
    "student",
    "question",
    "ask",
    "response",
    "read_as",
    "unit",
    "verdict",
    "points",
    "out_of",
    "reason",
)
POLICY = "policy.toml"
_NO_POLICY = "# No policy: marked as the papers say.\n"
_KEPT = ("student", "name", "before", "before_out_of", "by_this_marking", "out_of", "stands", "reason")
_COMPLAINTS = ("file", "line", "column", "content", "problem", "done")


def write_report(folder: Path, marks: Marks, policy: Policy, kept: Iterable[Kept] | None) -> None:
    """Writes the files into an existing folder; `kept` is None where totals may fall."""
    write_csv(folder / "marks.csv", _MARKS, map(_mark_row, marks.marks))
    grades = ("student", "name", *marks.questions, "total", "out_of", "percent")
    write_csv(folder / "grades.csv", grades, map(_grade_row, marks.grades))
    write_csv(folder / "complaints.csv", _COMPLAINTS, _complaint_rows(marks.complaints))
    (folder / POLICY).write_bytes((policy.text or _NO_POLICY).encode("utf-8"))
    if kept is not None:
        write_csv(folder / KEPT, _KEPT, map(_kept_row, kept))


def _mark_row(mark: Mark) -> tuple[str, ...]:
    return (
        mark.student,
        mark.ask.question,
        mark.ask.ask,
        neutralised(shortened(mark.reading.typed)),
        mark.reading.read_as,
        mark.ask.unit,
        mark.verdict.kind,
        amount_text(mark.points),
        amount_text(mark.ask.points),
        neutralised(mark.verdict.reason),
    )


def _grade_row(grade: Grade) -> tuple[str, ...]:
    points = map(amount_text, (*grade.points, grade.total, grade.out_of))
    return (grade.student, neutralised(grade.name), *points, amount_text(grade.percent, places=2))


def _kept_row(kept: Kept) -> tuple[str, ...]:
    now, before = kept.grade, kept.before
    amounts = (before.points, before.out_of, now.total, now.out_of, kept.stands)
    return (now.student, neutralised(now.name), *map(amount_text, amounts), kept.reason)


def _complaint_rows(complaints: Iterable[Complaint]) -> Iterator[tuple[str, ...]]:
    for each in complaints:
        line = "" if each.line is None else str(each.line)
        texts = map(neutralised, (each.column, each.content, each.problem, each.done))
        yield (neutralised(each.file), line, *texts)
