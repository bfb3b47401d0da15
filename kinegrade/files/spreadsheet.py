"""Tables from spreadsheet programs: a sheet of an .xlsx workbook, read as if it were a CSV file.

`read_workbook` is called for answers that people send. Numbers come out as they were typed, texts
unchanged; what a spreadsheet may have changed (an answer turned into a date, the last digits of a
long number) becomes a complaint. A hostile file is refused before it takes memory or time.
"""

from __future__ import annotations

import re
import warnings
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import date, datetime, time, timedelta
from decimal import Decimal
from itertools import islice
from pathlib import Path
from typing import Any

from kinegrade.errors import TableError
from kinegrade.files.cell_text import shorten, trim
from kinegrade.files.header_line import MOST_ABOVE, HeaderSign, find_header
from kinegrade.files.merged_cells import note_merged
from kinegrade.files.rows.row import Row
from kinegrade.files.tables import Complaint, Table
from kinegrade.files.workbook_inspection import (
    SAVE_AS_XLSX,
    explain_damaged,
    inspect_workbook,
)
from kinegrade.language.message import Fault, Message, Quoted, list_plainly

_MOST_ROWS = 100_000
_MOST_CELLS = 2_000_000  # with the blank ones between filled ones
_LONGEST_TEXT = 32_767  # characters in a cell: no spreadsheet program keeps more
_MOST_CHARACTERS = 30_000_000  # in all cells: one long text may be named by many
_LONGEST_NUMBER = 10**15  # spreadsheets keep fifteen digits
_ZEROS = re.compile(r"0{2,}")  # the number format of ids that keep their leading zeros
_PERCENT = "%"
_TEXT_FORMULA = re.compile(r'=\s*"([^"]*)"')  # keeps the zeros of an id


@dataclass(frozen=True, slots=True)
class _Cell:
    """A cell as text; `remark` is what a person should know about it."""

    text: str
    remark: Message | None = None


_BLANK = _Cell("")
# The number of a line in the sheet, and its cells up to the last filled one
_Line = tuple[int, list[_Cell]]


class _Room:
    """How much may still be read of a workbook, all sheets together."""

    def __init__(self) -> None:
        self.rows = _MOST_ROWS
        self.cells = _MOST_CELLS
        self.characters = _MOST_CHARACTERS


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
    if has_formulas:
        lines = _note_formulas(path, name, lines)
    skipped = 0 if is_header is None else find_header(_list_texts(lines), is_header)
    (_, header), *rows = lines[skipped:]
    titles = tuple(cell.text for cell in header)
    complaints = [
        *_note_sheets(path.name, name, heads),
        *_find_oddities(path.name, titles, lines[skipped:]),
        *_find_surplus(path.name, rows, len(titles)),
        *note_merged(path, name, titles, _list_filled(rows)),
    ]
    filled = tuple(Row(line, _pad(cells, len(titles))) for line, cells in rows)
    above = tuple(line for line, _ in lines[:skipped])
    return Table(path.name, titles, filled, "XLSX", "", tuple(complaints), above)


def _list_filled(rows: Sequence[_Line]) -> dict[tuple[int, int], str]:
    """The texts of cells by row and column, counted from 1."""
    return {
        (line, place): cell.text
        for line, cells in rows
        for place, cell in enumerate(cells, 1)
        if trim(cell.text)
    }


def _pad(cells: Sequence[_Cell], width: int) -> tuple[str, ...]:
    return (*(cell.text for cell in cells), *[""] * (width - len(cells)))


@contextmanager
def _workbook(path: Path, *, values: bool) -> Iterator[Any]:
    """An open workbook; every error of its parser becomes one TableError."""
    from openpyxl import load_workbook

    workbook = None
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of styles and extensions, which are not read
            workbook = load_workbook(path, read_only=True, data_only=values, keep_links=False)
            yield workbook
    except TableError:
        raise
    except Exception as fault:  # the parser may raise any exception for a damaged file
        raise explain_damaged(path, fault) from fault
    finally:
        if workbook is not None:
            workbook.close()


def _read_sheet(
    path: Path, is_ours: HeaderSign | None
) -> tuple[str, list[_Line], Mapping[str, list[_Line]]]:
    """The name and the filled lines of the sheet that is read, and the first lines of all filled
    ones.
    """
    with _workbook(path, values=True) as workbook:
        visible = [each for each in workbook.worksheets if each.sheet_state == "visible"]
        room = _Room()
        starts = {
            sheet.title: list(islice(_read_filled_lines(path, sheet, room), MOST_ABOVE))
            for sheet in visible
        }
        heads = {title: lines for title, lines in starts.items() if lines}
        if not heads:
            return "", [], heads
        name = _choose_sheet(heads, is_ours)
        return name, list(_read_filled_lines(path, workbook[name], _Room())), heads


def _choose_sheet(heads: Mapping[str, list[_Line]], is_ours: HeaderSign | None) -> str:
    """The only one with a header of ours, as notes may stand before it; else the first."""
    first, *_ = heads
    if is_ours is None:
        return first
    ours = [title for title, lines in heads.items() if any(map(is_ours, _list_texts(lines)))]
    return ours[0] if len(ours) == 1 else first


def _list_texts(lines: Sequence[_Line]) -> list[list[str]]:
    """The texts of the lines among which a header is looked for."""
    return [[cell.text for cell in cells] for _, cells in lines[:MOST_ABOVE]]


def _read_filled_lines(path: Path, sheet: Any, room: _Room) -> Iterator[_Line]:
    for line, row in _read_rows(path, sheet, room):
        cells = [_BLANK if cell.value is None else _read(cell) for cell in row]
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


def _read_rows(path: Path, sheet: Any, room: _Room) -> Iterator[tuple[int, Sequence[Any]]]:
    """The rows of a sheet, whatever size it declares. Raises TableError for too many of them."""
    sheet.reset_dimensions()
    for line, row in enumerate(sheet.iter_rows(), 1):
        room.rows -= 1
        room.cells -= len(row)
        if room.rows < 0 or room.cells < 0:
            what = Message(
                "files.sheet-too-large", sheet=sheet.title, rows=_MOST_ROWS, cells=_MOST_CELLS
            )
            do = Message("files.delete-around")
            raise TableError(Fault(path.name, what, Message("files.a-class"), do))
        yield line, row


def _read(cell: Any) -> _Cell:
    value = cell.value
    if isinstance(value, bool):
        return _Cell(str(value).upper())
    if isinstance(value, int | float):
        return _write_number(value, cell.number_format)
    if (
        isinstance(value, datetime)
        and value.time() == time()
        and "h" not in cell.number_format.lower()
    ):
        value = value.date()  # a day alone, of which no hour is known
    if isinstance(value, datetime | date | time | timedelta):
        return _Cell(str(value), Message("files.cell-date"))
    return _Cell(str(value))


def _write_number(value: int | float, number_format: str) -> _Cell:
    """The shortest digits of the number: what was typed, except for trailing zeros; as per cent
    where it is shown so, which is another number.
    """
    if number_format.endswith(_PERCENT):
        return _Cell(f"{(100 * Decimal(repr(value))).normalize():f}{_PERCENT}")
    whole = (
        int(value)
        if isinstance(value, int) or (value.is_integer() and abs(value) < _LONGEST_NUMBER)
        else None
    )
    text = repr(value) if whole is None else str(whole)
    if whole is not None and whole >= 0 and _ZEROS.fullmatch(number_format):
        text = text.zfill(len(number_format))
    eaten = abs(value) >= _LONGEST_NUMBER
    return _Cell(text, Message("files.cell-digits") if eaten else None)


def _note_formulas(path: Path, name: str, lines: list[_Line]) -> list[_Line]:
    """The lines, with a remark for each cell that a formula computes."""
    with _workbook(path, values=False) as workbook:
        computed = {
            (line, place): str(getattr(cell.value, "text", cell.value))
            for line, row in _read_rows(path, workbook[name], _Room())
            for place, cell in enumerate(row)
            if cell.data_type == "f"
        }
    widths = dict[int, int]()
    for line, place in computed:  # behind the last filled cell, too
        widths[line] = max(widths.get(line, 0), place + 1)
    return [
        (
            line,
            [
                _note_formula(cell, computed.get((line, place)))
                for place, cell in enumerate(_widen(cells, widths.get(line, 0)))
            ],
        )
        for line, cells in lines
    ]


def _widen(cells: list[_Cell], width: int) -> list[_Cell]:
    return cells + [_BLANK] * (width - len(cells))


def _note_formula(cell: _Cell, formula: str | None) -> _Cell:
    if formula is None:
        return cell
    text = _TEXT_FORMULA.fullmatch(formula)
    if text and cell.text in ("", text[1]):
        return _Cell(text[1])
    shown = shorten(formula)
    if cell.text:
        return _Cell(cell.text, Message("files.cell-formula", formula=shown))
    return _Cell(cell.text, Message("files.cell-never-computed", formula=shown))


def _find_oddities(file: str, titles: Sequence[str], lines: Sequence[_Line]) -> Iterator[Complaint]:
    for line, cells in lines:
        for place, cell in enumerate(cells):
            if cell.remark:
                column = titles[place] if place < len(titles) else ""
                stands = Message("files.taken-as-it-stands")
                done = stands if cell.text else Message("files.read-as-blank")
                yield Complaint(file, line, column, shorten(cell.text), cell.remark, done)


def _find_surplus(file: str, rows: Sequence[_Line], width: int) -> Iterator[Complaint]:
    for line, cells in rows:
        surplus = "; ".join(cell.text for cell in cells[width:] if trim(cell.text))
        if surplus:
            problem, done = Message("files.beside-table"), Message("files.surplus-kept")
            yield Complaint(file, line, "", shorten(surplus), problem, done)


def _note_sheets(file: str, name: str, filled: Iterable[str]) -> Iterator[Complaint]:
    first, *rest = filled
    others = [each for each in (first, *rest) if each != name]
    if not others:
        return
    read, left = Quoted(name), list_plainly(map(Quoted, others))
    if name == first:
        done = Message("files.first-sheet", sheet=read, others=left)
    else:
        done = Message("files.known-sheet", sheet=read, others=left)
    yield Complaint(file, None, "", ", ".join(others), Message("files.several-sheets"), done)
