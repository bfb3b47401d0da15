"""Rows of a table that are made as they are asked for."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from typing import overload

from kinegrade.files.rows.row import Row


class MadeRows(Sequence[Row]):
    """Rows by their places; how one is made, `_make`, is said by what holds their cells."""

    __slots__ = ()

    @overload
    def __getitem__(self, place: int) -> Row: ...

    @overload
    def __getitem__(self, place: slice) -> Sequence[Row]: ...

    def __getitem__(self, place: int | slice) -> Row | Sequence[Row]:
        if isinstance(place, slice):
            return [self._make(each) for each in range(*place.indices(len(self)))]
        return self._make(range(len(self))[place])

    @abstractmethod
    def _make(self, place: int) -> Row:
        """The row at a place from 0 on."""
