"""Cells parted into those that are plain numbers or blank, most of most files, and the others."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import overload

import numpy as np
from numpy.typing import NDArray

from kinegrade.files.rows.letter_table import LetterTable, tabulate_letters
from kinegrade.grading.typed.plain_cells import PlainCells


@dataclass(frozen=True, slots=True, eq=False)
class PartedCells(Sequence[str]):
    """Cells that are `plain`, where the `others`, by place in their order, are blank."""

    plain: PlainCells
    others: Mapping[int, str]

    @classmethod
    def of(cls, cells: Sequence[str]) -> PartedCells | None:
        """These cells; None where one has a line break or a zero."""
        letters = tabulate_letters(cells)
        return None if letters is None else cls.of_letters(letters, cells.__getitem__)

    @classmethod
    def of_letters(cls, letters: LetterTable, text: Callable[[int], str]) -> PartedCells:
        """The cells with these letters, and the text of each that is not plain."""
        plain, others = PlainCells.part(letters)
        return cls(plain, {place: text(place) for place in others.tolist()})

    def __len__(self) -> int:
        return len(self.plain)

    def find_filled(self) -> NDArray[np.bool_]:
        """Which cells are not blank."""
        found: NDArray[np.bool_] = self.plain.letters.lengths > 0
        found[[*self.others]] = True
        return found

    @overload
    def __getitem__(self, place: int) -> str: ...

    @overload
    def __getitem__(self, place: slice) -> Sequence[str]: ...

    def __getitem__(self, place: int | slice) -> str | Sequence[str]:
        if isinstance(place, slice):
            return [self[each] for each in range(*place.indices(len(self)))]
        return self.others.get(place) or self.plain[place]

    def __iter__(self) -> Iterator[str]:
        cells = [*self.plain]
        for place, text in self.others.items():
            cells[place] = text
        return iter(cells)
