"""The approximate printed width of a formula, in letters: accurate enough to decide what fits on
a line of a display, or in a column.
"""

from __future__ import annotations

from functools import lru_cache
from typing import assert_never

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
    SpaceName,
    Text,
    Unit,
)

_SPACES: dict[SpaceName, float] = {
    ",": 0.3,
    ":": 0.4,
    ";": 0.5,
    " ": 0.5,
    "!": 0.0,
    "quad": 2.0,
    "qquad": 4.0,
}
_WIDE_SIGNS = frozenset(("+", "-", "=", "<", ">", r"\approx"))
_SMALL = 0.7  # of a subscript relative to the letter that carries it


@lru_cache(maxsize=2048)
def measure_row(row: Row, *, words: bool = True) -> float:
    r"""The width of a formula in letters of its body; without `words`, which other languages have
    shorter or longer, each is one letter.

    >>> from kinegrade.language.math.reading import read_math
    >>> round(measure_row(read_math(r"\frac{a + b}{2}", ""))), measure_row(read_math("x_A", ""))
    (4, 1.7)
    """
    return sum(_measure(node, words) for node in row)


def _measure(node: Node, words: bool) -> float:
    """The width of one node with its parts."""
    match node:
        case Scripts(base, lower, primes, upper):
            carried = 0.0 if base is None else _measure(base, words)
            scripts = measure_row(lower or (), words=words) + measure_row(upper or (), words=words)
            return carried + primes + _SMALL * scripts
        case Quotient(_, above, below):
            return max(measure_row(above, words=words), measure_row(below, words=words)) + 0.5
        case Root(radicand, degree):
            order = _SMALL * measure_row(degree or (), words=words)
            return 1 + measure_row(radicand, words=words) + order
        case Fenced(left, row, right):
            return 2.0 - (left, right).count(".") + measure_row(row, words=words)
        case Group(row) | Lettering(_, row) | Accent(_, row) | Environment(_, row):
            return measure_row(row, words=words)
        case _:
            return _measure_alone(node, words)


def _measure_alone(
    node: Letter | Number | Sign | Function | Text | Unit | Space | LineBreak | Mark, words: bool
) -> float:
    """The width of a node without parts."""
    match node:
        case Number(text):
            return float(len(text))
        case Text(text):
            return float(len(text) - text.count(" ")) if words else 1.0
        case Unit(text):
            return float(len(text) - text.count("^"))
        case Function(name):
            return len(name) + 0.5
        case Sign(latex):
            return 1.9 if latex in _WIDE_SIGNS else 1.0
        case Space(name):
            return _SPACES[name]
        case Letter() | LineBreak():
            return 1.0
        case Mark():
            return 0.0
        case _:
            assert_never(node)
