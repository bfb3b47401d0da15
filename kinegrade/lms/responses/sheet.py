"""The exam's answer sheet, filled in as CSV or in a spreadsheet: all its columns are passed on
unchanged. The workbook's line by which rows are found is left out as the file is read.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from kinegrade.errors import TableError
from kinegrade.exam.folder.contents import FINDER
from kinegrade.exam.folder.records import ExamHead
from kinegrade.exam.roster.known_columns import (
    list_code_columns,
    list_column_names,
    list_key_columns,
)
from kinegrade.files.answer_file import AnswerFile
from kinegrade.files.cell_text import make_header_key, trim
from kinegrade.files.header_line import HeaderSign
from kinegrade.files.rows.cell_grid import CellGrid
from kinegrade.files.rows.row import Row, choose_cells
from kinegrade.files.tables import Complaint, Table, read_table
from kinegrade.files.workbooks.inspection import is_workbook
from kinegrade.files.workbooks.spreadsheet import read_workbook
from kinegrade.language.message import Fault, Message
from kinegrade.language.spellings import list_spellings
from kinegrade.lms.responses.people import Kind
from kinegrade.lms.responses.typed_rows import Attempts, TypedRow, TypedRows, whole

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


def pass_on(table: Table, students: Collection[str]) -> AnswerFile | None:
    """A sheet that needs no more than to be passed on, in which every row begins with the id of a
    student as the exam has it, and nothing else tells who or when; None for any other.
    """
    grid, header = table.rows, table.header
    if not isinstance(grid, CellGrid) or grid.width != len(header):
        return None
    beside = [*list_column_names("email"), SUBMITTED]
    if _places(header, list_key_columns())[:1] != [0] or _places(header, beside):
        return None
    if not {*grid.column(0)} <= {*students}:
        return None
    complaints = tuple(each for each in table.complaints if each.column in ("", *header))
    return AnswerFile(replace(table, header=("student", *header[1:]), complaints=complaints))


def part_times(table: Table) -> AnswerFile:
    """A sheet as it is, but for the column of times, which answers nothing."""
    end = _places(table.header, [SUBMITTED])
    if not end:
        return AnswerFile(table)
    others = [place for place in range(len(table.header)) if place not in end]
    choose = choose_cells(others)
    rows = tuple(Row(row.line, choose(row.cells)) for row in table.rows)
    without = replace(table, header=choose(tuple(table.header)), rows=rows)
    return AnswerFile(without, submitted={row.line: trim(row.cell(end[0])) for row in table.rows})


def _places(header: Sequence[str], names: Sequence[str]) -> list[int]:
    """The columns of these names, the best name first."""
    keys = [make_header_key(name) for name in header]
    return [keys.index(name) for name in names if name in keys]


def read_answer_file(
    path: Path, encoding: str | None = None, is_header: HeaderSign = recognises
) -> Table:
    """The table of a file, whose header is its first line, the one below the finder, or the first
    one that `is_header` takes for it, below titles. Raises TableError.

    Rows above such a header are complaints with their whole content, as they may be students'.
    """
    table = _read(path, encoding, None, is_header)
    if _is_finder(table.header):
        return _read(path, encoding, lambda cells: not _is_finder(cells), is_header)
    if is_header(table.header):
        return table
    below = _read(path, encoding, is_header, is_header)
    if not is_header(below.header):
        return table
    return replace(below, complaints=(*below.complaints, *_list_above(table, below)))


def _read(path: Path, encoding: str | None, sign: HeaderSign | None, is_ours: HeaderSign) -> Table:
    if is_workbook(path):
        return read_workbook(path, sign, is_ours)
    return read_table(path, encoding, sign)


def _list_above(table: Table, below: Table) -> Iterator[Complaint]:
    """The rows above a header with more than a title in them, as they are in the whole table."""
    first, *_ = below.above
    for row in (Row(first, table.header), *table.rows):
        # A comma in a title may have been taken for what separates cells
        text = table.separator.join(row.cells)
        cells = text.split(below.separator) if below.separator else row.cells
        if row.line in below.above and sum(bool(trim(cell)) for cell in cells) > 1:
            what, done = Message("responses.above-header"), Message("marking.not-graded")
            yield Complaint(table.file, row.line, "", whole(row), what, done)


def _is_finder(cells: Sequence[str]) -> bool:
    """Whether a line is that above the header; whatever separates its cells."""
    first = make_header_key(cells[0]) if cells else ""
    return first.startswith(tuple(map(make_header_key, list_spellings(FINDER))))
