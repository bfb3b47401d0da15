"""Entries one after the other, which say together what is typed in them and where they stand."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from typing import overload

import numpy as np
from numpy.typing import NDArray

from kinegrade.grading.sheets.entry import Entry, Place
from kinegrade.grading.typed.cell_block import CellBlock, ListedCells


class Entries(Sequence[Entry]):
    """Entries that are listed, or stand in a grid."""

    @overload
    def __getitem__(self, place: int) -> Entry: ...

    @overload
    def __getitem__(self, place: slice) -> Entries: ...

    @abstractmethod
    def __getitem__(self, place: int | slice) -> Entry | Entries: ...

    @property
    @abstractmethod
    def cells(self) -> CellBlock:
        """What is typed in them."""

    @property
    @abstractmethod
    def files(self) -> Sequence[str]:
        """The file of each."""

    @property
    @abstractmethod
    def lines(self) -> NDArray[np.intp]:
        """The line of each, 0 where there is none."""

    @abstractmethod
    def place(self, entry: int, number: int) -> Place:
        """Where the response to an ask stands in one of them."""


@dataclass(frozen=True, eq=False)
class ListedEntries(Entries):
    """Entries that are held one by one."""

    listed: Sequence[Entry]

    def __len__(self) -> int:
        return len(self.listed)

    @overload
    def __getitem__(self, place: int) -> Entry: ...

    @overload
    def __getitem__(self, place: slice) -> ListedEntries: ...

    def __getitem__(self, place: int | slice) -> Entry | ListedEntries:
        if isinstance(place, slice):
            return ListedEntries(self.listed[place])
        return self.listed[place]

    @property
    def cells(self) -> CellBlock:
        """What is typed in them."""
        return ListedCells([entry.responses for entry in self.listed])

    @property
    def files(self) -> Sequence[str]:
        """The file of each, that of most of its answers where they come from several."""
        return [entry.main_place().file for entry in self.listed]

    @property
    def lines(self) -> NDArray[np.intp]:
        """The line of each, 0 where there is none."""
        return np.array([entry.main_place().line or 0 for entry in self.listed], dtype=np.intp)

    def place(self, entry: int, number: int) -> Place:
        """Where the response to an ask stands in one of them."""
        return self.listed[entry].place(number)
