"""Whether everybody who came in is in what went out, or in what was said."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Iterator
from pathlib import Path

from tests.fuzz.doors import Door


def unaccounted(door: Door, folder: Path, said: str) -> list[str]:
    """Students of the damaged file who are in no output and in no complaint; [] where the file is
    not plain CSV.
    """
    out = folder / "OUT"
    match door.command[0]:
        case "grade" if door.file == "answers.csv":
            written = [*out.glob("*.csv")]
        case "generate" if door.file == "roster.csv":
            written = [out / "exam.json"]
        case _:
            return []
    texts = [said, *(_text(file) for file in written)]
    return [student for student in _students(folder / door.file) if not _found(student, texts)]


def _text(file: Path) -> str:
    text = file.read_text(encoding="utf-8")
    if file.suffix == ".json":
        return "\n".join(each["student"] for each in json.loads(text)["students"])
    return text


def _found(student: str, texts: list[str]) -> bool:
    doubled = student.replace('"', '""')
    return any(student in text or doubled in text for text in texts)


def _students(file: Path) -> Iterator[str]:
    """The cells under "student" of a plain table in UTF-8; nothing where it is not as plain as
    that.
    """
    try:
        text = file.read_bytes().decode("utf-8-sig")
        rows = list(csv.reader(io.StringIO(text, newline=""), strict=True))
    except (UnicodeDecodeError, csv.Error):
        return
    rows = [row for row in rows if any(cell.strip() for cell in row)]
    if not rows or "student" not in rows[0] or (not text.isprintable() and "\x00" in text):
        return
    column = rows[0].index("student")
    for row in rows[1:]:
        student = row[column].strip() if column < len(row) else ""
        if student and student.isprintable() and len(student) < 100:
            yield student
