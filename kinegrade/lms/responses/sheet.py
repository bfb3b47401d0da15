"""The exam's answer sheet, filled in as CSV or in a spreadsheet: all its columns are passed on
unchanged. The workbook's line by which rows are found is left out as the file is read.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from kinegrade.errors import TableError
from kinegrade.exam.folder.contents import FINDER
from kinegrade.exam.folder.records import ExamHead
from kinegrade.exam.roster.known_columns import (
    list_code_columns,
    list_column_names,
    list_key_columns,
)
from kinegrade.files.cell_text import make_header_key
from kinegrade.files.spreadsheet import read_workbook
from kinegrade.files.tables import Table, choose_cells, read_table
from kinegrade.files.workbook_inspection import is_workbook
from kinegrade.language.message import Fault, Message
from kinegrade.language.spellings import list_spellings
from kinegrade.lms.responses.people import Kind
from kinegrade.lms.responses.typed_rows import Attempts, TypedRow, TypedRows

SUBMITTED = "submitted"  # the column that says when a row was handed in
TITLE = Message("responses.sheet")


def recognises(header: Sequence[str]) -> bool:
    """Whether there is a column that identifies the student."""
    return bool(_places(header, list_key_columns()) or _places(header, list_column_names("email")))


def read(table: Table, head: ExamHead, attempts: Attempts) -> TypedRows:
    """All columns but that of the ids. Raises TableError where no column identifies the student."""
    if not recognises(table.header):
        raise TableError(Fault(table.file, Message("responses.no-student-column")))
    student = _places(table.header, list_key_columns())
    email = _places(table.header, list_column_names("email"))
    codes = [each for each in _places(table.header, list_code_columns()) if each not in student[:1]]
    named: dict[Kind, Sequence[int]] = {"id": student[:1], "email": email[:1], "code": codes}
    end = _places(table.header, [SUBMITTED])
    others = [place for place in range(len(table.header)) if place not in {*student[:1], *end}]
    choose = choose_cells(others)
    rows = tuple(
        [
            TypedRow(row, choose(row.cells), submitted="".join(map(row.cell, end)))
            for row in table.rows
        ]
    )
    return TypedRows(
        tuple(table.header[place] for place in others), frozenset(others), rows, (), named
    )


def _places(header: Sequence[str], names: Sequence[str]) -> list[int]:
    """The columns of these names, the best name first."""
    keys = [make_header_key(name) for name in header]
    return [keys.index(name) for name in names if name in keys]


def read_answer_file(path: Path, encoding: str | None = None) -> Table:
    """The table of a file, whose header is its first line, or the one below the finder. Raises
    TableError.
    """
    table = _read(path, encoding, finds=False)
    return _read(path, encoding, finds=True) if _is_finder(table.header) else table


def _read(path: Path, encoding: str | None, *, finds: bool) -> Table:
    sign = _is_header if finds else None
    return read_workbook(path, sign) if is_workbook(path) else read_table(path, encoding, sign)


def _is_header(cells: Sequence[str]) -> bool:
    return not _is_finder(cells)


def _is_finder(cells: Sequence[str]) -> bool:
    """Whether a line is that above the header; whatever separates its cells."""
    first = make_header_key(cells[0]) if cells else ""
    return first.startswith(tuple(map(make_header_key, list_spellings(FINDER))))
