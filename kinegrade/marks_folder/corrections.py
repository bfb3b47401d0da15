"""corrections.csv read: how often the key was corrected before the class was marked."""

from __future__ import annotations

from pathlib import Path

from kinegrade.errors import TableError
from kinegrade.language.message import Message
from kinegrade.marks_folder.cells import explain_cell, read_records_if_any
from kinegrade.marks_folder.layout import CORRECTIONS


def read_corrections(folder: Path) -> int:
    """The count; 0 where there is no such file. Raises TableError."""
    for line, (count,) in read_records_if_any(folder, CORRECTIONS):
        if not count.isdecimal():
            path, expected = folder / CORRECTIONS.name, Message("marks.whole-number")
            raise TableError(explain_cell(path, line, "corrections", count, expected))
        return int(count)
    return 0
