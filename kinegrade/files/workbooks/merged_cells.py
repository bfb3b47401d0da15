"""Cells of a sheet that are merged: only the first of them holds what all of them show."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from zipfile import ZipFile

from kinegrade.files.cell_text import shorten
from kinegrade.files.tables import Complaint
from kinegrade.files.workbooks.parts import holds, read_workbook_parts
from kinegrade.files.workbooks.sheet_xml import Merged, Position, write_position
from kinegrade.language.message import Message

_MERGED = b"mergeCell"


def note_merged(
    path: Path, sheet: str, titles: Sequence[str], filled: Mapping[Position, str]
) -> list[Complaint]:
    """A complaint for each group of merged cells below the titles that may stand for several cells;
    `filled` are the texts there. Raises TableError for a damaged workbook.
    """
    return [
        _complain(path.name, titles, each, filled[each.first])
        for each in _find_merged(path, sheet)
        if each.first in filled and _hides_something(each, titles)
    ]


def _hides_something(merged: Merged, titles: Sequence[str]) -> bool:
    """Whether other cells of a row, or of a column with a title, show what the first one holds. An
    id that reaches over a column of nothing does no harm.
    """
    (top, left), (bottom, right) = merged.first, merged.last
    if left > len(titles):
        return False
    return bottom > top or any(titles[left:right])


def _find_merged(path: Path, sheet: str) -> Sequence[Merged]:
    with ZipFile(path) as archive:
        if not holds(archive, _MERGED):
            return ()
    book = read_workbook_parts(path)
    return [merged for each in book.sheets if each.name == sheet for merged in each.xml.merged]


def _complain(file: str, titles: Sequence[str], merged: Merged, text: str) -> Complaint:
    (row, column), (last, _) = merged.first, merged.last
    cells = f"{write_position(merged.first)}:{write_position(merged.last)}"
    what = Message("files.cells-merged", cells=cells)
    done = Message("files.first-of-merged", cell=write_position(merged.first))
    line = row + 1 if last > row else row
    return Complaint(file, line, titles[column - 1], shorten(text), what, done)
