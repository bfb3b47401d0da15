"""The cells of a sheet as text, read row by row within bounds."""

from __future__ import annotations

import re
import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import date, datetime, time, timedelta
from decimal import Decimal
from functools import lru_cache
from pathlib import Path
from typing import Any

from kinegrade.errors import TableError
from kinegrade.files.workbooks.inspection import explain_damaged
from kinegrade.language.message import Fault, Message

_MOST_ROWS = 100_000
_MOST_CELLS = 2_000_000  # with the blank ones between filled ones
_MOST_CHARACTERS = 30_000_000  # in all cells: one long text may be named by many
_LONGEST_NUMBER = 10**15  # spreadsheets keep fifteen digits
_ZEROS = re.compile(r"0{2,}")  # the number format of ids that keep their leading zeros
_PERCENT = "%"
_LONGEST_FORMAT = 255
# Behind the last digit of a number format, up to that of negative numbers: words in quotes or
# behind backslashes, which the spreadsheet shows and the cell does not hold
_SHOWN_BEHIND = re.compile(r'[0#?]((?:[^0#?;"]|"[^"]*")*?)(?:;|$)')
_WORDS = re.compile(r'"([^"]*)"|\\(.)')


@dataclass(frozen=True, slots=True)
class Cell:
    """A cell as text; `remark` is what a person should know about it."""

    text: str
    remark: Message | None = None


BLANK = Cell("")
# The number of a line in the sheet, and its cells up to the last filled one
Line = tuple[int, list[Cell]]


class Room:
    """How much may still be read of a workbook, all sheets together."""

    def __init__(self) -> None:
        self.rows = _MOST_ROWS
        self.cells = _MOST_CELLS
        self.characters = _MOST_CHARACTERS


@contextmanager
def open_workbook(path: Path, *, values: bool) -> Iterator[Any]:
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


def read_rows(path: Path, sheet: Any, room: Room) -> Iterator[tuple[int, Sequence[Any]]]:
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


def read_cell(cell: Any) -> Cell:
    """What a cell holds, as text."""
    value = cell.value
    if isinstance(value, bool):
        return Cell(str(value).upper())
    if isinstance(value, int | float):
        return _write_number(value, cell.number_format)
    if (
        isinstance(value, datetime)
        and value.time() == time()
        and "h" not in cell.number_format.lower()
    ):
        value = value.date()  # a day alone, of which no hour is known
    if isinstance(value, datetime | date | time | timedelta):
        return Cell(str(value), Message("files.cell-date"))
    return Cell(str(value))


def _write_number(value: int | float, number_format: str) -> Cell:
    """The shortest digits of the number: what was typed, except for trailing zeros; as per cent
    where it is shown so, which is another number, and with the unit that is shown behind it.
    """
    if number_format.endswith(_PERCENT):
        return Cell(f"{(100 * Decimal(repr(value))).normalize():f}{_PERCENT}")
    whole = (
        int(value)
        if isinstance(value, int) or (value.is_integer() and abs(value) < _LONGEST_NUMBER)
        else None
    )
    text = repr(value) if whole is None else str(whole)
    if whole is not None and whole >= 0 and _ZEROS.fullmatch(number_format):
        text = text.zfill(len(number_format))
    eaten = abs(value) >= _LONGEST_NUMBER
    shown = f"{text} {_find_words_behind(number_format)}".rstrip()
    return Cell(shown, Message("files.cell-digits") if eaten else None)


@lru_cache(maxsize=64)
def _find_words_behind(number_format: str) -> str:
    """The words that a number format shows behind the digits, as a unit; "" where it has none, or
    is longer than a spreadsheet program writes any.
    """
    if len(number_format) > _LONGEST_FORMAT:
        return ""
    behind = _SHOWN_BEHIND.search(number_format)
    parts = _WORDS.findall(behind[1]) if behind else []
    words = "".join(quoted or escaped for quoted, escaped in parts).strip()
    return words if any(map(str.isalpha, words)) or "°" in words else ""
