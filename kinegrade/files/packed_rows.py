"""The rows of a large table in a fifth of the memory of a text for each cell, made again whenever
they are asked for.

The files of a class are kept so while it is marked.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import accumulate
from typing import overload

from kinegrade.files.tables import Row

_BETWEEN = "\0"


@dataclass(frozen=True, slots=True)
class PackedRows(Sequence[Row]):
    """The cells of all rows in one text; the rows end at `ends`, which begin with 0, and stand on
    these `lines`.
    """

    text: bytes
    ends: Sequence[int]
    lines: Sequence[int]

    def __len__(self) -> int:
        return len(self.lines)

    @overload
    def __getitem__(self, place: int) -> Row: ...

    @overload
    def __getitem__(self, place: slice) -> Sequence[Row]: ...

    def __getitem__(self, place: int | slice) -> Row | Sequence[Row]:
        if isinstance(place, slice):
            return [self[each] for each in range(*place.indices(len(self)))]
        each = range(len(self))[place]
        text = self.text[self.ends[each] : self.ends[each + 1]]
        return Row(self.lines[each], tuple(text.decode("utf-8", "surrogatepass").split(_BETWEEN)))


def pack_rows(rows: Iterable[Row]) -> Sequence[Row]:
    """The same rows, packed where that is possible.

    >>> [*pack_rows([Row(2, ("007", "0.5")), Row(4, ("", ""))])]
    [Row(line=2, cells=('007', '0.5')), Row(line=4, cells=('', ''))]
    """
    listed = list(rows)
    if any(not row.cells or any(_BETWEEN in cell for cell in row.cells) for row in listed):
        return listed
    texts = [_BETWEEN.join(row.cells).encode("utf-8", "surrogatepass") for row in listed]
    ends = array("q", accumulate(map(len, texts), initial=0))
    return PackedRows(b"".join(texts), ends, array("q", [row.line for row in listed]))
