"""A folder of marks as one spreadsheet for people: grades, marks and complaints, each on a sheet.

Every cell that holds an id, a name or a typed answer is a text cell, so nothing runs as a formula
and no digit is lost; points are numbers, and empty for absent students.
"""

from __future__ import annotations

import io
import re
from collections.abc import Iterable
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from openpyxl import Workbook
from openpyxl.cell.cell import Cell
from openpyxl.styles import Font
from openpyxl.utils import get_column_letter
from openpyxl.worksheet.properties import PageSetupProperties
from openpyxl.worksheet.worksheet import Worksheet

from kinegrade.files.csv_writing import restore
from kinegrade.files.rows.row import Row
from kinegrade.files.tables import Table
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.layout import TEXT_COLUMNS, Status

_NUMBER = re.compile(r"[0-9]{1,15}(?:\.[0-9]{1,15})?")
_UNPRINTABLE = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ud800-\udfff\ufffe\uffff]")
_TIME = re.compile(rb">[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9:]{8}Z<")
_LONGEST_CELL, _WIDEST_COLUMN, _WIDEST_NAME = 32_767, 60, 30
_TEXT_FORMAT = "@"


def workbook(marks: MarksFolder) -> bytes:
    """The bytes of an .xlsx file of a folder of marks; raises TableError."""
    return write_tables(marks.tables())


def write_tables(tables: Iterable[tuple[str, Table]]) -> bytes:
    """The bytes of an .xlsx file of tables, each on a sheet of its name."""
    book = Workbook()
    book.remove(book.active)
    for name, table in tables:
        _fill(book.create_sheet(name), table)
    stream = io.BytesIO()
    book.save(stream)
    return _make_repeatable(stream.getvalue())


def _make_repeatable(content: bytes) -> bytes:
    """The same archive without the time of its creation, so that the same marks give the same
    bytes.
    """
    stream = io.BytesIO()
    with ZipFile(io.BytesIO(content)) as made, ZipFile(stream, "w", ZIP_DEFLATED) as archive:
        for name in made.namelist():
            part = made.read(name)
            if name == "docProps/core.xml":
                part = _TIME.sub(b">2000-01-01T00:00:00Z<", part)
            archive.writestr(ZipInfo(name), part, ZIP_DEFLATED)
    return stream.getvalue()


def _fill(sheet: Worksheet, table: Table) -> None:
    for place, title in enumerate(table.header, 1):
        cell = _make_text_cell(sheet, 1, place, title)
        cell.font = Font(bold=True)
        widest = _WIDEST_NAME if title == "name" else _WIDEST_COLUMN
        width = max(
            _measure_width(title),
            *(_measure_width(row.cell(place - 1)) for row in table.rows[:500]),
            6,
        )
        sheet.column_dimensions[get_column_letter(place)].width = min(width + 2, widest)
    for line, row in enumerate(table.rows, 2):
        is_absent = _is_absent(table, row)
        for place, title in enumerate(table.header, 1):
            text = row.cell(place - 1)
            _write(sheet, line, place, title, "" if is_absent and text == "0" else text)
    sheet.freeze_panes = "B2" if table.header[0] == "student" else "A2"
    sheet.auto_filter.ref = sheet.dimensions
    sheet.print_title_rows = "1:1"
    sheet.page_setup.orientation, sheet.page_setup.fitToHeight = "landscape", 0
    sheet.sheet_properties.pageSetUpPr = PageSetupProperties(fitToPage=True)


def _is_absent(table: Table, row: Row) -> bool:
    """Whether a row is that of an absent student, whose zeros an average would count."""
    absent: Status = "absent"
    return "status" in table.header and row.cell(table.header.index("status")) == absent


def _write(sheet: Worksheet, line: int, place: int, title: str, text: str) -> None:
    if not text:
        return
    if title not in TEXT_COLUMNS and _NUMBER.fullmatch(text):
        sheet.cell(line, place, float(text) if "." in text else int(text))
        return
    cell = _make_text_cell(sheet, line, place, text if title == "student" else restore(text))
    cell.number_format = (
        _TEXT_FORMAT  # or a spreadsheet would make a formula of =1+1 when the cell is edited
    )


def _make_text_cell(sheet: Worksheet, line: int, place: int, text: str) -> Cell:
    cell = sheet.cell(line, place, _clean(text))
    cell.data_type = "s"  # the library takes a text that begins with = for a formula
    return cell


def _clean(text: str) -> str:
    """A text that a spreadsheet can hold: control characters become dots, a long text is cut."""
    return _UNPRINTABLE.sub("·", text)[:_LONGEST_CELL]


def _measure_width(text: str) -> int:
    """The width of a text in characters, Chinese ones counted twice."""
    return sum(2 if "\u2e80" <= character <= "\uffef" else 1 for character in text[:_WIDEST_COLUMN])
