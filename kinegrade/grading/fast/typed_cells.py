"""The fast twin of `typed.answers.read`: all cells of many rows read at once, plain numbers in bulk
and all other cells by `read`.

`block_judge` uses it. A cell is plain if `read` would take its digits as they stand, whatever else
is in the file.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import chain, groupby
from math import isfinite, nan

import numpy as np

from kinegrade.exam.folder.keys import Ask
from kinegrade.grading.fast.bounds import Flags, Numbers
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
    exactly, and next to decimals of few digits where those are `decimals`.

    `readings` are those of the cells that are neither plain nor empty, by place; `styles` are those
    of the rows with such cells, by row.
    """

    reader: CellReader
    typed: Sequence[str]
    values: Numbers
    decimals: Flags
    read_as: Sequence[str]
    readings: Mapping[int, Reading]
    styles: Mapping[int, DecimalStyle]

    @property
    def are_plain(self) -> bool:
        """Whether all cells are plain or empty, and read as they stand."""
        return self.read_as is self.typed

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
            return TypedCells(self, parted, parted.plain.values, decimals, parted, {}, {})
        return self._among_plain(parted, decimals)

    def _among_plain(self, parted: PartedCells, decimals: Flags) -> TypedCells:
        """Cells of which some are not plain: those alone are read, each by the style of its row,
        and all of a row in whose style plain numbers are not what they seem.
        """
        width, values = len(self.asks), parted.plain.values.copy()
        points: Flags = np.any(parted.plain.find_decimals().reshape(-1, width), axis=1)
        typed, read_as = dict[int, str](), dict[int, str]()
        readings: dict[int, Reading] = {}
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
                value, read_as[place], reading = self._read(place, typed[place], style)
                values[place], decimals[place] = value, len(typed[place]) <= FEW_DIGITS
                if reading is not None:
                    readings[place] = reading
                    decimals[place] = _is_decimal(value, reading)
        plain = parted.plain
        texts, digits = PartedCells(plain, typed), PartedCells(plain, read_as)
        return TypedCells(self, texts, values, decimals, digits, readings, styles)

    def _row_by_row(self, rows: Sequence[Sequence[str]], typed: Sequence[str]) -> TypedCells:
        """Cells that are read one by one."""
        values: list[float] = []
        read_as: list[str] = []
        readings: dict[int, Reading] = {}
        styles: dict[int, DecimalStyle] = {}
        for number, row in enumerate(rows):
            styles[number] = self.styles.of_row(row)
            for place, cell in enumerate(row, len(values)):
                value, digits, reading = self._read(place, cell, styles[number])
                values.append(value)
                read_as.append(digits)
                if reading is not None:
                    readings[place] = reading
        decimals = np.array([*map(len, typed)], dtype=np.intp) <= FEW_DIGITS
        for place, reading in readings.items():
            decimals[place] = _is_decimal(values[place], reading)
        return TypedCells(self, typed, np.array(values), decimals, read_as, readings, styles)

    def _read(
        self, place: int, cell: str, style: DecimalStyle
    ) -> tuple[float, str, Reading | None]:
        """The value of a cell, NaN where it is not known exactly, what it is read as, and how it is
        read where it is neither plain nor empty.
        """
        if not cell:
            return nan, "", None
        if _takes_plain_numbers(style) and _PLAIN.fullmatch(cell):
            return float(cell), cell.removeprefix("+"), None
        ask = self.asks[place % len(self.asks)]
        reading = read(cell, ask.unit, style, ask.convention, ask.sign)
        known = reading.value is not None and not reading.error
        return float(reading.value or 0) if known else nan, reading.read_as, reading


def _is_decimal(value: float, reading: Reading) -> bool:
    """Whether the double that was read is next to a decimal of few digits."""
    return isfinite(value) and Fraction(repr(value)) == reading.value


def _takes_plain_numbers(style: DecimalStyle) -> bool:
    """Whether 1.234 is a plain number that needs no remark."""
    return style.point == "decimal" and not style.point_reason
