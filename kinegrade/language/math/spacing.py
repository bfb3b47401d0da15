"""Where a formula on one line has blanks: around relations, and around signs between two terms."""

from __future__ import annotations

from kinegrade.language.math.letters import SIGNS
from kinegrade.language.math.tree import LineBreak, Mark, Node, Row, Scripts, Sign


def is_spaced(row: Row, place: int) -> bool:
    """Whether a blank stands before and after a node: a relation, or a sign between two terms.

    >>> from kinegrade.language.math.tree import Letter
    >>> minus = Sign("-")
    >>> is_spaced((minus, Letter("a")), 0), is_spaced((Letter("b"), minus, Letter("a")), 1)
    (False, True)
    """
    match row[place]:
        case Sign(latex):
            kind = SIGNS[latex].kind
            return kind == "relation" or (kind == "binary" and _ends_term(row, place - 1))
        case _:
            return False


def _ends_term(row: Row, place: int) -> bool:
    """Whether a term ends at a place, so that a sign after it stands between two terms."""
    return place >= 0 and not _opens(row[place])


def _opens(node: Node) -> bool:
    match node:
        case Sign(latex):
            return SIGNS[latex].kind in ("relation", "binary", "opening", "punctuation")
        case Scripts(base=None) | Mark() | LineBreak():
            return True
        case _:
            return False
