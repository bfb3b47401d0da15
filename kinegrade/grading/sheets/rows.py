"""Rows that are marked together: papers, and the entries that are marked by them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import overload

from kinegrade.exam.folder.columns.blocks import ListedPapers
from kinegrade.exam.folder.papers import Paper, PaperBlock
from kinegrade.grading.sheets.entries import Entries, ListedEntries
from kinegrade.grading.sheets.entry import Entry

Row = tuple[Paper, Entry]


@dataclass(frozen=True, eq=False)
class Rows(Sequence[Row]):
    """Papers, each with an entry."""

    papers: PaperBlock
    entries: Entries

    @classmethod
    def of(cls, rows: Sequence[Row]) -> Rows:
        """These rows."""
        return cls(
            ListedPapers([paper for paper, _ in rows]), ListedEntries([entry for _, entry in rows])
        )

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
