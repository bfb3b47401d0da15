"""The equations of a display in as few rows as the room allows, one below another, aligned at the
first relation: short ones stand side by side, a long one is broken before a relation, then before a
sign.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from kinegrade.language.math.printed_size import measure_printed
from kinegrade.language.math.tree import Mark, Row, Space, Text
from kinegrade.press.equation_line import (
    EquationLine,
    begins_with_relation,
    begins_with_sign,
    split_equation_line,
)

_APART = Space("qquad")  # between two equations on one row
_INDENT: Row = (Space("quad"), Text(""))  # before a row that goes on with a sign
_APART_WIDTH = 2.0
_INDENT_WIDTH = 1.3
# Of the room: what is longer on the left of its relation is not aligned with others
_LONG_LEFT = 0.2
_ROW_GAP = 0.5


@dataclass(frozen=True)
class Equations:
    """Rows aligned with each other at the marks they hold; a piece may be too wide for the room."""

    rows: tuple[Row, ...]
    fits: bool

    @property
    def height(self) -> float:
        """What the rows take of a page, in em."""
        return sum(map(_find_height, self.rows)) + _ROW_GAP * (len(self.rows) - 1)


def _find_height(row: Row) -> float:
    return measure_printed(row).height


@dataclass(frozen=True)
class _Line:
    """An equation with the widths of its left and right side, in em."""

    parts: EquationLine
    left: float
    right: float


def arrange_equations(lines: Sequence[Row], room: float) -> tuple[Equations, ...]:
    """The rows of a display that has `room` em: one group or, where lines have a long left side,
    several.

    >>> from kinegrade.language.math.reading import read_math
    >>> short = [read_math("x_A &= 0", ""), read_math("y_A &= 1", "")]
    >>> [len(arrange_equations(short, room)[0].rows) for room in (40.0, 6.0)]
    [1, 2]
    """
    groups: list[Equations] = []
    aligned: list[_Line] = []
    for line in map(_measure_line, _join_continued(lines)):
        if line.left > _LONG_LEFT * room:
            groups.extend(_align(aligned, room))
            groups.append(_hang(line, room))
            aligned = []
        else:
            aligned.append(line)
    return (*groups, *_align(aligned, room))


def _join_continued(lines: Sequence[Row]) -> Iterator[EquationLine]:
    """The equations of a display; a line that goes on with a relation belongs to the one before."""
    open_line: EquationLine | None = None
    for parts in map(split_equation_line, lines):
        continued = not parts.left and parts.pieces and begins_with_relation(parts.pieces[0])
        if open_line is not None and continued:
            open_line = EquationLine(open_line.left, open_line.pieces + parts.pieces)
            continue
        if open_line is not None:
            yield open_line
        open_line = parts
    if open_line is not None:
        yield open_line


def _measure_line(parts: EquationLine) -> _Line:
    return _Line(parts, _find_width(parts.left), _find_width(_join(parts.pieces)))


def _join(pieces: Sequence[Row]) -> Row:
    return tuple(node for piece in pieces for node in piece)


def _find_width(row: Row) -> float:
    return measure_printed(row).width


def _align(lines: Sequence[_Line], room: float) -> Iterator[Equations]:
    """Equations aligned with each other, as many on a row as have room."""
    if not lines:
        return
    column = max(line.left for line in lines)
    rows: list[Row] = []
    used, fits = room, True
    for line in lines:
        whole = _join(line.parts.pieces)
        if rows and used + _APART_WIDTH + line.left + line.right <= room:
            rows[-1] = (*rows[-1], _APART, *line.parts.left, *whole)
            used += _APART_WIDTH + line.left + line.right
            continue
        broken = [whole]
        if column + line.right > room:
            broken = list(_break(line.parts.pieces, room - column))
            fits = fits and all(_find_width(row) <= room - column for row in broken)
        first, *others = broken or [()]
        rows.append((*line.parts.left, Mark(), *first))
        rows.extend((Mark(), *row) for row in others)
        used = column + line.right if not others else room
    yield Equations(tuple(rows), fits)


def _hang(line: _Line, room: float) -> Equations:
    """An equation with a long left side by itself, its further rows set back."""
    if line.left + line.right <= room:
        return Equations(((*line.parts.left, Mark(), *_join(line.parts.pieces)),), fits=True)
    left = split_equation_line((Mark(), *line.parts.left)).pieces
    rows = list(_break(left, room)) + list(
        _break(line.parts.pieces, room - _INDENT_WIDTH, set_back=True)
    )
    fits = all(_find_width(row) <= room for row in rows)
    return Equations(tuple((Mark(), *row) for row in rows), fits)


def _break(pieces: Sequence[Row], room: float, *, set_back: bool = False) -> Iterator[Row]:
    """The pieces in as few rows as the room allows. A row that goes on with a sign is set back, and
    holds no relation.
    """
    row: Row = ()
    within_sum = False
    for piece in pieces:
        joined = (*row, *piece)
        ended = within_sum and not begins_with_sign(piece)
        if row and (ended or _find_width(joined) > room):
            yield row
            within_sum = begins_with_sign(piece)
            joined = (*_INDENT, *piece) if within_sum or set_back else piece
        elif not row and set_back:
            joined = (*_INDENT, *piece)
        row = joined
    if row:
        yield row
