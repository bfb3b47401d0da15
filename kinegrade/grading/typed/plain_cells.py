"""Cells that are plain numbers such as -12.5, or blank: told from all others thousands at once, as
most cells of most files are such.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinegrade.grading.typed.number_text import MOST_DIGITS

_LETTERS = b"0123456789.-\n"
_END, _MINUS, _POINT, _ZERO = b"\n-.0"
_LONGEST = MOST_DIGITS // 2  # letters

_Places = NDArray[np.intp]


@dataclass(frozen=True, slots=True)
class PlainCells:
    """The `letters` of cells, each of which ends with a line break, at `ends`."""

    letters: NDArray[np.uint8]
    ends: _Places

    @classmethod
    def of(cls, cells: Sequence[str]) -> PlainCells | None:
        """The cells, each a sign or none, digits, and a point with digits or none, or blank; None
        where one is anything else.
        """
        text = "\n".join([*cells, ""]).encode("utf-8", "surrogatepass")
        if text.translate(None, _LETTERS):
            return None
        letters = np.frombuffer(text, dtype=np.uint8)
        found = cls(letters, np.flatnonzero(letters == _END))
        return found if len(found.ends) == len(cells) and found._are_numbers() else None

    @property
    def lengths(self) -> _Places:
        """How many letters each cell has."""
        return np.diff(self.ends, prepend=-1) - 1

    def _are_numbers(self) -> bool:
        """Whether signs stand before digits alone, and points between digits, one in a cell."""
        letters, signs, points = self.letters, self._find(_MINUS), self._find(_POINT)
        return bool(
            (self.lengths <= _LONGEST).all()
            and (letters[signs + 1] >= _ZERO).all()
            and (letters[signs[signs > 0] - 1] == _END).all()
            and (letters[points + 1] >= _ZERO).all()
            and (letters[points - 1] >= _ZERO).all()
            and not self._hold_two_points()
        )

    def _hold_two_points(self) -> bool:
        """Whether a point follows another one before the end of a cell."""
        at = self.letters[(self.letters == _POINT) | (self.letters == _END)] == _POINT
        return bool((at[1:] & at[:-1]).any())

    def find_decimals(self) -> NDArray[np.bool_] | None:
        """Which cells have a point that certainly stands before decimals: it does not where three
        digits stand behind it, and before it one to three that are not a lone zero. None where a
        cell of another form has to be looked at.
        """
        points = self._find(_POINT)
        cells = self._find_cells(points)
        begins = np.append(0, self.ends[:-1] + 1)[cells]
        begins = begins + (self.letters[begins] == _MINUS)
        before, behind = points - begins, self.ends[cells] - points - 1
        if ((behind == 3) & (before > 3)).any():
            return None
        alone = (before == 1) & (self.letters[points - 1] == _ZERO)
        found = np.zeros(len(self.ends), dtype=np.bool_)
        found[cells] = (behind != 3) | alone
        return found

    def _find(self, letter: int) -> _Places:
        return np.flatnonzero(self.letters == letter)

    def _find_cells(self, places: _Places) -> _Places:
        """The numbers of the cells in which these letters stand."""
        return np.searchsorted(self.ends, places)
