"""Whether a worked solution speaks of the axes x and y, so that its figure has to show them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import assert_never

from kinegrade.language.math.tree import Letter, Row, list_nodes
from kinegrade.press.solutions.prose_size import list_formulas
from kinegrade.worked.document import Block, Display, Heading, Pictures, Prose, TermTable

_AXES = (Letter("x"), Letter("y"))


def names_axes(blocks: Sequence[Block]) -> bool:
    """Whether an axis, a coordinate or a component along an axis stands in some formula.

    >>> names_axes([Prose("Projected on the $x$ axis:")]), names_axes([Prose("Projected on $AB$:")])
    (True, False)
    """
    return any(
        node in _AXES for block in blocks for row in _list_rows(block) for node in list_nodes(row)
    )


def _list_rows(block: Block) -> Iterator[Row]:
    """The formulas of a block."""
    match block:
        case Heading(text) | Prose(text):
            yield from list_formulas(text)
        case Display(lines):
            yield from lines
        case TermTable(terms):
            for term in terms:
                yield term.symbol
                yield from list_formulas(term.magnitude)
                yield from list_formulas(term.direction)
        case Pictures():
            return
        case _:
            assert_never(block)
