"""Rows of typed cells that are read together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain
from typing import Protocol

from kinegrade.grading.typed.parted_cells import PartedCells


class CellBlock(Protocol):
    """Rows that are listed, or stand in a grid."""

    @property
    def width(self) -> int:
        """How many cells each row has."""

    @property
    def rows(self) -> Sequence[Sequence[str]]:
        """The cells row by row."""

    @property
    def parted(self) -> PartedCells | None:
        """All cells, as many in each row; None where they are left to be read row by row."""


@dataclass(frozen=True)
class ListedCells:
    """Rows of equally many cells, as a rule."""

    rows: Sequence[Sequence[str]]

    @property
    def width(self) -> int:
        """How many cells each row has."""
        return len(self.rows[0]) if self.rows else 0

    @cached_property
    def parted(self) -> PartedCells | None:
        """All cells, as many in each row; None where they are left to be read row by row."""
        if not self.width or any(len(row) != self.width for row in self.rows):
            return None
        return PartedCells.of([*chain.from_iterable(self.rows)])
