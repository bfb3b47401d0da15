"""The file Moodle's gradebook imports (Grades > Import > CSV file), UTF-8 with commas.

Called by `grade` and by `export`. In Moodle map "ID number" to the profile field of that name, "Grade" to a
grade item whose maximum is the exam's points, and "Feedback" to the feedback of that item. Moodle compares
ids as texts, so they are written exactly; a grade has a decimal point and at most four decimals. Everybody
gets a grade, because an empty one would erase what stands there.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from decimal import Decimal, InvalidOperation
from html import escape
from pathlib import Path

from kinegrade.errors import TableError
from kinegrade.tables import Table, csv_text, read_table

HEADER = ("ID number", "Full name", "Grade", "Feedback")
_NOT_QUESTIONS = {"student", "name", "total", "out_of", "percent"}


def export(marks_folder: Path) -> str:
    """The text of moodle.csv from grades.csv and marks.csv of a folder; raises TableError.

    Feedback is a line such as "q1: 4/7; q2: 3/3". Names stay neutralised against spreadsheets.
    """
    grades = _table(marks_folder / "grades.csv", ("student", "name", "total"))
    marks = _table(marks_folder / "marks.csv", ("student", "question", "out_of"))
    available = _available(marks)
    questions = [name for name in grades.header if name not in _NOT_QUESTIONS]
    rows = []
    for row in grades.rows:
        cells = dict(zip(grades.header, row.cells, strict=False))
        student, out_of = cells["student"], available[cells["student"]]
        parts = [f"{name}: {cells.get(name, '')}/{out_of[name].normalize():f}" for name in questions]
        rows.append(
            (student, cells.get("name", ""), cells.get("total", ""), escape("; ".join(parts), quote=False))
        )
    return csv_text(HEADER, rows)


def _table(path: Path, columns: tuple[str, ...]) -> Table:
    table = read_table(path)
    missing = [name for name in columns if name not in table.header]
    if missing or table.complaints:
        problems = [f"no column {name}" for name in missing] + [
            str(complaint) for complaint in table.complaints
        ]
        raise TableError(
            f"{path}: {'; '.join(problems)} - expected the file as kinegrade grade wrote it - grade again"
        )
    return table


def _available(marks: Table) -> Mapping[str, Mapping[str, Decimal]]:
    """The points each student could get in each question."""
    available: dict[str, dict[str, Decimal]] = defaultdict(lambda: defaultdict(Decimal))
    student, question, out_of = map(marks.header.index, ("student", "question", "out_of"))
    for row in marks.rows:
        try:
            available[row.cell(student)][row.cell(question)] += Decimal(row.cell(out_of))
        except InvalidOperation as fault:
            raise TableError(
                f'{marks.file}:{row.line}: out_of is "{row.cell(out_of)}" - expected a number - grade again'
            ) from fault
    return available
