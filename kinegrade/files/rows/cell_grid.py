"""Rows of equally many cells, as most files have: their text, and where each cell ends.

Where nothing in a file is quoted, that is the text of the file.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from kinegrade.files.cell_text import trim
from kinegrade.files.rows.letter_table import LetterTable, gather_letters, pad_text
from kinegrade.files.rows.made_rows import MadeRows
from kinegrade.files.rows.row import Row

_BREAK, _BETWEEN = "\n", "\x1f"
_WINDOWS_BREAK = "\r\n"
_QUOTE = '"'
_LETTERS = np.array([chr(letter).isalnum() and letter < 128 for letter in range(256)])

_Places = NDArray[np.intp]


@dataclass(frozen=True, eq=False)
class CellGrid(MadeRows):
    """Rows of so many cells, made as they are asked for, and the `lines` on which they stand.

    Cells are counted row after row: one begins behind a place of the `bounds` and ends at the next.
    Behind the last there are as many zeros in the text as letters are looked at from any place on.
    """

    text: bytes
    separator: str
    width: int
    bounds: _Places
    lines: _Places

    def __len__(self) -> int:
        return len(self.lines)

    def _make(self, place: int) -> Row:
        begin, end = self.bounds[[place * self.width, (place + 1) * self.width]].tolist()
        return self._row(int(self.lines[place]), begin + 1, end)

    def __iter__(self) -> Iterator[Row]:
        ends = pairwise(self.bounds[:: self.width].tolist())
        for line, (begin, end) in zip(self.lines.tolist(), ends, strict=True):
            yield self._row(line, begin + 1, end)

    def _row(self, line: int, begin: int, end: int) -> Row:
        return Row(line, tuple(_decode(self.text[begin:end]).split(self.separator)))

    def from_row(self, row: int) -> CellGrid:
        """The rows from that one on."""
        bounds = self.bounds[row * self.width :]
        return CellGrid(self.text, self.separator, self.width, bounds, self.lines[row:])

    def column(self, number: int) -> Sequence[str]:
        """The cells of a column."""
        begins, ends = self.bounds[number:-1][:: self.width], self.bounds[number + 1 :: self.width]
        pieces = zip((begins + 1).tolist(), ends.tolist(), strict=True)
        if self.text.isascii():  # where letters are bytes, the whole is decoded at once
            letters = self.text.decode("ascii")
            return [letters[begin:end] for begin, end in pieces]
        return [_decode(self.text[begin:end]) for begin, end in pieces]

    def may_begin_row(self, cell: str) -> bool:
        """False only where certainly no row begins with that cell."""
        beginning, begin = cell.encode("utf-8", "surrogatepass"), int(self.bounds[0]) + 1
        behind = self.text.find(_BREAK.encode() + beginning, begin) >= 0
        return behind or self.text.startswith(beginning, begin)

    def cell(self, number: int) -> str:
        """A cell, counted row after row."""
        begin, end = self.bounds[number : number + 2].tolist()
        return _decode(self.text[begin + 1 : end])

    def tabulate(self, cells: _Places) -> LetterTable:
        """The letters of these cells, nothing for one below 0."""
        begins, ends, there = np.zeros_like(cells), np.zeros_like(cells), cells >= 0
        begins[there], ends[there] = self.bounds[cells[there]] + 1, self.bounds[cells[there] + 1]
        return gather_letters(self._letters, begins, ends)

    @cached_property
    def _letters(self) -> NDArray[np.uint8]:
        return np.frombuffer(self.text, dtype=np.uint8)


def read_grid(text: str, separator: str, width: int, line: int) -> CellGrid | None:
    """The rows of a text that begins at that line; None where its lines are not so even, or one has
    blanks alone.
    """
    text = text.replace(_WINDOWS_BREAK, _BREAK)
    if "\r" in text or "\0" in text:
        return None
    content = (text if text.endswith(_BREAK) else text + _BREAK).encode("utf-8", "surrogatepass")
    if _QUOTE in text:
        unquoted = _drop_quotes(content, separator)
        if unquoted is None:
            return None
        content, separator = unquoted, _BETWEEN
    count = content.count(_BREAK.encode())
    grid = _divide(content, separator, width, np.arange(line, line + count))
    if grid is None:
        return None
    first = np.frombuffer(grid.text, dtype=np.uint8)[grid.bounds[:-1:width] + 1]
    doubtful = np.flatnonzero(~_LETTERS[first]).tolist()
    filled = all(any(map(trim, grid[row].cells)) for row in doubtful)
    return grid if filled else None


def _drop_quotes(content: bytes, separator: str) -> bytes | None:
    """Lines without their quotation marks, with cells that are parted by a letter that no cell has;
    None where marks do more than to hold together the text of a whole cell on one line.
    """
    if _BETWEEN.encode() in content:
        return None
    letters = np.frombuffer(content, dtype=np.uint8).copy()
    ends = np.flatnonzero((letters == ord(separator)) | (letters == ord(_BREAK)))
    quotes = np.flatnonzero(letters == ord(_QUOTE))
    opening, closing = quotes[::2], quotes[1::2]
    if len(opening) > len(closing):
        return None
    before = letters[opening - 1]  # before the first letter, the break that is the last
    after = letters[closing + 1]
    if not all(np.isin(each, [ord(separator), ord(_BREAK)]).all() for each in (before, after)):
        return None
    outside = ends[np.searchsorted(quotes, ends) % 2 == 0]
    breaks = np.count_nonzero(letters[outside] == ord(_BREAK))
    if breaks < np.count_nonzero(letters == ord(_BREAK)):
        return None
    letters[outside[letters[outside] == ord(separator)]] = ord(_BETWEEN)
    unquoted: bytes = letters[letters != ord(_QUOTE)].tobytes()
    return unquoted


def pack_grid(rows: Iterable[Row]) -> CellGrid | None:
    """The same rows in a grid; None where there are none or they have not equally many cells, or
    one has a letter that has a meaning here.
    """
    pieces: list[str] = []
    lines: list[int] = []
    width = 0
    for line, cells in rows:
        if lines and len(cells) != width:
            return None
        width = len(cells)
        lines.append(line)
        pieces.append(f"{_BETWEEN.join(cells)}{_BREAK}")
    text = "".join(pieces)
    counts = text.count(_BETWEEN), text.count(_BREAK)
    if not lines or "\0" in text or counts != ((width - 1) * len(lines), len(lines)):
        return None
    content = text.encode("utf-8", "surrogatepass")
    return _divide(content, _BETWEEN, width, np.array(lines, dtype=np.intp))


def _divide(content: bytes, separator: str, width: int, lines: _Places) -> CellGrid | None:
    """The cells of a text; None where its lines have not so many."""
    letters = np.frombuffer(content, dtype=np.uint8)
    ends = np.flatnonzero((letters == ord(separator)) | (letters == ord(_BREAK)))
    if len(ends) != width * len(lines):
        return None
    is_break = letters[ends].reshape(-1, width) == ord(_BREAK)
    if is_break[:, :-1].any() or not is_break[:, -1].all():
        return None
    bounds = np.append(-1, ends)
    del letters, ends, is_break
    return CellGrid(pad_text(content), separator, width, bounds, lines)


def _decode(text: bytes) -> str:
    return text.decode("utf-8", "surrogatepass")
