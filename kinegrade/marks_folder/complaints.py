"""complaints.csv read: what a person should look at."""

from __future__ import annotations

from pathlib import Path

from kinegrade.errors import TableError
from kinegrade.files.csv_writing import restore
from kinegrade.files.tables import Complaint
from kinegrade.language.message import Message
from kinegrade.marks_folder.cells import explain_cell, read_records
from kinegrade.marks_folder.layout import COMPLAINTS


def read_complaints(folder: Path) -> tuple[Complaint, ...]:
    """The lines of the file. Raises TableError."""
    path = folder / COMPLAINTS.name
    found = []
    for line, cells in read_records(folder, COMPLAINTS):
        file, number, column, content, problem, done = map(restore, cells)
        if number and not number.isdecimal():
            expected = Message("marks.line-number")
            raise TableError(explain_cell(path, line, "line", number, expected))
        found.append(
            Complaint(file, int(number) if number else None, column, content, problem, done)
        )
    return tuple(found)
