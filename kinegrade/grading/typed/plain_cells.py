"""Cells that are plain numbers such as -12.5, or blank: told from all others and read thousands at
once, as most cells of most files are such.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import overload

import numpy as np
from numpy.typing import NDArray

from kinegrade.files.rows.letter_table import LONGEST, LetterTable
from kinegrade.numbers.decimals import FEW_DIGITS

_BLANK, _MINUS, _POINT, _ZERO = b"\0-.0"
_SCALES = np.array([1.0, 10.0])  # of what stands before a letter, and before a digit
_TENS = 10.0 ** np.arange(LONGEST)

_Flags = NDArray[np.bool_]
_Numbers = NDArray[np.float64]
_Places = NDArray[np.intp]


@dataclass(frozen=True, slots=True, eq=False)
class PlainCells(Sequence[str]):
    """Cells, each a sign or none, digits, and a point with digits or none, or blank.

    Where they have a point, so many digits stand `behind` it; `values` are NaN where they are
    blank.
    """

    letters: LetterTable
    has_point: _Flags
    behind: _Places
    values: _Numbers

    @classmethod
    def part(cls, letters: LetterTable) -> tuple[PlainCells, _Places]:
        """The cells with these letters, and the places of those that are anything else, where they
        are blank.
        """
        columns = np.ascontiguousarray(letters.table.T)
        digits = columns - _ZERO  # below zero they begin again from the highest
        are_digits = digits < 10
        are_others = ~_are_numbers(columns, are_digits)
        are_others[letters.longer] = True
        others = np.flatnonzero(are_others)
        if len(others):
            for table in (letters.table.T, columns, are_digits):
                table[:, others] = 0
            letters.lengths[others] = 0
        count = len(letters.lengths)
        has_point, places = np.zeros(count, dtype=np.bool_), np.zeros(count, dtype=np.uint8)
        whole = np.zeros(count)
        for column, digit, is_digit in zip(columns, digits, are_digits, strict=True):
            whole *= _SCALES[is_digit.view(np.uint8)]
            whole += digit * is_digit
            places += is_digit & has_point
            has_point |= column == _POINT
        # Both are whole numbers that doubles hold, so that the quotient is rightly rounded
        behind = places.astype(np.intp)
        values = np.copysign(whole / _TENS[behind], np.where(columns[0] == _MINUS, -1.0, 1.0))
        values[letters.lengths == 0] = np.nan
        found = cls(letters, has_point, behind, values)
        for place in np.flatnonzero(letters.lengths > FEW_DIGITS).tolist():
            values[place] = float(found[place])
        return found, others

    def __len__(self) -> int:
        return len(self.values)

    @overload
    def __getitem__(self, place: int) -> str: ...

    @overload
    def __getitem__(self, place: slice) -> Sequence[str]: ...

    def __getitem__(self, place: int | slice) -> str | Sequence[str]:
        if isinstance(place, slice):
            return [text.decode("ascii") for text in self.letters.texts[place].tolist()]
        return bytes(self.letters.texts[place]).decode("ascii")

    def __iter__(self) -> Iterator[str]:
        return iter(self[:])

    def find_decimals(self) -> _Flags:
        """Which cells have a point that certainly stands before decimals: it does not where three
        digits stand behind it, and before it one to three that are not a lone zero.
        """
        table, lengths = self.letters.table, self.letters.lengths
        signs = table[:, 0] == _MINUS
        before = lengths - self.behind - 1 - signs
        first = table[np.arange(len(table)), signs.astype(np.intp) % table.shape[1]]
        alone = (before == 1) & (first == _ZERO)
        found: _Flags = self.has_point & ((self.behind != 3) | (before > 3) | alone)
        return found


def _are_numbers(columns: NDArray[np.uint8], is_digit: _Flags) -> _Flags:
    """Of which cells a sign stands before digits alone, and one point at most, between digits;
    `columns` have a letter of each cell.
    """
    is_sign, is_point = columns == _MINUS, columns == _POINT
    found: _Flags = (is_digit | is_sign | is_point | (columns == _BLANK)).all(axis=0)
    found &= ~is_sign[1:].any(axis=0) & ~(is_sign[0] & ~is_digit[1 % len(columns)])
    found &= ~(is_point[0] | is_point[-1])
    found &= ~(is_point[1:-1] & ~(is_digit[:-2] & is_digit[2:])).any(axis=0)
    found &= is_point.sum(axis=0, dtype=np.uint8) < 2
    return found
