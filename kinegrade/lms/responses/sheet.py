"""The exam's answer sheet, filled in as CSV or in a spreadsheet: all its columns are passed on
unchanged.
"""

from __future__ import annotations

from collections.abc import Sequence

from kinegrade.errors import TableError
from kinegrade.exam.folder.records import ExamHead
from kinegrade.exam.roster.known_columns import (
    list_code_columns,
    list_column_names,
    list_key_columns,
)
from kinegrade.files.cell_text import make_header_key
from kinegrade.files.tables import Table
from kinegrade.language.message import Fault, Message
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
    rows = tuple(
        TypedRow(row, tuple(map(row.cell, others)), submitted="".join(map(row.cell, end)))
        for row in table.rows
    )
    return TypedRows(
        tuple(table.header[place] for place in others), frozenset(others), rows, (), named
    )


def _places(header: Sequence[str], names: Sequence[str]) -> list[int]:
    """The columns of these names, the best name first."""
    keys = [make_header_key(name) for name in header]
    return [keys.index(name) for name in names if name in keys]
