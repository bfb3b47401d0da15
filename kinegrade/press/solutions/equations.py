"""The equations of a display in as few rows as the room allows, one below another, aligned at the
first relation: short ones stand side by side, a long one is broken before a relation, then before a
sign.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

from kinegrade.language.math.equation_line import (
    EquationLine,
    begins_with_relation,
    begins_with_sign,
    split_equation_line,
)
from kinegrade.language.math.printed_size import measure_printed
from kinegrade.language.math.tree import LineBreak, Mark, Row, Space, Text, list_nodes
from kinegrade.press.solutions.folding import fold, part_remark
from kinegrade.worked.document import Display

_APART = Space("qquad")  # between two equations on one row
_INDENT: Row = (Space("quad"), Text(""))  # before a row that goes on with a sign
_APART_WIDTH = 2.0
_INDENT_WIDTH = 1.3
_BEFORE_SIGN = 0.56  # the room that a sign has when it stands between two terms
# Of the room: what is longer on the left of its relation is not aligned with others
_LONG_LEFT = 0.2
_ROW_GAP = 0.4


@dataclass(frozen=True)
class Equations:
    """Rows aligned at the marks they hold, with their size in em; a piece may be too wide
    for the room.
    """

    rows: tuple[Row, ...]
    width: float
    height: float
    fits: bool

    @cached_property
    def folds(self) -> int:
        """How many lines are added to the row that is folded most."""
        return max(list(list_nodes(row)).count(LineBreak()) for row in self.rows)


@dataclass(frozen=True)
class _Piece:
    """What is not broken, with its size in em."""

    row: Row
    width: float
    height: float
    signed: bool  # adds a term to what is before it

    def __add__(self, other: _Piece) -> _Piece:
        return _Piece(
            self.row + other.row,
            self.width + other.width,
            max(self.height, other.height),
            self.signed,
        )


_NOTHING = _Piece((), 0.0, 0.0, signed=False)
_MARK = _Piece((Mark(),), 0.0, 0.0, signed=False)
_SPACE = _Piece((_APART,), _APART_WIDTH, 0.0, signed=False)
_SET_BACK = _Piece(_INDENT, _INDENT_WIDTH, 0.0, signed=False)


@dataclass(frozen=True)
class _Line:
    """An equation: its left side, and its right side in pieces and whole."""

    left: _Piece
    pieces: tuple[_Piece, ...]
    right: _Piece

    @property
    def width(self) -> float:
        """All of it on one row."""
        return self.left.width + self.right.width


@dataclass(frozen=True, eq=False)  # known by itself, as it is looked up for many rooms
class MeasuredDisplay:
    """The equations of a display, measured once for rooms of any width."""

    lines: tuple[_Line, ...]


@lru_cache(maxsize=512)  # a sheet is arranged twice: as usual, and tighter
def measure_display(display: Display) -> MeasuredDisplay:
    """The equations of a display with their sizes."""
    return MeasuredDisplay(tuple(map(_measure_line, _join_continued(display.lines))))


@lru_cache(maxsize=1024)
def arrange_equations(
    display: MeasuredDisplay, room: float, *, folds: bool = False
) -> tuple[Equations, ...]:
    """The rows of a display that has `room` em: one group or, where lines have a long left side,
    several. A piece that is too wide is folded where it `folds`.

    >>> from kinegrade.language.math.reading import read_math
    >>> short = Display((read_math("x_A &= 0", ""), read_math("y_A &= 1", "")))
    >>> [len(arrange_equations(measure_display(short), room)[0].rows) for room in (40.0, 8.0)]
    [1, 2]
    """
    groups: list[Equations] = []
    aligned: list[_Line] = []
    for line in _fold_lines(display.lines, room) if folds else display.lines:
        if line.left.width > _LONG_LEFT * room:
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
    pieces = tuple(map(_measure_piece, parts.pieces))
    left = _measure_piece(parts.left) if parts.left else _NOTHING
    return _Line(left, pieces, sum(pieces, _NOTHING))


def _measure_piece(row: Row) -> _Piece:
    size, signed = measure_printed(row), begins_with_sign(row)
    return _Piece(row, size.width + signed * _BEFORE_SIGN, size.height, signed)


def _fold_lines(lines: Sequence[_Line], room: float) -> Iterator[_Line]:
    """The lines with pieces that have room beside the left sides, set back or below a long one."""
    short = [line.left.width for line in lines if line.left.width <= _LONG_LEFT * room]
    beside = room - max((_INDENT_WIDTH, *short))
    for line in lines:
        left = fold(line.left.row, room)
        pieces = tuple(row for piece in line.pieces for row in _fold_piece(piece, beside))
        yield line if _is_same(left, pieces, line) else _measure_line(EquationLine(left, pieces))


def _fold_piece(piece: _Piece, beside: float) -> Iterator[Row]:
    """A piece that has so much room, its remark apart where it is wider."""
    room = beside - piece.signed * (_INDENT_WIDTH + _BEFORE_SIGN)
    for part in part_remark(piece.row) if piece.width > beside else [piece.row]:
        yield fold(part, room)


def _is_same(left: Row, pieces: tuple[Row, ...], line: _Line) -> bool:
    """Whether nothing of a line has been folded."""
    return left == line.left.row and pieces == tuple(piece.row for piece in line.pieces)


def _align(lines: Sequence[_Line], room: float) -> Iterator[Equations]:
    """Equations aligned with each other, as many on a row as have room."""
    if not lines:
        return
    column = max(line.left.width for line in lines)
    rows: list[_Piece] = []
    used = room
    for line in lines:
        if rows and used + _APART_WIDTH + line.width <= room:
            rows[-1] += _SPACE + line.left + line.right
            used += _APART_WIDTH + line.width
            continue
        whole = column + line.right.width <= room
        first, *others = [line.right] if whole else _break(line.pieces, room - column)
        rows.append(line.left + _MARK + first)
        rows.extend(_MARK + row for row in others)
        used = room if others else column + line.right.width
    yield _group(rows, room, column)


def _hang(line: _Line, room: float) -> Equations:
    """An equation with a long left side by itself, its further rows set back."""
    if line.width <= room:
        return _group([line.left + _MARK + line.right], room, line.left.width)
    left = split_equation_line((Mark(), *line.left.row)).pieces
    rows = [
        *_break(tuple(map(_measure_piece, left)), room),
        *(_SET_BACK + row for row in _break(line.pieces, room - _INDENT_WIDTH)),
    ]
    return _group([_MARK + row for row in rows], room, 0.0)


def _group(rows: Sequence[_Piece], room: float, column: float) -> Equations:
    """Rows of which those without a left side begin behind a column that wide."""
    width = max(row.width + (column if row.row[0] == Mark() else 0.0) for row in rows)
    height = sum(row.height for row in rows) + _ROW_GAP * (len(rows) - 1)
    return Equations(tuple(row.row for row in rows), width, height, fits=width <= room)


def _break(pieces: Sequence[_Piece], room: float) -> Iterator[_Piece]:
    """The pieces in as few rows as the room allows. A row that goes on with a sign is set back, and
    holds no relation.
    """
    row = _NOTHING
    within_sum = False
    for piece in pieces:
        ended = within_sum and not piece.signed
        if row.row and (ended or row.width + piece.width > room):
            yield row
            within_sum = piece.signed
            row = _SET_BACK if within_sum else _NOTHING
        row += piece
    if row.row:
        yield row
