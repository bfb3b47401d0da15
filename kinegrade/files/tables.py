"""Tables as people send them: CSV in any usual encoding and separator, read without losing a line
or a cell.

`read_table` is called by the roster and by grading; both report `Complaint`s. CSV is written by
`csv_writing`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from kinegrade.errors import TableError
from kinegrade.files.cell_text import shorten, trim
from kinegrade.files.csv_reading import (
    cells_of_any_size,
    count_lines_above,
    count_separator_lines,
    drop_lines,
    find_separator,
    read_records,
)
from kinegrade.files.csv_writing import write_csv_text
from kinegrade.files.decoding import CSV_FILE, Decoded, decode, name_encoding
from kinegrade.files.header_line import HeaderSign
from kinegrade.files.opening.regular import explain_unopened, open_regular
from kinegrade.files.rows.cell_grid import CellGrid, pack_grid, read_grid
from kinegrade.files.rows.row import Row
from kinegrade.language import ENGLISH
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Fault, Message, Text

_MANY = 3  # lines that tell more together than one by one


@dataclass(frozen=True, slots=True)
class Complaint:
    """Something a person should check; `line` is None where no single line is concerned.

    It is written in the language of whatever shows it; one that was read from a file is text.
    """

    file: str
    line: int | None
    column: str
    content: str
    problem: Text
    done: Text

    @property
    def fault(self) -> Fault:
        """The same in one line, without what the cell holds."""
        place = self.file if self.line is None else f"{self.file}:{self.line}"
        where = ": ".join(part for part in (place, self.column) if part)
        return Fault(where, self.problem, do=self.done)

    def __str__(self) -> str:
        return open_catalogue(ENGLISH).write(self.fault)


@dataclass(frozen=True, slots=True)
class Table:
    """A table as it is in the file: cells unchanged, ragged rows kept, rows of only blanks left
    out; `above` are the filled lines above its header.
    """

    file: str
    header: tuple[str, ...]
    rows: Sequence[Row]
    encoding: str
    separator: str
    complaints: tuple[Complaint, ...]
    above: tuple[int, ...] = ()


def read_table(
    path: Path, encoding: str | None = None, is_header: HeaderSign | None = None
) -> Table:
    """Reads a CSV file; raises TableError if it is missing, empty or not text.

    `encoding` is declared for a file without byte-order mark that is not UTF-8. The header is the
    first filled line, or the first one that `is_header` takes for it, below titles.
    """
    try:
        with open_regular(path) as file:
            content = file.read()
    except OSError as fault:
        raise TableError(explain_unopened(path, fault, CSV_FILE)) from fault
    return parse_table(content, path.name, encoding, is_header)


def parse_table(
    content: bytes, file: str, encoding: str | None = None, is_header: HeaderSign | None = None
) -> Table:
    """Reads the bytes of a CSV file as `read_table` does; `file` is its name in messages. Raises
    TableError.

    >>> parse_table(b"student;x\\n007;0,5\\n", "a.csv").rows[0]
    Row(line=2, cells=('007', '0,5'))
    """
    decoded = decode(content, file, encoding)
    text = decoded.text
    with cells_of_any_size(text):
        first = count_separator_lines(text)
        skipped = first if is_header is None else max(first, count_lines_above(text, is_header))
        body = drop_lines(text, skipped) if skipped else text
        separator, width = find_separator(body)
        grid = read_grid(body, separator, width, skipped + 1) if width else None
        read = partial(_read_filled, body, separator, width, skipped)
        filled, stray_quotes = (grid, []) if grid else _gather(read)
    if not filled:
        raise TableError(Fault(file, Message("files.empty-table")))
    grid = filled if isinstance(filled, CellGrid) else None
    header, rows = filled[0], grid.from_row(1) if grid else tuple(filled[1:])
    complaints = (
        *_complain_of_encoding(file, decoded),
        *(_complain_of_stray_quote(file, line + skipped) for line in stray_quotes),
        *_find_ragged(() if grid else rows, len(header.cells), file),
    )
    titles = enumerate(text.splitlines()[first:skipped], first + 1)
    above = tuple(line for line, title in titles if trim(title))
    return Table(file, header.cells, rows, decoded.encoding, separator, complaints, above)


def _gather(read: Callable[[list[int]], Iterator[Row]]) -> tuple[Sequence[Row], list[int]]:
    """The rows of a table, in a grid if they are even, and the lines with a stray quotation mark.

    Rows are packed as they are read: a class's cells one by one take ten times as much memory. Few
    tables are uneven, and are read again.
    """
    stray: list[int] = []
    grid = pack_grid(read(stray))
    if grid is not None:
        return grid, stray
    stray.clear()
    return [*read(stray)], stray


def _read_filled(
    body: str, separator: str, width: int, skipped: int, stray: list[int]
) -> Iterator[Row]:
    """The rows that are not blank, below so many lines that were skipped."""
    for line, cells in read_records(body, separator, width, stray):
        if cells and (cells[0].isalnum() or any(map(trim, cells))):
            yield Row(line + skipped, cells)


def drop_headers(table: Table) -> Sequence[Row]:
    """The rows that do not repeat the header, as in files that were put together from several.

    >>> [row.line for row in drop_headers(parse_table(b"id,x\\n1,2\\nid,x\\n3,4\\n", "a.csv"))]
    [2, 4]
    """
    first = table.header[:1]
    if isinstance(table.rows, CellGrid) and not table.rows.may_begin_row(first[0]):
        return table.rows
    return tuple(
        [row for row in table.rows if row.cells[:1] != first or not _is_header(row, table.header)]
    )


def _is_header(row: Row, header: Sequence[str]) -> bool:
    return [trim(cell) for cell in row.cells] == [trim(cell) for cell in header]


def _complain_of_encoding(file: str, decoded: Decoded) -> Iterator[Complaint]:
    misread = decoded.misread
    if misread:
        problem = Message("files.not-valid", encoding=misread.encoding, bytes=misread.shown)
        done = Message("files.read-as", encoding=name_encoding(decoded.encoding))
        yield Complaint(file, misread.line, "", "", problem, done)


def _complain_of_stray_quote(file: str, line: int) -> Complaint:
    problem, done = Message("files.stray-quote"), Message("files.stray-quote-done")
    return Complaint(file, line, "", "", problem, done)


def _find_ragged(rows: Sequence[Row], width: int, file: str) -> Iterator[Complaint]:
    longer = sum(any(map(trim, row.cells[width:])) for row in rows)
    if longer >= _MANY and 2 * longer > len(rows):
        problem = Message("files.many-longer", count=longer, width=width)
        yield Complaint(file, None, "", "", problem, Message("files.many-longer-do"))
    for row in rows:
        if len(row.cells) == width:
            continue
        count, surplus = len(row.cells), row.cells[width:]
        problem = Message("files.ragged", cells=count, width=width)
        if count < width:
            yield Complaint(file, row.line, "", "", problem, Message("files.taken-as-blank"))
        elif any(map(trim, surplus)):
            content = write_csv_text([shorten(cell) for cell in surplus], []).rstrip("\n")
            yield Complaint(file, row.line, "", content, problem, Message("files.surplus-quote"))
