"""A downloaded CSV file as cells with their positions, so that single cells can be changed and
nothing else.

`read_cells` is called by `fill_in`. What is not changed is written back byte for byte: header,
order, encoding, byte-order mark, separator, quotation marks and line ends.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from kinegrade.errors import TableError
from kinegrade.files.cell_text import trim
from kinegrade.files.decoding import STRANGE_UTF_8
from kinegrade.files.tables import read_table
from kinegrade.language.lines import show_in_one_line
from kinegrade.language.message import Fault, Message

BYTE_ORDER_MARK = "\ufeff"
_NEEDS_QUOTES = re.compile(r'["\r\n]')


@dataclass(frozen=True, slots=True)
class Cell:
    """The content of a cell, and its start and end in the file's text, quotation marks included."""

    text: str
    start: int
    end: int


@dataclass(frozen=True, slots=True)
class Record:
    """The cells of one row; `line` is the physical line, counted from 1, on which it begins."""

    line: int
    cells: tuple[Cell, ...]


@dataclass(frozen=True, slots=True)
class CellTable:
    """A file with a header and rows of the same number of cells; empty lines are not among the
    rows.
    """

    file: str
    text: str
    encoding: str
    separator: str
    header: Record
    rows: tuple[Record, ...]

    @property
    def titles(self) -> tuple[str, ...]:
        """The header's texts without surrounding blanks."""
        return tuple(trim(cell.text) for cell in self.header.cells)

    def with_cells(self, changes: Mapping[Cell, str]) -> bytes:
        """The bytes of the file with new texts in these cells; quotation marks are kept, and added
        where needed.
        """
        parts, place = [], 0
        for cell in sorted(changes, key=lambda cell: cell.start):
            parts += [self.text[place : cell.start], self._written(cell, changes[cell])]
            place = cell.end
        return "".join((*parts, self.text[place:])).encode(self.encoding)

    def _written(self, cell: Cell, text: str) -> str:
        quoted = self.text.startswith('"', cell.start) and cell.end > cell.start
        if quoted or self.separator in text or _NEEDS_QUOTES.search(text):
            return '"' + text.replace('"', '""') + '"'
        return text


def read_cells(path: Path) -> CellTable:
    """Reads a file to change single cells of it; raises TableError for one that could not be
    written back byte for byte.
    """
    table = read_table(path)  # finds encoding and separator, refuses what is no table
    if table.encoding == STRANGE_UTF_8:
        raise TableError(Fault(path.name, Message("grades.unknown-encoding")))
    content = path.read_bytes()
    text = _decode(path.name, content, table.encoding)
    if text.encode(table.encoding) != content:
        form = Message("grades.other-form", encoding=table.encoding)
        raise TableError(Fault(path.name, form))
    header, *rows = _read_records(path.name, text, table.separator)
    faults = list(_find_ragged(path.name, header, rows))
    if faults:
        raise TableError(*faults)
    return CellTable(path.name, text, table.encoding, table.separator, header, tuple(rows))


def _decode(file: str, content: bytes, encoding: str) -> str:
    try:
        return content.decode(encoding)
    except UnicodeDecodeError as fault:
        line = content.count(b"\n", 0, fault.start) + 1
        shown = content[fault.start : fault.start + 8].hex(" ")
        broken = Message("grades.broken-bytes", encoding=encoding, bytes=shown)
        raise TableError(Fault(f"{file}:{line}", broken)) from fault


def _read_records(file: str, text: str, separator: str) -> Iterator[Record]:
    """All lines that are not empty, with their cells."""
    for line, cells in _split_lines(file, text, separator):
        if len(cells) > 1 or cells[0].end > cells[0].start:
            yield Record(line, tuple(cells))


def _split_lines(file: str, text: str, separator: str) -> Iterator[tuple[int, list[Cell]]]:
    sign = re.escape(separator)
    shape = re.compile(
        rf'(?:"(?P<quoted>[^"]*+(?:""[^"]*+)*+)"|(?P<plain>(?!")[^{sign}\r\n]*+))'
        rf"(?P<end>{sign}|\r\n|\r|\n|\Z)"
    )
    place, line = len(BYTE_ORDER_MARK) if text.startswith(BYTE_ORDER_MARK) else 0, 1
    cells: list[Cell] = []
    begins = line
    while place < len(text) or cells:
        found = shape.match(text, place)
        if not found:
            shown = show_in_one_line(text[place : place + 30])
            raise TableError(Fault(f"{file}:{line}", Message("grades.open-quote", text=shown)))
        content = found["plain"] if found["quoted"] is None else found["quoted"].replace('""', '"')
        cells.append(Cell(content, place, found.start("end")))
        line += len(re.findall(r"\r\n|\r|\n", found[0]))
        place = found.end()
        if found["end"] != separator:
            yield begins, cells
            cells, begins = [], line


def _find_ragged(file: str, header: Record, rows: Iterable[Record]) -> Iterator[Fault]:
    width = len(header.cells)
    for row in rows:
        if len(row.cells) != width:
            ragged = Message("grades.ragged", number=len(row.cells), width=width)
            yield Fault(f"{file}:{row.line}", ragged)
