"""What of a formula is heard as one thing, so that its end need not be said."""

from __future__ import annotations

from typing import assert_never

from kinegrade.language.math.letters import SIGNS
from kinegrade.language.math.tree import (
    DEGREE,
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


def is_one(row: Row) -> bool:
    """Whether a row is heard as one thing: a symbol with its index, a number, or points such as
    AB.
    """
    if len(row) == 1:
        return _is_atom(row[0])
    return bool(row) and all(map(_is_point, row))


def is_product(row: Row) -> bool:
    """Whether a row is one thing, or several side by side without a sign between them."""
    return bool(row) and all(_is_atom(node) or isinstance(node, Root) for node in row)


def _is_atom(node: Node) -> bool:
    match node:
        case Letter() | Number():
            return True
        case Scripts(base, lower, _, upper):
            labelled = lower is None or is_label(lower)
            return base is not None and _is_atom(base) and labelled and upper in (None, DEGREE)
        case Lettering(_, row) | Group(row) | Accent(_, row):
            return len(row) == 1 and _is_atom(row[0])
        case Root(radicand, degree):
            return degree is None and is_one(radicand)
        case Sign() | Function() | Text() | Unit() | Space() | LineBreak() | Mark():
            return False
        case Quotient() | Fenced() | Environment():
            return False
        case _:
            assert_never(node)


def _is_point(node: Node) -> bool:
    """Whether a node is the name of a point: A, O with an index, B'."""
    base = node.base if isinstance(node, Scripts) and node.upper is None else node
    return isinstance(base, Letter) and base.name.isupper() and len(base.name) == 1


def is_label(row: Row) -> bool:
    """Whether an index is letters and digits that say whose the symbol is."""
    return all(_is_part_of_label(node) for node in row)


def _is_part_of_label(node: Node) -> bool:
    match node:
        case Letter() | Number() | Space():
            return True
        case Sign(latex):
            return SIGNS[latex].kind == "punctuation"
        case Lettering(_, row) | Group(row):
            return is_label(row)
        case Scripts(base, lower, _, upper):
            labelled = lower is None or is_label(lower)
            return base is not None and _is_part_of_label(base) and labelled and upper is None
        case Function() | Text() | Unit() | LineBreak() | Mark():
            return False
        case Quotient() | Root() | Accent() | Fenced() | Environment():
            return False
        case _:
            assert_never(node)
