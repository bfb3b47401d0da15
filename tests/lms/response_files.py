"""An exam of which only the asks and the students matter, and downloads written for it."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from openpyxl import Workbook

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.lms.responses.answer_table import ReadingWishes, Responses, read_responses
from tests.said import said

SAMPLES = Path(__file__).parent / "samples" / "moodle"
ASKS = {"q1": ("v_B", "omega_AB"), "q2": ("a_B",)}
STUDENTS = {"0012345": "Wei@Example.org", "0012346": "zoe@example.org", "S9": "", "=2": ""}


def write_asks(
    folder: Path, asks: Mapping[str, Sequence[str]] = ASKS, students: Mapping[str, str] = STUDENTS
) -> Path:
    """An exam folder with nothing but what is read of exam.json."""
    exam = folder / "EXAM"
    exam.mkdir(exist_ok=True)
    record = {
        "format": 1,
        "language": "en",
        "questions": [
            {"question": name, "asks": [{"ask": ask, "unit": "", "points": 1} for ask in each]}
            for name, each in asks.items()
        ],
        "students": [
            {"student": student, "name": "x", "email": email} for student, email in students.items()
        ],
    }
    (exam / "exam.json").write_text(json.dumps(record), encoding="utf-8")
    (exam / "key.jsonl").touch()
    return exam


def csv_text(*rows: Sequence[str]) -> str:
    """Rows as CSV."""
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue()


def responses(
    folder: Path, content: str | bytes, source: str | None = None, **options: Any
) -> Responses:
    """A download with that content, read for the exam in the folder, which is written where there
    is none.
    """
    exam = folder / "EXAM"
    if not exam.exists():
        write_asks(folder)
    file = folder / "download.csv"
    file.write_bytes(content.encode() if isinstance(content, str) else content)
    return read_responses(file, open_exam(exam), ReadingWishes(source, **options))


def cells(read: Responses) -> list[tuple[str, ...]]:
    """The header and the rows of an answer sheet."""
    return [read.table.header, *(row.cells for row in read.table.rows)]


def told(read: Responses) -> list[tuple[int | None, str, str]]:
    """Line, problem and what was done of each complaint, of those about the exam's students' rows
    last.
    """
    complaints = [*read.table.complaints, *(each.complaint for each in read.answers.left_out)]
    return [(each.line, said(each.problem), said(each.done)) for each in complaints]


def workbook(path: Path, *rows: Sequence[object]) -> Path:
    """A workbook of one sheet; a text that begins with = is a text, unless it begins with two."""
    book = Workbook()
    for line, row in enumerate(rows, 1):
        for column, value in enumerate(row, 1):
            cell = book.active.cell(line, column, str(value)[1:] if is_formula(value) else value)
            if isinstance(value, str) and not is_formula(value):
                cell.data_type = "s"
    book.save(path)
    return path


def is_formula(value: object) -> bool:
    """Whether a workbook is to compute the value."""
    return isinstance(value, str) and value.startswith("==")
