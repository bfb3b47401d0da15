"""The fast twin of `typed.answers.read`: all cells of many rows read at once, plain numbers in bulk
and all other cells by `read`.

`block_judge` uses it. A cell is plain if `read` would take its digits as they stand, whatever else
is in the file.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain, groupby
from typing import assert_never

import numpy as np

from kinegrade.exam.folder.asks import Ask
from kinegrade.grading.fast.bounds import Flags, Numbers
from kinegrade.grading.fast.glanced_numbers import (
    BLANK,
    ReadCell,
    glance,
    list_readings,
    list_values,
)
from kinegrade.grading.typed.answers import PLAIN, Reading, read
from kinegrade.grading.typed.cell_block import CellBlock
from kinegrade.grading.typed.decimal_style import FileStyle, join_evidence, show_evidence
from kinegrade.grading.typed.number_text import DecimalStyle
from kinegrade.grading.typed.parted_cells import PartedCells
from kinegrade.numbers.decimals import FEW_DIGITS

_PLAIN = re.compile(PLAIN)


@dataclass(frozen=True, slots=True)
class TypedCells:
    """Cells row after row: `values` are NaN where no number is typed, or none that is known
    exactly, and next to decimals of few digits where those are `decimals`. By `compared`, which has
    the others too, irrational numbers are compared.

    `readings` are those of the cells that took more than a glance, by place; `styles` are those of
    the rows with cells that are neither plain nor empty, by row.
    """

    reader: CellReader
    typed: Sequence[str]
    values: Numbers
    compared: Numbers
    decimals: Flags
    read_as: Sequence[str]
    readings: Mapping[int, Reading]
    styles: Mapping[int, DecimalStyle]

    @property
    def are_plain(self) -> bool:
        """Whether all cells are plain or empty, and read as they stand."""
        return self.read_as is self.typed

    @property
    def are_filled(self) -> Flags:
        """Which cells are not blank."""
        match self.typed:
            case PartedCells():
                return self.typed.find_filled()
            case Sequence():
                return np.array([*map(bool, self.typed)], dtype=np.bool_)
            case _:
                assert_never(self.typed)

    def reading(self, place: int) -> Reading:
        """The reading of a cell."""
        return self.readings.get(place) or self.reread(place, self.typed[place])

    def reread(self, place: int, typed: str) -> Reading:
        """The reading of another text, as if it stood in the cell."""
        row, number = divmod(place, len(self.reader.asks))
        ask, style = self.reader.asks[number], self.styles.get(row, self.reader.styles.style)
        return read(typed, ask.unit, style, ask.convention, ask.sign)


@dataclass(frozen=True, slots=True)
class CellReader:
    """Reads the cells of rows that answer these asks, in a file of that style."""

    asks: tuple[Ask, ...]
    styles: FileStyle

    def cells(self, block: CellBlock) -> TypedCells:
        """All cells of these rows."""
        parted = block.parted if _takes_plain_numbers(self.styles.style) else None
        if parted is None:
            return self._row_by_row(block.rows, [*chain.from_iterable(block.rows)])
        decimals = parted.plain.letters.lengths <= FEW_DIGITS
        if not parted.others:
            values = parted.plain.values
            return TypedCells(self, parted, values, values, decimals, parted, {}, {})
        return self._among_plain(parted, decimals)

    def _among_plain(self, parted: PartedCells, decimals: Flags) -> TypedCells:
        """Cells of which some are not plain: those alone are read, each by the style of its row,
        and all of a row in whose style plain numbers are not what they seem.
        """
        width, plain = len(self.asks), parted.plain
        points: Flags = np.any(plain.find_decimals().reshape(-1, width), axis=1)
        typed, cells = dict[int, str](), dict[int, ReadCell]()
        styles: dict[int, DecimalStyle] = {}
        for row, places in groupby(parted.others, lambda place: place // width):
            listed: Iterable[int] = [*places]
            shown = [show_evidence(parted.others[place]) for place in listed]
            style = self.styles.of_evidence(join_evidence(shown, point=bool(points[row])))
            styles[row] = style
            if not _takes_plain_numbers(style):
                every = range(row * width, (row + 1) * width)
                listed = [place for place in every if parted[place]]
            for place in listed:
                typed[place] = parted[place]
                cells[place] = self._read(place, typed[place], style)
        values, compared = plain.values.copy(), plain.values.copy()
        read = [*cells.values()]
        where = np.fromiter(cells, dtype=np.intp, count=len(cells))
        values[where], compared[where] = list_values(read), [cell.value for cell in read]
        decimals[where] = [cell.is_decimal for cell in read]
        digits = {place: cell.read_as for place, cell in cells.items()}
        return TypedCells(
            *(self, PartedCells(plain, typed), values, compared, decimals),
            *(PartedCells(plain, digits), list_readings(cells), styles),
        )

    def _row_by_row(self, rows: Sequence[Sequence[str]], typed: Sequence[str]) -> TypedCells:
        """Cells that are read one by one."""
        read: list[ReadCell] = []
        styles: dict[int, DecimalStyle] = {}
        for number, row in enumerate(rows):
            styles[number] = self.styles.of_row(row)
            for place, cell in enumerate(row, len(read)):
                read.append(self._read(place, cell, styles[number]))
        values, compared = (
            np.array(each, dtype=np.float64)
            for each in (list_values(read), [cell.value for cell in read])
        )
        decimals = np.array([cell.is_decimal for cell in read], dtype=np.bool_)
        digits, readings = [cell.read_as for cell in read], list_readings(dict(enumerate(read)))
        return TypedCells(self, typed, values, compared, decimals, digits, readings, styles)

    def _read(self, place: int, cell: str, style: DecimalStyle) -> ReadCell:
        """A cell in a row of that style."""
        if not cell:
            return BLANK
        ask = self.asks[place % len(self.asks)]
        if _takes_plain_numbers(style):
            if _PLAIN.fullmatch(cell):
                return ReadCell.plain(cell.removeprefix("+"))
            glanced = glance(cell, ask, style)
            if glanced is not None:
                return glanced
        return ReadCell.of(read(cell, ask.unit, style, ask.convention, ask.sign))


def _takes_plain_numbers(style: DecimalStyle) -> bool:
    """Whether 1.234 is a plain number that needs no remark."""
    return style.point == "decimal" and not style.point_reason
