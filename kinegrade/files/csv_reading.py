"""CSV read record by record; a stray quotation mark swallows no line."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import chain, islice

from kinegrade.files.cell_text import trim
from kinegrade.files.header_line import MOST_ABOVE, HeaderSign, find_header

_SEPARATORS = ",;\t"
_SEPARATOR_LINE = re.compile(r'"?sep=.?"?[\t,;]*\r?\n', re.IGNORECASE)
_BLANKS = f"{_SEPARATORS} "
_END = "\x00end of table"
_MOST_STRAY_QUOTES = (
    20  # each takes a second reading of the rest; a file with more is read without quotation marks
)


@contextmanager
def cells_of_any_size(text: str) -> Iterator[None]:
    """While it holds, `csv` reads cells of any size that the text can have."""
    before = csv.field_size_limit(len(text) + len(_END) + 1)
    try:
        yield
    finally:
        csv.field_size_limit(before)


def count_lines_above(text: str, is_header: HeaderSign) -> int:
    """How many lines stand above the header, whatever separates its cells."""
    records = [
        record
        for separator in _SEPARATORS
        for record in _read_first(text, separator)
        if any(map(trim, record[1]))
    ]
    return records[find_header([cells for _, cells in records], is_header)][0] if records else 0


def _read_first(text: str, separator: str) -> Iterator[tuple[int, list[str]]]:
    """The first records, with the number of lines before each."""
    reader = csv.reader(islice(io.StringIO(text, newline=""), MOST_ABOVE), delimiter=separator)
    before = 0
    for cells in reader:
        yield before, cells
        before = reader.line_num


def count_separator_lines(text: str) -> int:
    """1 where the first line names the separator, for spreadsheet programs alone.

    >>> count_separator_lines("sep=;\\na;b\\n"), count_separator_lines("a;b\\n")
    (1, 0)
    """
    return 1 if _SEPARATOR_LINE.match(text) else 0


def drop_lines(text: str, count: int) -> str:
    """A text without its first lines, counted as `read_records` counts them."""
    return "".join(islice(io.StringIO(text, newline=""), count, None))


def find_separator(text: str) -> tuple[str, int]:
    """The separator that gives the header the most columns (a comma if any), and how many."""

    def columns(separator: str) -> int:
        records = csv.reader(io.StringIO(text, newline=""), delimiter=separator)
        return next(
            (len(cells) for cells in records if any(trim(cell).strip(_BLANKS) for cell in cells)),
            0,
        )

    separator = max(_SEPARATORS, key=columns)
    return separator, columns(separator)


def read_records(
    text: str, separator: str, width: int, stray: list[int]
) -> Iterator[tuple[int, tuple[str, ...]]]:
    """All records with the lines on which they begin, one by one; the lines with a stray quotation
    mark are added to `stray`.

    A quotation mark is stray if it is never closed, or closed on a later line so that the record
    does not have the header's width or is not proper CSV. Such a line is read by itself; otherwise
    it would swallow those after it.
    """
    if '"' not in text and "\r" not in text:  # as most files
        yield from _split(text, separator)
        return
    lines = list(io.StringIO(text, newline=""))
    first = 0
    while True:
        quoting = len(stray) < _MOST_STRAY_QUOTES
        for line, cells, after in _read(lines, first, separator, quoting):
            if after - line > 1 and (
                len(cells) != width or not _is_strict(lines[line - 1 : after - 1], separator)
            ):
                yield line, tuple(lines[line - 1].rstrip("\r\n").split(separator))
                stray.append(line)
                first = line
                break
            if line <= len(lines):
                yield line, tuple(cells)
        else:
            return


def _split(text: str, separator: str) -> Iterator[tuple[int, tuple[str, ...]]]:
    """All records of a text in which nothing is quoted, and every line ends alike."""
    lines = text.split("\n")
    if not lines[-1]:
        lines.pop()
    for number, line in enumerate(lines, 1):
        yield number, tuple(line.split(separator)) if line else ()


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
