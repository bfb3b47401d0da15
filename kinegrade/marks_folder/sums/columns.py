"""The lines of marks.csv by columns, block by block: what sums are made of, in a fraction of the
time that reading record by record takes.

`reading` uses it, and goes on record by record from where a text is not as `grade` writes it;
whatever is wrong with a file is found there.
"""

from __future__ import annotations

from codecs import BOM_UTF8
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import pairwise
from pathlib import Path

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from kinegrade.files.cell_text import is_answered
from kinegrade.files.csv_writing import restore
from kinegrade.marks_folder.layout import ANSWERS
from kinegrade.marks_folder.rows import QuestionSums, StudentSums

_Places = NDArray[np.intp]
_Letters = NDArray[np.uint8]

_FEW, _MANY = 2**17, 2**18  # bytes in a block: more take less time, and more memory
_LARGE = 2**24  # bytes; such a file is that of a class that takes that memory anyway
_ALL = slice(None)
_LONGEST = 64  # bytes of a cell that is compared: a longer one would make all as long
_BEHIND = b"\0" * _LONGEST
_COMMA, _END, _QUOTE, _MINUS = b',\n"-'
_ZERO, _NINE = b"09"
_HEADER = f"{','.join(ANSWERS.columns)}\n".encode()
_STUDENT, _QUESTION, _RESPONSE, _POINTS, _OUT_OF = map(
    ANSWERS.columns.index, ("student", "question", "response", "points", "out_of")
)


class OddTextError(Exception):
    """A text that has to be read record by record."""


# Gives the sums of cells that are amounts, each with its question beside it; None where one is none
AddUp = Callable[[tuple[str, ...], tuple[str, ...]], QuestionSums | None]
_Sums = tuple[QuestionSums, QuestionSums]  # of the points, and of the maxima
_Known = dict[tuple[int, ...], dict[bytes, _Sums]]  # by the widths of cells, and by the cells


def read_students(path: Path, add_up: AddUp) -> Iterator[StudentSums]:
    """The sums of the students in the order of the file, as the machine gave them. Raises
    OddTextError at the first whose lines have to be read record by record, OSError where the file
    cannot be read.
    """
    adding, line, left = _Adding(add_up), 1, b""
    size = _FEW if path.stat().st_size < _LARGE else _MANY
    with path.open("rb") as stream:
        if stream.readline(len(BOM_UTF8 + _HEADER)).removeprefix(BOM_UTF8) != _HEADER:
            raise OddTextError
        while text := stream.read(size):
            block = _Block.of(left + text)
            begins = block.find_students()
            # The lines of the last student may go on in the next block
            yield from block.list_students(begins, line, adding)
            if len(begins):
                left = block.text[block.find_begin(begins[-1]) :]
                line += block.count_breaks(begins[-1])
            else:
                left = block.text
    block = _Block.of(left)
    if len(block.text) > block.find_begin(len(block.ends)):  # a last line without its end
        raise OddTextError
    yield from block.list_students(np.append(block.find_students(), len(block.ends)), line, adding)


@dataclass(frozen=True, slots=True)
class _Block:
    """The lines with which a `text` begins: where their cells end, a row for each line, and how
    many line breaks there are up to the end of each, those in cells too.
    """

    text: bytes
    letters: _Letters
    ends: _Places
    breaks: _Places

    @classmethod
    def of(cls, text: bytes) -> _Block:
        """The whole lines of a text. Raises OddTextError."""
        letters, width = np.frombuffer(text + _BEHIND, dtype=np.uint8), len(ANSWERS.columns)
        places = np.flatnonzero((letters == _COMMA) | (letters == _END) | (letters == _QUOTE))
        found = letters[places]
        is_quote = found == _QUOTE
        is_open = np.cumsum(is_quote, dtype=np.uint8) & 1 == 1
        outside = np.flatnonzero(~is_open & ~is_quote)
        lines = np.flatnonzero(found[outside] == _END)
        if (lines != np.arange(1, len(lines) + 1) * width - 1).any():
            raise OddTextError
        ends = places[outside[: width * len(lines)]].reshape(-1, width)
        breaks = np.searchsorted(places[found == _END], ends[:, -1], side="right")
        block = cls(text, letters, ends, breaks)
        block._require_plain(places[is_quote])
        return block

    def _require_plain(self, quotes: _Places) -> None:
        """Raises OddTextError where the lines are not UTF-8, have other line breaks, or quotation
        marks elsewhere than around a cell or doubled in it.
        """
        end = self.find_begin(len(self.ends))
        whole, quotes = self.text[:end], quotes[quotes < end]
        opening, closing = quotes[::2], quotes[1::2]
        before, behind = self.letters[opening[opening > 0] - 1], self.letters[closing + 1]
        allowed = np.isin(np.concatenate([before, behind]), (_COMMA, _END, _QUOTE))
        if b"\0" in whole or b"\r" in whole or not allowed.all():
            raise OddTextError
        try:
            whole.decode("utf-8")
        except UnicodeDecodeError as fault:
            raise OddTextError from fault

    def find_begin(self, line: int) -> int:
        """Where a line begins."""
        return int(self.ends[line - 1, -1]) + 1 if line else 0

    def count_breaks(self, line: int) -> int:
        """How many line breaks there are before a line."""
        return int(self.breaks[line - 1]) if line else 0

    def find_students(self) -> _Places:
        """The first line of each student. Raises OddTextError."""
        students = self.cut(_STUDENT)
        first = np.ones(len(students), dtype=np.bool_)
        first[1:] = students[1:] != students[:-1]
        return np.flatnonzero(first)

    def list_students(self, begins: _Places, line: int, adding: _Adding) -> Iterator[StudentSums]:
        """The sums of the students whose lines begin there, but for the last; there are so many
        lines before the block. Raises OddTextError.
        """
        if len(begins) < 2:
            return
        students = self.cut(_STUDENT, begins[:-1]).tolist()
        last = (line + self.breaks[begins[1:] - 1]).tolist()
        sums = adding.add_up(self, begins)
        answered = self._are_answered(begins)
        for each in zip(last, students, sums, answered, strict=True):
            place, name, added, typed = each
            yield StudentSums(place, name.decode(), *added, typed)

    def cut(self, column: int, lines: _Places | slice = _ALL) -> NDArray[np.bytes_]:
        """The cells of a column in these lines, which have no quotation marks. Raises
        OddTextError.
        """
        begins, ends = self._find_begins(column)[lines], self.ends[lines, column]
        width = max(1, int((ends - begins).max(initial=0)))
        if width > _LONGEST or (self.letters[begins] == _QUOTE).any():
            raise OddTextError
        cut = sliding_window_view(self.letters, width)[begins]
        cut *= np.arange(width, dtype=np.uint8) < (ends - begins).astype(np.uint8)[:, None]
        return cut.view(f"S{width}").ravel()

    def _find_begins(self, column: int) -> _Places:
        """Where the cells of a column begin."""
        if column:
            return self.ends[:, column - 1] + 1
        return np.append(0, self.ends[:-1, -1] + 1)[: len(self.ends)]

    def _are_answered(self, begins: _Places) -> list[bool]:
        """Whether anything was typed in the lines from each beginning to the next: certainly where
        a cell begins with a digit or a minus sign before one, else by the whole cells.
        """
        responses = self._find_begins(_RESPONSE)
        first, second = self.letters[responses], self.letters[responses + 1]
        leading = np.where(first == _MINUS, second, first)
        certain = (leading >= _ZERO) & (leading <= _NINE)
        found: list[bool] = np.logical_or.reduceat(certain[: begins[-1]], begins[:-1]).tolist()
        for place in np.flatnonzero(~np.array(found)).tolist():
            found[place] = any(map(self._is_answered, range(begins[place], begins[place + 1])))
        return found

    def _is_answered(self, line: int) -> bool:
        """Whether anything was typed in the answer of a line."""
        cell = self.text[self.ends[line, _RESPONSE - 1] + 1 : self.ends[line, _RESPONSE]].decode()
        if cell.startswith('"'):
            cell = cell[1:-1].replace('""', '"')
        return is_answered(restore(cell))


@dataclass(frozen=True, slots=True)
class _Adding:
    """Adds up the amounts of students; those who got the same share their sums."""

    of_cells: AddUp
    known: _Known = field(default_factory=dict)

    def add_up(self, block: _Block, begins: _Places) -> Iterator[_Sums]:
        """The sums of the lines from each beginning to the next. Raises OddTextError."""
        columns = [block.cut(column) for column in (_QUESTION, _POINTS, _OUT_OF)]
        shared = self.known.setdefault(tuple(each.itemsize for each in columns), {})
        side_by_side = [each.view(np.uint8).reshape(len(each), -1) for each in columns]
        together = np.concatenate(side_by_side, axis=1)
        cells, size = together.tobytes(), together.shape[1]
        for begin, end in pairwise(begins.tolist()):
            key = cells[size * begin : size * end]
            if key not in shared:
                shared[key] = self._add_up([each[begin:end].tolist() for each in columns])
            yield shared[key]

    def _add_up(self, columns: Sequence[Sequence[bytes]]) -> _Sums:
        questions, *amounts = (tuple(map(_decode, each)) for each in columns)
        points, out_of = (self.of_cells(questions, each) for each in amounts)
        if points is None or out_of is None:
            raise OddTextError
        return points, out_of


@lru_cache(maxsize=1024)
def _decode(cell: bytes) -> str:
    """A question or an amount; few of them differ, and are held once."""
    return cell.decode()
