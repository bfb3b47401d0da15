"""Rows that are marked together: papers, and the entries that are marked by them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass
from functools import cached_property
from typing import overload

import numpy as np
from numpy.typing import NDArray

from kinegrade.exam.folder.keys import Paper
from kinegrade.grading.sheets.entry import Entry
from kinegrade.grading.sheets.grid_entries import GridBlock
from kinegrade.grading.typed.cell_block import CellBlock, ListedCells

Row = tuple[Paper, Entry]


@dataclass(frozen=True, eq=False)
class Rows(Sequence[Row]):
    """Papers, each with an entry."""

    papers: Sequence[Paper]
    entries: Sequence[Entry]

    @classmethod
    def of(cls, rows: Sequence[Row]) -> Rows:
        """These rows."""
        return cls([paper for paper, _ in rows], [entry for _, entry in rows])

    def __len__(self) -> int:
        return len(self.papers)

    @overload
    def __getitem__(self, row: int) -> Row: ...

    @overload
    def __getitem__(self, row: slice) -> Sequence[Row]: ...

    def __getitem__(self, row: int | slice) -> Row | Sequence[Row]:
        if isinstance(row, slice):
            return Rows(self.papers[row], self.entries[row])
        return self.papers[row], self.entries[row]

    @property
    def cells(self) -> CellBlock:
        """What is typed in them."""
        if isinstance(self.entries, GridBlock):
            return self.entries
        return ListedCells([entry.responses for entry in self.entries])

    @cached_property
    def lacking(self) -> Mapping[int, Set[int]]:
        """The rows whose papers do not hold every question, with the numbers of the asks that they
        lack.
        """
        listed = [row for row, paper in enumerate(self.papers) if isinstance(paper.keys, list)]
        return {row: lacks for row in listed if (lacks := self.papers[row].lacks)}

    @property
    def files(self) -> Sequence[str]:
        """The file of each."""
        if isinstance(self.entries, GridBlock):
            return [self.entries.grid.file] * len(self.entries)
        return [entry.file for entry in self.entries]

    @property
    def lines(self) -> NDArray[np.intp]:
        """The line of each, 0 where there is none."""
        if isinstance(self.entries, GridBlock):
            return self.entries.lines
        return np.array([entry.line or 0 for entry in self.entries], dtype=np.intp)
