"""The table of a vector equation: under each term its magnitude and its direction. A long equation
has narrower columns, whose texts are broken into lines, formulas before a relation; a longer one
goes on in a second band of columns.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from math import ceil
from re import fullmatch

from kinegrade.language.math.equation_line import begins_with_sign, split_equation_line
from kinegrade.language.math.printed_size import measure_printed
from kinegrade.language.math.tree import Mark, Row
from kinegrade.press.solutions.chains import FORMULA_ALONE
from kinegrade.press.solutions.prose_size import measure_text
from kinegrade.worked.document import Term, TermTable, list_formulas

EM = 3.175  # millimetres: text of 9 points
_LIMITS = (1000.0, 34.0, 28.0, 23.0, 18.0)  # millimetres that a cell may be wide
_SYMBOL_SIZE = 1.15  # of the text
_NARROWEST = 7.0
_BETWEEN = 6.8  # millimetres that sign and gaps take with each term
_LABELS = 17.0  # millimetres of the column that says "magnitude" and "direction"
_HEAD, _ROW, _LINE = 6.4, 1.2, 3.6  # millimetres: the symbols, a row without its lines, a line
_ROOM = 5.2  # millimetres above and below the two rows under the symbols, as in the layouts


@dataclass(frozen=True)
class Cell:
    """What stands under a term: formulas one below another, or words that are broken as needed."""

    text: str  # prose, "" where there are formulas
    formulas: tuple[Row, ...]
    width: float  # millimetres
    lines: int


@dataclass(frozen=True)
class TermColumn:
    """A term with its cells and its width in millimetres."""

    term: Term
    magnitude: Cell
    direction: Cell

    @property
    def width(self) -> float:
        """Millimetres between the signs on both sides."""
        symbol = _SYMBOL_SIZE * measure_printed(self.term.symbol).width * EM
        return max(_NARROWEST, symbol, self.magnitude.width, self.direction.width)


Band = tuple[TermColumn, ...]


@lru_cache(maxsize=1024)
def arrange_terms(table: TermTable, room: float) -> tuple[Band, ...]:
    """The columns of a table that has `room` millimetres, in as few bands as have room; the bands
    are about equally long.
    """
    terms = table.terms
    for count in range(1, len(terms) + 1):
        size = ceil(len(terms) / count)
        for limit in _LIMITS:
            columns = [_set_column(term, limit) for term in terms]
            bands = [tuple(columns[at : at + size]) for at in range(0, len(terms), size)]
            if all(_find_width(band) <= room for band in bands):
                return tuple(bands)
    return tuple((_set_column(term, _LIMITS[-1]),) for term in terms)


def find_bands_height(bands: Sequence[Band], spread: float = 1.0) -> float:
    """Millimetres that the bands of a table take with that share of the usual room in cells."""
    return sum(_find_height(band) - (1 - spread) * _ROOM for band in bands)


def _find_height(band: Band) -> float:
    rows = ([column.magnitude for column in band], [column.direction for column in band])
    return _HEAD + sum(_ROW + _LINE * max(cell.lines for cell in row) for row in rows)


def _find_width(band: Band) -> float:
    return _LABELS + sum(column.width + _BETWEEN for column in band)


def _set_column(term: Term, limit: float) -> TermColumn:
    return TermColumn(term, _set_cell(term.magnitude, limit), _set_cell(term.direction, limit))


@lru_cache(maxsize=4096)
def _set_cell(text: str, limit: float) -> Cell:
    formulas = list_formulas(text)
    if formulas and fullmatch(FORMULA_ALONE, text):
        return _set_formula(formulas[0], limit)
    width = measure_text(text) * EM
    return Cell(text, (), min(width, limit), ceil(width / limit))


def _set_formula(formula: Row, limit: float) -> Cell:
    """A formula on one line, or broken before its relations."""
    lines: list[Row] = [formula]
    if measure_printed(formula).width * EM > limit:
        lines = []
        for piece in split_equation_line((Mark(), *formula)).pieces:
            if lines and begins_with_sign(piece):
                lines[-1] = (*lines[-1], *piece)
            else:
                lines.append(piece)
    width = max(measure_printed(line).width for line in lines)
    return Cell("", tuple(lines), width * EM, len(lines))
