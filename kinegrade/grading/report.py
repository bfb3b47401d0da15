"""The files of a marks folder: marks.csv, grades.csv and complaints.csv.

Called by `grade`. Typed text and names are written `neutralised`, so that no cell runs as a formula in a
spreadsheet; ids and numbers are written as they are. A response longer than a thousand characters is cut.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from functools import lru_cache
from pathlib import Path

from kinegrade.grading.marks import Grade, Mark, Marks
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
_COMPLAINTS = ("file", "line", "column", "content", "problem", "done")


def write_report(folder: Path, marks: Marks) -> None:
    """Writes the three files into an existing folder."""
    write_csv(folder / "marks.csv", _MARKS, map(_mark_row, marks.marks))
    grades = ("student", "name", *marks.questions, "total", "out_of", "percent")
    write_csv(folder / "grades.csv", grades, map(_grade_row, marks.grades))
    write_csv(folder / "complaints.csv", _COMPLAINTS, _complaint_rows(marks.complaints))


@lru_cache(maxsize=4096)
def amount_text(amount: Fraction, places: int = 4) -> str:
    """The shortest decimal with at most that many places, halves rounded up; amounts are not negative.

    >>> amount_text(Fraction(7, 2)), amount_text(Fraction(2, 3))
    ('3.5', '0.6667')
    """
    whole, decimals = divmod((2 * amount * 10**places + 1) // 2, 10**places)
    digits = f"{decimals:0{places}d}".rstrip("0")
    return f"{whole}.{digits}" if digits else str(whole)


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


def _complaint_rows(complaints: Iterable[Complaint]) -> Iterator[tuple[str, ...]]:
    for each in complaints:
        line = "" if each.line is None else str(each.line)
        texts = map(neutralised, (each.column, each.content, each.problem, each.done))
        yield (neutralised(each.file), line, *texts)
