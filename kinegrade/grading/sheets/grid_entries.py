"""The entries of a sheet whose students have one row each, in a grid: most sheets of large classes.

`part` makes them; a block of them is read in one step.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import repeat
from typing import overload

import numpy as np
from numpy.typing import NDArray

from kinegrade.files.rows.cell_grid import CellGrid
from kinegrade.grading.sheets.entries import Entries
from kinegrade.grading.sheets.entry import Entry, Place
from kinegrade.grading.typed.parted_cells import PartedCells

_NONE = -1  # in place of the row of a student who has none
_FEW, _MANY = 250, 4000  # rows in a block: more take less time, and more memory
_LARGE = 10_000  # rows; such a class takes that memory anyway

_Places = NDArray[np.intp]


@dataclass(frozen=True, eq=False)
class AnswerGrid:
    """A grid of that file, and the columns of its answers in the order of the asks."""

    cells: CellGrid
    columns: tuple[int, ...]
    file: str

    def entry(self, row: int) -> Entry:
        """The entry in a row."""
        if row == _NONE:
            return Entry(None, ("",) * len(self.columns), file=self.file)
        line, cells = self.cells[row]
        return Entry(line, tuple([cells[column] for column in self.columns]), file=self.file)


@dataclass(frozen=True, eq=False)
class GridBlock(Entries):
    """The entries in some rows."""

    grid: AnswerGrid
    places: _Places

    def __len__(self) -> int:
        return len(self.places)

    @overload
    def __getitem__(self, place: int) -> Entry: ...

    @overload
    def __getitem__(self, place: slice) -> GridBlock: ...

    def __getitem__(self, place: int | slice) -> Entry | GridBlock:
        if isinstance(place, slice):
            return GridBlock(self.grid, self.places[place])
        return self.grid.entry(int(self.places[place]))

    @property
    def cells(self) -> GridBlock:
        """What is typed in them: a grid is read as it stands."""
        return self

    @property
    def files(self) -> Sequence[str]:
        """The file of each: the one of the grid."""
        return [self.grid.file] * len(self)

    @property
    def lines(self) -> _Places:
        """The line of each, 0 where there is none."""
        lines, there = np.zeros_like(self.places), self.places >= 0
        lines[there] = self.grid.cells.lines[self.places[there]]
        return lines

    def place(self, entry: int, number: int) -> Place:
        """Where the response to an ask stands in one of them: all in its line."""
        row = int(self.places[entry])
        return Place(self.grid.file, None if row == _NONE else int(self.grid.cells.lines[row]))

    @property
    def width(self) -> int:
        """How many cells each has."""
        return len(self.grid.columns)

    @property
    def rows(self) -> Sequence[Sequence[str]]:
        """Their cells."""
        return [entry.responses for entry in self]

    @cached_property
    def parted(self) -> PartedCells:
        """All their cells."""
        of_rows = self.places[:, None] * self.grid.cells.width + np.array(self.grid.columns)
        cells = of_rows.ravel()
        letters = self.grid.cells.tabulate(cells)
        return PartedCells.of_letters(
            letters, lambda place: self.grid.cells.cell(int(cells[place]))
        )


def choose_block(rows: int) -> int:
    """How many rows of so many are looked at together."""
    return _FEW if rows < _LARGE else _MANY


@dataclass(frozen=True, eq=False)
class GridEntries(Mapping[str, tuple[Entry, ...]]):
    """The entries of students, made as they are asked for; `places` are their rows. Blocks of a
    large class that were gone through are kept until they are asked for, so that each cell is read
    once.
    """

    grid: AnswerGrid
    places: Mapping[str, int]
    kept: dict[bytes, GridBlock] = field(default_factory=dict, repr=False)

    def __getitem__(self, student: str) -> tuple[Entry, ...]:
        return (self.grid.entry(self.places[student]),)

    def __contains__(self, student: object) -> bool:
        return student in self.places

    def __len__(self) -> int:
        return len(self.places)

    def __iter__(self) -> Iterator[str]:
        return iter(self.places)

    def of(self, students: Iterable[str]) -> GridEntries:
        """Those of these students, empty ones of those who have none."""
        listed = [*students]
        if listed == [*self.places]:  # as in most sheets, which `generate` wrote
            return self
        rows = map(self.places.get, listed, repeat(_NONE))
        return GridEntries(self.grid, dict(zip(listed, rows, strict=True)))

    def block(self, students: Sequence[str]) -> GridBlock:
        """Those of these students one after the other."""
        found = map(self.places.__getitem__, students)
        places = np.fromiter(found, dtype=np.intp, count=len(students))
        return self.kept.pop(places.tobytes(), None) or GridBlock(self.grid, places)

    def blocks(self) -> Iterator[GridBlock]:
        """All of them in blocks."""
        places = np.array([*self.places.values()], dtype=np.intp)
        size = choose_block(len(places))
        for begin in range(0, len(places), size):
            block = GridBlock(self.grid, places[begin : begin + size])
            if len(places) >= _LARGE:
                self.kept[block.places.tobytes()] = block
            yield block
