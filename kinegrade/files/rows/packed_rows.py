"""Rows of any number of cells in little memory."""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import accumulate

from kinegrade.files.rows.made_rows import MadeRows
from kinegrade.files.rows.row import Row

_BETWEEN = "\0"


@dataclass(frozen=True, slots=True)
class PackedRows(MadeRows):
    """Rows in a fifth of the memory of a text for each cell, made again as they are asked for.

    The cells of all rows are one text; the rows end at `ends`, which begin with 0, and stand on
    these `lines`.
    """

    text: bytes
    ends: Sequence[int]
    lines: Sequence[int]

    def __len__(self) -> int:
        return len(self.lines)

    def _make(self, place: int) -> Row:
        return self._row(self.lines[place], self.ends[place], self.ends[place + 1])

    def __iter__(self) -> Iterator[Row]:
        return map(self._row, self.lines, self.ends, self.ends[1:])

    def _row(self, line: int, begin: int, end: int) -> Row:
        text = self.text[begin:end].decode("utf-8", "surrogatepass")
        return Row(line, tuple(text.split(_BETWEEN)))


def pack_rows(rows: Iterable[Row]) -> Sequence[Row]:
    """The same rows, packed where that is possible.

    >>> [*pack_rows([Row(2, ("007", "0.5")), Row(4, ("", ""))])]
    [Row(line=2, cells=('007', '0.5')), Row(line=4, cells=('', ''))]
    """
    listed = list(rows)
    texts = [_BETWEEN.join(row.cells).encode("utf-8", "surrogatepass") for row in listed]
    together, counts = b"".join(texts), [len(row.cells) for row in listed]
    if 0 in counts or together.count(_BETWEEN.encode()) != sum(counts) - len(counts):
        return listed
    ends = array("q", accumulate(map(len, texts), initial=0))
    return PackedRows(together, ends, array("q", [row.line for row in listed]))
