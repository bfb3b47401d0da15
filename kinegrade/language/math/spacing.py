"""How much room stands between the nodes of a formula, and where a formula on one line has blanks:
around relations, and around signs between two terms.
"""

from __future__ import annotations

from typing import assert_never

from kinegrade.language.math.letters import SIGNS, Kind
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

# em, as in TeX
SPACE_WIDTHS: dict[SpaceName, float] = {
    ",": 0.167,
    ":": 0.222,
    ";": 0.278,
    "!": -0.167,
    " ": 0.25,
    "quad": 1.0,
    "qquad": 2.0,
}


def is_spaced(row: Row, place: int) -> bool:
    """Whether a blank stands before and after a node: a relation, or a sign between two terms.

    >>> from kinegrade.language.math.tree import Letter
    >>> minus = Sign("-")
    >>> is_spaced((minus, Letter("a")), 0), is_spaced((Letter("b"), minus, Letter("a")), 1)
    (False, True)
    """
    node = row[place]
    if not isinstance(node, Sign):
        return False
    kind = SIGNS[node.latex].kind
    return kind == "relation" or (kind == "binary" and _ends_term(row, place - 1))


def is_sign_of(node: Node, kind: Kind) -> bool:
    """Whether a node is a sign of a kind, with or without scripts."""
    carrier = node.base if isinstance(node, Scripts) else None
    signs = (part for part in (node, carrier) if isinstance(part, Sign))
    return any(SIGNS[sign.latex].kind == kind for sign in signs)


def is_function(node: Node) -> bool:
    """Whether a node is the name of a function, with or without scripts."""
    carrier = node.base if isinstance(node, Scripts) else None
    return isinstance(node, Function) or isinstance(carrier, Function)


def _ends_term(row: Row, place: int) -> bool:
    """Whether a term ends at a place, so that a sign after it stands between two terms."""
    return place >= 0 and not _opens(row[place])


def _opens(node: Node) -> bool:
    match node:
        case Sign(latex):
            return SIGNS[latex].kind in ("relation", "binary", "opening", "punctuation")
        case Scripts(base):
            return base is None
        case Mark() | LineBreak():
            return True
        case Letter() | Number() | Function() | Text() | Unit() | Space():
            return False
        case Group() | Quotient() | Root() | Lettering() | Accent() | Fenced() | Environment():
            return False
        case _:
            assert_never(node)
