"""Where a long line of math may be broken: before a relation, or before a plus or minus between two
terms, outside all brackets.

A press breaks a line only where the page is too narrow for it.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from msgspec import Struct

from kinegrade.language.math.spacing import is_sign_of, is_spaced
from kinegrade.language.math.tree import Mark, Row, Sign

_RELATIONS = (
    r"= < > \approx \equiv \sim \le \leq \ge \geq \ne \neq \propto \Rightarrow \implies \to"
)
_BREAKING = frozenset(map(Sign, _RELATIONS.split()))
_SIGNS = frozenset((Sign("+"), Sign("-")))


class EquationLine(Struct, frozen=True):
    """What is to the left of the alignment mark, and the pieces to its right; either may be
    empty.
    """

    left: Row
    pieces: tuple[Row, ...]


def split_equation_line(row: Row) -> EquationLine:
    """The parts of one line of a display.

    >>> from kinegrade.language.math.plain import write_plain_row
    >>> from kinegrade.language.math.reading import read_math
    >>> line = split_equation_line(read_math("v_B &= v_A + (a + b) = 2", "line"))
    >>> write_plain_row(line.left), [write_plain_row(piece) for piece in line.pieces]
    ('v_B', ['= v_A', '+(a + b)', '= 2'])
    """
    start = row.index(Mark()) + 1 if Mark() in row else 0
    left, right = row[: max(start - 1, 0)], row[start:]
    starts = (0, *_find_breaks(right), len(right))
    return EquationLine(
        left, tuple(right[begin:end] for begin, end in pairwise(starts) if begin < end)
    )


def begins_with_sign(piece: Row) -> bool:
    """Whether a piece adds a term to what is before it, rather than stating a relation to it."""
    return piece[0] in _SIGNS


def begins_with_relation(piece: Row) -> bool:
    """Whether a piece states a relation to what is before it."""
    return piece[0] in _BREAKING


def _may_break(sign: Sign, row: Row, place: int) -> bool:
    """Whether a line may be broken before a sign outside all brackets."""
    return sign in _BREAKING or (sign in _SIGNS and is_spaced(row, place))


def _find_breaks(row: Row) -> Iterator[int]:
    """The places of a row before which it may be broken."""
    depth = 0
    for place, node in enumerate(row):
        # Asked first what is no sign: to look up a long node takes time
        if place > 0 and depth == 0 and isinstance(node, Sign) and _may_break(node, row, place):
            yield place
        opened = is_sign_of(node, "opening") - is_sign_of(node, "closing")
        depth = max(depth + opened, 0)
