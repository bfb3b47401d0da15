"""The fast twin of `typed.answers.read`: all cells of many rows read at once, plain numbers in bulk
and all other cells by `read`.

`block_judge` uses it. A cell is plain if `read` would take its digits as they stand, whatever else
is in the file.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import chain
from math import isfinite, nan

import msgspec
import numpy as np

from kinegrade.exam.folder.keys import Ask
from kinegrade.grading.fast.bounds import Flags, Numbers
from kinegrade.grading.typed.answers import PLAIN, Reading, read
from kinegrade.grading.typed.cell_block import CellBlock
from kinegrade.grading.typed.decimal_style import FileStyle
from kinegrade.grading.typed.number_text import DecimalStyle
from kinegrade.numbers.decimals import FEW_DIGITS

_PLAIN = re.compile(PLAIN)
_PLAIN_LINES = re.compile(f"(?:(?:{PLAIN})?\n)*+")


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
        plain = block.plain if _takes_plain_numbers(self.styles.style) else None
        if plain is not None:
            decimals = plain.letters.lengths <= FEW_DIGITS
            return TypedCells(self, plain, plain.values, decimals, plain, {}, {})
        return self._row_by_row(block.rows, [*chain.from_iterable(block.rows)])

    def _row_by_row(self, rows: Sequence[Sequence[str]], typed: Sequence[str]) -> TypedCells:
        usual = _takes_plain_numbers(self.styles.style)
        values: list[float] = []
        read_as: list[str] = []
        readings: dict[int, Reading] = {}
        styles: dict[int, DecimalStyle] = {}
        for number, row in enumerate(rows):
            if usual and _are_plain(row):
                values += _read_plain(row).tolist()
                read_as += _drop_signs(row)
                continue
            styles[number] = self.styles.of_row(row)
            for place, (value, digits, reading) in enumerate(
                self._cell_by_cell(row, styles[number]), len(values)
            ):
                values.append(value)
                read_as.append(digits)
                if reading is not None:
                    readings[place] = reading
        decimals = _are_short(typed)
        for place, reading in readings.items():
            value = values[place]
            decimals[place] = isfinite(value) and Fraction(repr(value)) == reading.value
        return TypedCells(self, typed, np.array(values), decimals, read_as, readings, styles)

    def _cell_by_cell(
        self, row: Sequence[str], style: DecimalStyle
    ) -> list[tuple[float, str, Reading | None]]:
        plain = _takes_plain_numbers(style)
        found: list[tuple[float, str, Reading | None]] = []
        for cell, ask in zip(row, self.asks, strict=True):
            if not cell:
                found.append((nan, "", None))
            elif plain and _PLAIN.fullmatch(cell):
                found.append((float(cell), cell.removeprefix("+"), None))
            else:
                reading = read(cell, ask.unit, style, ask.convention, ask.sign)
                known = reading.value is not None and not reading.error
                found.append(
                    (float(reading.value or 0) if known else nan, reading.read_as, reading)
                )
        return found


def _are_plain(cells: Sequence[str]) -> bool:
    """Whether all cells are plain or empty."""
    lines = "\n".join([*cells, ""])
    return lines.count("\n") == len(cells) and _PLAIN_LINES.fullmatch(lines) is not None


def _are_short(cells: Sequence[str]) -> Flags:
    """Which plain or empty cells have few digits."""
    return np.array([*map(len, cells)], dtype=np.intp) <= FEW_DIGITS


def _drop_signs(cells: Sequence[str]) -> Sequence[str]:
    return [cell.removeprefix("+") for cell in cells] if "+" in "".join(cells) else cells


def _read_plain(cells: Sequence[str]) -> Numbers:
    """The values of plain or empty cells; written as in JSON, as most are, they are read several
    times faster.
    """
    filled = [*filter(None, cells)]
    try:
        read = msgspec.convert(filled, list[float], strict=False)
    except msgspec.ValidationError:
        read = [*map(float, filled)]
    if len(filled) == len(cells):
        return np.array(read, dtype=np.float64)
    values = np.full(len(cells), nan)
    values[[bool(cell) for cell in cells]] = read
    return values


def _takes_plain_numbers(style: DecimalStyle) -> bool:
    """Whether 1.234 is a plain number that needs no remark."""
    return style.point == "decimal" and not style.point_reason
