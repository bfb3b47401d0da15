"""Tables as people send them: CSV in any usual encoding and separator, read without losing a line
or a cell.

`read_table` is called by the roster and by grading; both report `Complaint`s. CSV is written by
`csv_writing`.
"""

from __future__ import annotations

import csv
import io
import unicodedata
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import chain, islice
from pathlib import Path
from typing import NamedTuple

from kinegrade.errors import TableError
from kinegrade.files.csv_writing import write_csv_text
from kinegrade.files.decoding import CSV_FILE, Decoded, decode, name_encoding
from kinegrade.language import ENGLISH
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Fault, Message, Text

_SHOWN_CHARACTERS = 1000
_SEPARATORS = ",;\t"
_BLANKS = f"{_SEPARATORS} "
INVISIBLE = "\ufeff\u200b\u200c\u200d\u200e\u200f\u2060"
_SURROUNDING = "".join(chr(code) for code in range(0x3001) if chr(code).isspace()) + INVISIBLE
_DASHES = "-\u2010\u2011\u2012\u2013\u2014\u2015\u2212\uff0d "
_END = "\x00end of table"
_MOST_STRAY_QUOTES = (
    20  # each takes a second reading of the rest; a file with more is read without quotation marks
)


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


class Row(NamedTuple):
    """One record; `line` is the physical line, counted from 1, on which it begins."""

    line: int
    cells: tuple[str, ...]

    def cell(self, index: int) -> str:
        """The cell of that column, empty where the line is too short."""
        return self.cells[index] if index < len(self.cells) else ""


@dataclass(frozen=True, slots=True)
class Table:
    """A table as it is in the file: cells unchanged, ragged rows kept, rows of only blanks left
    out.
    """

    file: str
    header: tuple[str, ...]
    rows: tuple[Row, ...]
    encoding: str
    separator: str
    complaints: tuple[Complaint, ...]


def read_table(path: Path, encoding: str | None = None) -> Table:
    """Reads a CSV file; raises TableError if it is missing, empty or not text.

    `encoding` is declared for a file without byte-order mark that is not UTF-8.
    """
    try:
        content = path.read_bytes()
    except OSError as fault:
        reason = Message("files.cannot-be-read", reason=str(fault.strerror))
        do = Message("files.check-the-name")
        raise TableError(Fault(str(path), reason, CSV_FILE, do)) from fault
    return parse_table(content, path.name, encoding)


def parse_table(content: bytes, file: str, encoding: str | None = None) -> Table:
    """Reads the bytes of a CSV file; `file` is its name in messages, `encoding` as declared. Raises
    TableError.

    >>> parse_table(b"student;x\\n007;0,5\\n", "a.csv").rows
    (Row(line=2, cells=('007', '0,5')),)
    """
    decoded = decode(content, file, encoding)
    text = decoded.text
    with _cells_of_any_size(text):
        separator, width = _find_separator(text)
        records, stray_quotes = _read_records(text, separator, width)
    filled = [Row(line, tuple(cells)) for line, cells in records if any(map(trim, cells))]
    if not filled:
        raise TableError(Fault(file, Message("files.empty-table")))
    header, *rows = filled
    complaints = (
        *_complain_of_encoding(file, decoded),
        *(_complain_of_stray_quote(file, line) for line in stray_quotes),
        *_find_ragged(rows, len(header.cells), file),
    )
    return Table(file, header.cells, tuple(rows), decoded.encoding, separator, complaints)


def trim(text: str) -> str:
    """Without surrounding blanks of any kind: no-break, ideographic, zero-width, byte-order mark.

    >>> trim("\\u3000 007\\u200b ")
    '007'
    """
    return text.strip(_SURROUNDING)


def is_answered(cell: str) -> bool:
    """Whether anything but blanks and dashes was typed.

    >>> is_answered("0"), is_answered(" - ")
    (True, False)
    """
    return cell[:1].isalnum() or bool(trim(cell).strip(_DASHES))


def make_header_key(text: str) -> str:
    """A column name for comparison: no full-width forms, single blanks, no upper case.

    >>> make_header_key(" Q1\\uff0ev_B ")
    'q1.v_b'
    """
    return " ".join(trim(unicodedata.normalize("NFKC", text)).casefold().split())


def drop_headers(table: Table) -> tuple[Row, ...]:
    """The rows that do not repeat the header, as in files that were put together from several.

    >>> [row.line for row in drop_headers(parse_table(b"id,x\\n1,2\\nid,x\\n3,4\\n", "a.csv"))]
    [2, 4]
    """
    first = table.header[0] if table.header else ""
    return tuple(
        [row for row in table.rows if row.cell(0) != first or not _is_header(row, table.header)]
    )


def _is_header(row: Row, header: Sequence[str]) -> bool:
    return [trim(cell) for cell in row.cells] == [trim(cell) for cell in header]


def shorten(text: str) -> str:
    """A cell for a report: of a longer one the first SHOWN_CHARACTERS, and how many there are.

    >>> shorten("9" * 5000)[-14:]
    '9… (1000/5000)'
    """
    if len(text) <= _SHOWN_CHARACTERS:
        return text
    return f"{text[:_SHOWN_CHARACTERS]}… ({_SHOWN_CHARACTERS}/{len(text)})"


@contextmanager
def _cells_of_any_size(text: str) -> Iterator[None]:
    before = csv.field_size_limit(len(text) + len(_END) + 1)
    try:
        yield
    finally:
        csv.field_size_limit(before)


def _find_separator(text: str) -> tuple[str, int]:
    """The separator that gives the header the most columns (a comma if any), and how many."""

    def columns(separator: str) -> int:
        records = csv.reader(io.StringIO(text, newline=""), delimiter=separator)
        return next(
            (len(cells) for cells in records if any(trim(cell).strip(_BLANKS) for cell in cells)),
            0,
        )

    separator = max(_SEPARATORS, key=columns)
    return separator, columns(separator)


def _read_records(
    text: str, separator: str, width: int
) -> tuple[list[tuple[int, list[str]]], list[int]]:
    """All records with the lines on which they begin, and the lines with a stray quotation mark.

    A quotation mark is stray if it is never closed, or closed on a later line so that the record
    does not have the header's width or is not proper CSV. Such a line is read by itself; otherwise
    it would swallow those after it.
    """
    lines = list(io.StringIO(text, newline=""))
    records: list[tuple[int, list[str]]] = []
    stray: list[int] = []
    first = 0
    while True:
        quoting = len(stray) < _MOST_STRAY_QUOTES
        for line, cells, after in _read(lines, first, separator, quoting):
            if after - line > 1 and (
                len(cells) != width or not _is_strict(lines[line - 1 : after - 1], separator)
            ):
                records.append((line, lines[line - 1].rstrip("\r\n").split(separator)))
                stray.append(line)
                first = line
                break
            records.append((line, cells))
        else:
            return records[:-1], stray


def _read(
    lines: list[str], first: int, separator: str, quoting: bool
) -> Iterator[tuple[int, list[str], int]]:
    """Records from the index `first` on, each with its line and the next; the last is the end
    mark.
    """
    source = chain(islice(lines, first, None), [_END])
    if quoting:
        reader = csv.reader(source, delimiter=separator)
    else:
        reader = csv.reader(source, delimiter=separator, quoting=csv.QUOTE_NONE)
    line = first + 1
    for cells in reader:
        after = first + reader.line_num + 1
        yield line, cells, after
        line = after


def _is_strict(lines: list[str], separator: str) -> bool:
    try:
        list(csv.reader(lines, delimiter=separator, strict=True))
    except csv.Error:
        return False
    return True


def _complain_of_encoding(file: str, decoded: Decoded) -> Iterator[Complaint]:
    misread = decoded.misread
    if misread:
        problem = Message("files.not-valid", encoding=misread.encoding, bytes=misread.shown)
        done = Message("files.read-as", encoding=name_encoding(decoded.encoding))
        yield Complaint(file, misread.line, "", "", problem, done)


def _complain_of_stray_quote(file: str, line: int) -> Complaint:
    problem, done = Message("files.stray-quote"), Message("files.stray-quote-done")
    return Complaint(file, line, "", "", problem, done)


def _find_ragged(rows: Iterable[Row], width: int, file: str) -> Iterator[Complaint]:
    for row in rows:
        count, surplus = len(row.cells), row.cells[width:]
        problem = Message("files.ragged", cells=count, width=width)
        if count < width:
            yield Complaint(file, row.line, "", "", problem, Message("files.taken-as-blank"))
        elif any(map(trim, surplus)):
            content = write_csv_text([shorten(cell) for cell in surplus], []).rstrip("\n")
            yield Complaint(file, row.line, "", content, problem, Message("files.surplus-quote"))
