"""Tables from spreadsheet programs: a sheet of an .xlsx workbook, read as if it were a CSV file.

`read_workbook` is called for answers that people send. Numbers come out as they were typed, texts
unchanged; what a spreadsheet may have changed (an answer turned into a date, the last digits of a
long number) becomes a complaint. A hostile file is refused before it takes memory or time.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import islice
from pathlib import Path
from typing import Any

from kinegrade.errors import TableError
from kinegrade.files.cell_text import trim
from kinegrade.files.header_line import MOST_ABOVE, HeaderSign, find_header
from kinegrade.files.rows.row import Row
from kinegrade.files.tables import Table
from kinegrade.files.workbooks.cells import (
    BLANK,
    Cell,
    Line,
    Room,
    open_workbook,
    read_cell,
    read_rows,
)
from kinegrade.files.workbooks.inspection import SAVE_AS_XLSX, inspect_workbook
from kinegrade.files.workbooks.merged_cells import note_merged
from kinegrade.files.workbooks.oddities import (
    find_oddities,
    find_surplus,
    note_formulas,
    note_sheets,
)
from kinegrade.files.workbooks.raised_digits import note_raised
from kinegrade.language.message import Fault, Message

_LONGEST_TEXT = 32_767  # characters in a cell: no spreadsheet program keeps more


def read_workbook(
    path: Path, is_header: HeaderSign | None = None, is_ours: HeaderSign | None = None
) -> Table:
    """The one visible sheet of a workbook in which `is_ours` finds a header, else the first filled
    one; `Row.line` is the row's number there. The header is its first line, or the first one that
    `is_header` takes for it, below titles.

    Raises TableError if the file is missing, not an .xlsx workbook, empty, too large or hostile.
    """
    has_formulas = inspect_workbook(path)
    name, lines, heads = _read_sheet(path, is_ours)
    if not lines:
        raise TableError(
            Fault(
                path.name,
                Message("files.no-filled-sheet"),
                Message("files.column-names"),
                SAVE_AS_XLSX,
            )
        )
    lines = note_raised(path, name, lines)
    if has_formulas:
        lines = note_formulas(path, name, lines)
    skipped = 0 if is_header is None else find_header(_list_texts(lines), is_header)
    (_, header), *rows = lines[skipped:]
    titles = tuple(cell.text for cell in header)
    complaints = [
        *note_sheets(path.name, name, heads),
        *find_oddities(path.name, titles, lines[skipped:]),
        *find_surplus(path.name, rows, len(titles)),
        *note_merged(path, name, titles, _list_filled(rows)),
    ]
    filled = tuple(Row(line, _pad(cells, len(titles))) for line, cells in rows)
    above = tuple(line for line, _ in lines[:skipped])
    return Table(path.name, titles, filled, "XLSX", "", tuple(complaints), above)


def _list_filled(rows: Sequence[Line]) -> dict[tuple[int, int], str]:
    """The texts of cells by row and column, counted from 1."""
    return {
        (line, place): cell.text
        for line, cells in rows
        for place, cell in enumerate(cells, 1)
        if trim(cell.text)
    }


def _pad(cells: Sequence[Cell], width: int) -> tuple[str, ...]:
    return (*(cell.text for cell in cells), *[""] * (width - len(cells)))


def _read_sheet(
    path: Path, is_ours: HeaderSign | None
) -> tuple[str, list[Line], Mapping[str, list[Line]]]:
    """The name and the filled lines of the sheet that is read, and the first lines of all filled
    ones.
    """
    with open_workbook(path, values=True) as workbook:
        visible = [each for each in workbook.worksheets if each.sheet_state == "visible"]
        room = Room()
        starts = {
            sheet.title: list(islice(_read_filled_lines(path, sheet, room), MOST_ABOVE))
            for sheet in visible
        }
        heads = {title: lines for title, lines in starts.items() if lines}
        if not heads:
            return "", [], heads
        name = _choose_sheet(heads, is_ours)
        return name, list(_read_filled_lines(path, workbook[name], Room())), heads


def _choose_sheet(heads: Mapping[str, list[Line]], is_ours: HeaderSign | None) -> str:
    """The only one with a header of ours, as notes may stand before it; else the first."""
    first, *_ = heads
    if is_ours is None:
        return first
    ours = [title for title, lines in heads.items() if any(map(is_ours, _list_texts(lines)))]
    return ours[0] if len(ours) == 1 else first


def _list_texts(lines: Sequence[Line]) -> list[list[str]]:
    """The texts of the lines among which a header is looked for."""
    return [[cell.text for cell in cells] for _, cells in lines[:MOST_ABOVE]]


def _read_filled_lines(path: Path, sheet: Any, room: Room) -> Iterator[Line]:
    for line, row in read_rows(path, sheet, room):
        cells = [BLANK if cell.value is None else read_cell(cell) for cell in row]
        room.characters -= sum(len(cell.text) for cell in cells)
        longest = max((len(cell.text) for cell in cells), default=0)
        if longest > _LONGEST_TEXT or room.characters < 0:
            where = Message("files.sheet-row", file=path.name, sheet=sheet.title, row=line)
            what = Message("files.too-much-text", count=longest)
            raise TableError(Fault(where, what, Message("files.answers"), SAVE_AS_XLSX))
        while cells and not trim(cells[-1].text) and not cells[-1].remark:
            cells.pop()
        if any(trim(cell.text) for cell in cells):
            yield line, cells
