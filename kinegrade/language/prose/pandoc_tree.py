"""The pieces of pandoc's document tree that prose is made of, as values of its JSON form; nothing
in them is ever read as Markdown, HTML or TeX.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

Node = dict[str, Any]


def make_text(plain: str) -> Node:
    """Characters, printed as they are; control characters become spaces.

    >>> make_text("<b> $x$")
    {'t': 'Str', 'c': '<b> $x$'}
    """
    return {"t": "Str", "c": "".join(letter if letter.isprintable() else " " for letter in plain)}


def make_math(latex: str, display: bool = False) -> Node:
    """A formula, LaTeX math without dollar signs."""
    return {"t": "Math", "c": [{"t": "DisplayMath" if display else "InlineMath"}, latex]}


def make_strong(inlines: Sequence[Node]) -> Node:
    """Bold text."""
    return {"t": "Strong", "c": list(inlines)}


def make_emphasis(inlines: Sequence[Node]) -> Node:
    """Italic text."""
    return {"t": "Emph", "c": list(inlines)}


def make_line_break() -> Node:
    """The end of a line within a paragraph."""
    return {"t": "LineBreak"}


def make_paragraph(inlines: Sequence[Node]) -> Node:
    """A paragraph."""
    return {"t": "Para", "c": list(inlines)}


def make_plain(inlines: Sequence[Node]) -> Node:
    """Text without the space around a paragraph, as in a cell or in a short item."""
    return {"t": "Plain", "c": list(inlines)}


def make_bullets(items: Sequence[Sequence[Node]]) -> Node:
    """A list with bullets, each item some blocks."""
    return {"t": "BulletList", "c": [list(item) for item in items]}


def make_numbered(items: Sequence[Sequence[Node]], start: int) -> Node:
    """A list numbered from `start`."""
    return {
        "t": "OrderedList",
        "c": [[start, {"t": "Decimal"}, {"t": "Period"}], [list(item) for item in items]],
    }
