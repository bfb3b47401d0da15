"""The commonest answers that are no plain numbers, as numbers in double precision: those with a
comma or a unit, and the root of a number. Whoever needs the whole reading of one has it read.

`typed_cells` uses it.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from fractions import Fraction
from math import isfinite, isqrt, nan, sqrt
from typing import NamedTuple

from kinegrade.exam.folder.asks import Ask
from kinegrade.grading.typed.answers import Reading, read_behind
from kinegrade.grading.typed.number_and_unit import split_unit
from kinegrade.grading.typed.number_text import DecimalStyle
from kinegrade.numbers.decimals import FEW_DIGITS

_NUMBER = rf"([0-9]{{1,{FEW_DIGITS}}})(?:\.([0-9]{{1,{FEW_DIGITS}}}))?"
_ROOT = re.compile(rf"(-?)(?:√{_NUMBER}|(?:√|sqrt)\({_NUMBER}\))")
_WHOLE = 2**53  # below it, every whole number is a double
_SHOWN = 12  # digits of what an irrational answer is read as
_LEAST, _MOST = 1e-4, 1e11  # between them, so many digits are written without a power of ten
_TIE, _NEAR = 500, 10  # of the three digits behind them: nothing certain is so near to a half


class ReadCell(NamedTuple):
    """A cell: the double nearest to its number, NaN where it has none, and what it is read as;
    `is_decimal` where that is certainly next to a decimal of few digits. A number that is not known
    `exactly` is known to many more digits than a double has. The whole reading stands beside it
    where it was worked out.
    """

    value: float
    read_as: str
    exactly: bool
    is_decimal: bool
    reading: Reading | None = None

    @classmethod
    def of(cls, reading: Reading) -> ReadCell:
        """A cell that was read whole."""
        exactly = reading.value is not None and not reading.error
        value = float(reading.value) if reading.value else nan
        if exactly and reading.value == 0:
            value = 0.0
        is_decimal = exactly and isfinite(value) and Fraction(repr(value)) == reading.value
        return cls(value, reading.read_as, exactly, is_decimal, reading)

    @classmethod
    def plain(cls, number: str) -> ReadCell:
        """A number in plain digits."""
        return cls(float(number), number, True, len(number) <= FEW_DIGITS)


def list_values(cells: Iterable[ReadCell]) -> list[float]:
    """The numbers that are known exactly, NaN for others."""
    return [cell.value if cell.exactly else nan for cell in cells]


def list_readings(cells: Mapping[int, ReadCell]) -> dict[int, Reading]:
    """The readings of those that were read whole, by place."""
    return {place: cell.reading for place, cell in cells.items() if cell.reading is not None}


BLANK = ReadCell(nan, "", exactly=True, is_decimal=True)


def glance(typed: str, ask: Ask, style: DecimalStyle) -> ReadCell | None:
    """The number in a cell, where it needs no remark; None where it takes more than a glance. In
    the style, 1.234 is a plain number.
    """
    parted = split_unit(typed, style)
    if parted is None:
        return _glance_at_root(typed)
    behind = read_behind(parted.sign, parted.rest, ask.unit, ask.convention, ask.sign)
    if behind is None or not behind.keeps_number:
        return None
    return ReadCell.plain(parted.digits)


def _glance_at_root(typed: str) -> ReadCell | None:
    """The irrational root of a number of few digits."""
    found = _ROOT.fullmatch(typed)
    if found is None:
        return None
    sign, *groups = found.groups("")
    decimals = groups[1] or groups[3]
    zero = "0" if len(decimals) % 2 else ""
    square = int(f"{groups[0] or groups[2]}{decimals}{zero}")
    if square >= _WHOLE or isqrt(square) ** 2 == square:
        return None
    root = sqrt(square) / 10.0 ** (len(decimals + zero) // 2)
    behind = int(f"{root:.14e}"[_SHOWN + 1 : _SHOWN + 4])
    if not _LEAST < root < _MOST or abs(behind - _TIE) < _NEAR:
        return None
    value = -root if sign else root
    return ReadCell(value, f"{value:.{_SHOWN}g}", exactly=False, is_decimal=False)
