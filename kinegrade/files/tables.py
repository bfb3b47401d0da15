"""Tables as people send them: CSV in any usual encoding and separator, read without losing a line
or a cell.

`read_table` is called by the roster and by grading; both report `Complaint`s. CSV is written by
`csv_writing`.
"""

from __future__ import annotations

import codecs
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
from kinegrade.language import ENGLISH
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Fault, Message, Text

_SHOWN_CHARACTERS = 1000
_SEPARATORS = ",;\t"
_BLANKS = f"{_SEPARATORS} "
INVISIBLE = "\ufeff\u200b\u200c\u200d\u200e\u200f\u2060"
_SURROUNDING = "".join(chr(code) for code in range(0x3001) if chr(code).isspace()) + INVISIBLE
_END = "\x00end of table"
_MOST_STRAY_QUOTES = (
    20  # each takes a second reading of the rest; a file with more is read without quotation marks
)
_CONTROL_SHARE = 4  # a file of which more than a quarter is control characters is not text
_CONTROLS = bytes(set(range(32)) - set(b"\t\n\r\f")) + b"\x7f"
_MARKS = (
    (codecs.BOM_UTF8, "UTF-8"),
    (codecs.BOM_UTF32_LE, "UTF-32-LE"),  # before UTF-16, whose mark is its beginning
    (codecs.BOM_UTF32_BE, "UTF-32-BE"),
    (codecs.BOM_UTF16_LE, "UTF-16-LE"),
    (codecs.BOM_UTF16_BE, "UTF-16-BE"),
)
STRANGE_UTF_8 = "UTF-8, backslashreplace"  # no encoding is recognised: bytes written out
_OTHER_FORMATS = (
    (b"PK\x03\x04", Message("files.is-spreadsheet-or-archive")),
    (b"\xd0\xcf\x11\xe0", Message("files.is-spreadsheet")),
    (b"%PDF", Message("files.is-pdf")),
    (b"\x89PNG", Message("files.is-picture")),
    (b"\xff\xd8\xff", Message("files.is-picture")),
    (b"\x1f\x8b", Message("files.is-compressed")),
)
_CSV_FILE = Message("files.a-csv-file")
_SEND_CSV = Message("files.save-as-csv")


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
        raise TableError(Fault(str(path), reason, _CSV_FILE, do)) from fault
    return parse_table(content, path.name, encoding)


def parse_table(content: bytes, file: str, encoding: str | None = None) -> Table:
    """Reads the bytes of a CSV file; `file` is its name in messages, `encoding` as declared. Raises
    TableError.

    >>> parse_table(b"student;x\\n007;0,5\\n", "a.csv").rows
    (Row(line=2, cells=('007', '0,5')),)
    """
    declared = _decode_declared(content, file, encoding)
    if declared is None:
        _refuse_other_formats(content, file)
    text, encoding, complaints = (
        (declared, str(encoding), []) if declared is not None else _decode(content, file)
    )
    with _cells_of_any_size(text):
        separator, width = _find_separator(text)
        records, stray_quotes = _read_records(text, separator, width)
    filled = [Row(line, tuple(cells)) for line, cells in records if any(map(trim, cells))]
    if not filled:
        raise TableError(Fault(file, Message("files.empty-table")))
    header, *rows = filled
    complaints += [_complain_of_stray_quote(file, line) for line in stray_quotes]
    complaints += _find_ragged(rows, len(header.cells), file)
    return Table(file, header.cells, tuple(rows), encoding, separator, tuple(complaints))


def trim(text: str) -> str:
    """Without surrounding blanks of any kind: no-break, ideographic, zero-width, byte-order mark.

    >>> trim("\\u3000 007\\u200b ")
    '007'
    """
    return text.strip(_SURROUNDING)


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


def _refuse_other_formats(content: bytes, file: str) -> None:
    kinds = [kind for beginning, kind in _OTHER_FORMATS if content.startswith(beginning)]
    sample = content[:65536]
    controls = len(sample) - len(sample.translate(None, _CONTROLS))
    if (
        not kinds
        and _find_byte_order_mark(content) is None
        and controls * _CONTROL_SHARE > len(sample)
    ):
        kinds = [Message("files.is-not-text")]
    if kinds:
        raise TableError(Fault(file, kinds[0], _CSV_FILE, _SEND_CSV))


def _find_byte_order_mark(content: bytes) -> tuple[bytes, str] | None:
    return next((pair for pair in _MARKS if content.startswith(pair[0])), None)


def _decode_declared(content: bytes, file: str, encoding: str | None) -> str | None:
    """The text in the encoding that was declared; None where none was, or where a mark or UTF-8
    says otherwise.
    """
    if encoding is None or _find_byte_order_mark(content):
        return None
    try:
        content.decode("utf-8")
        if b"\0" not in content:
            return None
    except UnicodeDecodeError:
        pass
    try:
        return content.decode(encoding)
    except (LookupError, UnicodeError) as fault:
        what = Message("files.not-in-declared", encoding=encoding, reason=str(fault))
        expected, do = Message("files.text"), Message("files.declare-right")
        raise TableError(Fault(file, what, expected, do)) from fault


def _decode(content: bytes, file: str) -> tuple[str, str, list[Complaint]]:
    mark, encoding = _find_byte_order_mark(content) or (b"", "UTF-8")
    body = content[len(mark) :]
    try:
        return body.decode(encoding), encoding, []
    except UnicodeDecodeError as fault:
        line = body.count(b"\n", 0, fault.start) + 1
        shown = fault.object[fault.start : fault.start + 8].hex(" ")
    text, assumed = (
        _decode_assumed(body) if not mark else (body.decode(encoding, "backslashreplace"), encoding)
    )
    problem = Message("files.not-valid", encoding=encoding, bytes=shown)
    done = Message("files.read-as", encoding=name_encoding(assumed))
    return text, assumed, [Complaint(file, line, "", "", problem, done)]


def _decode_assumed(body: bytes) -> tuple[str, str]:
    """The text and its encoding: what most spreadsheets in China and Europe write if not UTF-8."""
    for encoding, is_likely in (("GB18030", _is_chinese), ("Windows-1252", bool)):
        try:
            text = body.decode(encoding)
        except UnicodeDecodeError:
            continue
        if is_likely(text):
            return text, encoding
    return body.decode("utf-8", "backslashreplace"), STRANGE_UTF_8


def name_encoding(encoding: str) -> Text:
    """The encoding of a table as messages name it."""
    return Message("files.strange-utf-8") if encoding == STRANGE_UTF_8 else encoding


def _is_chinese(text: str) -> bool:
    """Whether most characters beyond ASCII are the common ones of GB 2312; a Western text gives
    rare ones.
    """
    beyond = [character for character in text if not character.isascii()]
    common = "".join(beyond).encode("gb2312", "ignore").decode("gb2312")
    return 2 * len(common) > len(beyond)


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
