"""Thousands of lines put together column by column, as bytes, in a fraction of the time that a text
for each cell takes.

A column has a text for each line, followed by zeros where another one is longer. A text that is
long, or holds a letter with a meaning here, is put in its place at the end.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import chain
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

Texts = NDArray[np.bytes_]
_Places = NDArray[np.intp]

_NOTHING, _LATER = b"\0", b"\1"
_NONE: Mapping[int, bytes] = MappingProxyType({})
_LONGEST = 32  # letters in a column; a longer text would make all lines as long
# Lines put together at once: few enough for a processor's cache, enough to cost little each
_TOGETHER = 1000


@dataclass(frozen=True, slots=True)
class LineColumns:
    """The columns of so many lines, as far as they have been added; `later` are texts to be put in
    their places, each with its line and its column.
    """

    count: int
    columns: list[Texts] = field(default_factory=list)
    later: list[tuple[int, int, bytes]] = field(default_factory=list)

    def add(self, texts: Sequence[bytes], which: _Places | None = None) -> None:
        """A column with a text for each line; with `which`, the number of its text is given for
        each line.
        """
        chosen = np.arange(self.count) if which is None else which
        short = list(texts)
        put_later = _find_later(texts)
        if put_later:
            for number in put_later:
                short[number] = _LATER
            is_later = np.zeros(len(texts), dtype=np.bool_)
            is_later[put_later] = True
            at = len(self.columns)
            for line in np.flatnonzero(is_later[chosen]).tolist():
                self.later.append((line, at, texts[chosen[line]]))
        column = np.array(short, dtype=np.bytes_)
        self.columns.append(column if which is None else column.take(which))

    def add_plain(self, texts: Texts, others: Mapping[int, bytes] = _NONE) -> None:
        """A column of texts without letters that have a meaning here, and by line others in place
        of some, with any letters.
        """
        if texts.itemsize > _LONGEST:
            listed = texts.tolist()
            for line, text in others.items():
                listed[line] = text
            self.add(listed)
            return
        column = texts.copy() if others else texts
        for line, text in others.items():
            column[line] = _LATER
            self.later.append((line, len(self.columns), text))
        self.columns.append(column)

    def add_again(self, column: int) -> None:
        """The same column once more."""
        again = len(self.columns)
        self.columns.append(self.columns[column])
        self.later.extend([(line, again, text) for line, at, text in self.later if at == column])

    def write(self, lines: _Places) -> bytes:
        """The lines with these numbers, which ascend, one behind the other."""
        later = sorted(self.later)
        parts = (lines[begin : begin + _TOGETHER] for begin in range(0, len(lines), _TOGETHER))
        return b"".join(chain.from_iterable(self._write_part(part, later) for part in parts))

    def _write_part(
        self, lines: _Places, later: Sequence[tuple[int, int, bytes]]
    ) -> Iterator[bytes]:
        """Some of them in pieces; `later` are the texts to be put in their places, in order."""
        begin, end = int(lines[0]), int(lines[-1]) + 1
        columns = [column[begin:end] for column in self.columns]
        whole = np.empty(end - begin, [(f"{n}", each.dtype) for n, each in enumerate(columns)])
        for number, column in enumerate(columns):
            whole[f"{number}"] = column
        put = later[bisect_left(later, (begin,)) : bisect_left(later, (end,))]
        if len(lines) < end - begin:
            kept = {*lines.tolist()}
            whole, put = whole[lines - begin], [each for each in put if each[0] in kept]
        text = whole.tobytes().translate(None, _NOTHING)
        end = 0
        for _, _, each in put:  # which is faster than to split a text that has few of them
            begin, end = end, text.index(_LATER, end)
            yield text[begin:end]
            yield each
            end += len(_LATER)
        yield text[end:]


def _find_later(texts: Sequence[bytes]) -> list[int]:
    """The numbers of the texts that do not fit into a column."""
    whole = b"".join(texts)
    odd = _NOTHING in whole or _LATER in whole
    if not odd and max(map(len, texts), default=0) <= _LONGEST:
        return []
    return [
        number
        for number, text in enumerate(texts)
        if len(text) > _LONGEST or _NOTHING in text or _LATER in text
    ]
