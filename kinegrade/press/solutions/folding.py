"""What is too wide for a line and holds no place to break it: a fraction, a root or a bracket gets
several lines inside, broken before its signs, so that no letter is made smaller.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import assert_never

from kinegrade.language.math.equation_line import split_equation_line
from kinegrade.language.math.printed_size import measure_printed
from kinegrade.language.math.tree import (
    Accent,
    Environment,
    Fenced,
    Function,
    Group,
    Letter,
    Lettering,
    LineBreak,
    Mark,
    Node,
    Number,
    Quotient,
    Root,
    Row,
    Scripts,
    Sign,
    Space,
    Text,
    Unit,
)

_APART = Space("quad")  # before a remark on a value
_TERM_BEFORE = Text("")  # a sign after it stands between two terms, also at the start of a line


def fold(row: Row, room: float) -> Row:
    r"""The row at most `room` em wide, as far as there are signs to break it.

    >>> from kinegrade.language.math.plain import write_plain_row
    >>> from kinegrade.language.math.reading import read_math
    >>> quotient = read_math(r"= \frac{aaaa + bbbb}{c}", "")
    >>> fold(quotient, 99.0) == quotient, fold(quotient, 5.0)[1].above[0].row.count(LineBreak())
    (True, 1)
    """
    excess = _measure(row) - room
    if excess <= 0:
        return row
    widths = [_measure((node,)) for node in row]
    for place in sorted(range(len(row)), key=lambda place: -widths[place]):
        folded = _fold_node(row[place], widths[place] - excess)
        row = (*row[:place], folded, *row[place + 1 :])
        excess = _measure(row) - room
        if excess <= 0:
            return row
    return row


def part_remark(row: Row) -> Iterator[Row]:
    r"""A value, and the remark that stands apart from it.

    >>> from kinegrade.language.math.reading import read_math
    >>> len(list(part_remark(read_math(r"= 3\quad\text{(to the right)}", ""))))
    2
    """
    place = row.index(_APART) if _APART in row else len(row)
    yield from filter(None, (row[:place], row[place + 1 :]))


def _fold_node(node: Node, room: float) -> Node:
    match node:
        case Quotient(name, above, below):
            around = _measure((node,)) - max(_measure(above), _measure(below))
            return Quotient(name, *(_set_lines(part, room - around) for part in (above, below)))
        case Root(radicand, degree):
            return Root(_set_lines(radicand, room - _measure((node,)) + _measure(radicand)), degree)
        case Fenced(left, inside, right):
            room -= _measure((node,)) - _measure(inside)
            return Fenced(left, _set_lines(inside, room), right)
        case Accent() | Environment() | Function() | Group() | Letter() | Lettering():
            return node
        case LineBreak() | Mark() | Number() | Scripts() | Sign() | Space() | Text() | Unit():
            return node
        case _:
            assert_never(node)


def _set_lines(row: Row, room: float) -> Row:
    """The row on as many lines as it takes."""
    if _measure(row) <= room:
        return row
    pieces = [fold(piece, room) for piece in split_equation_line((Mark(), *row)).pieces]
    first, *others = _join_pieces(pieces, room)
    if not others:
        return first
    lines = (node for line in others for node in (LineBreak(), *line))
    return (Environment("aligned", (*first, *lines)),)


def _join_pieces(pieces: Sequence[Row], room: float) -> Iterator[Row]:
    line, *others = pieces
    for piece in others:
        if _measure((*line, *piece)) > room:
            yield line
            line = (_TERM_BEFORE,)
        line = (*line, *piece)
    yield line


def _measure(row: Row) -> float:
    return measure_printed(row).width
