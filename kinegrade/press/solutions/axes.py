"""Whether a worked solution speaks of the axes x and y, so that its figure has to show them."""

from __future__ import annotations

from collections.abc import Sequence

from kinegrade.language.math.tree import Letter, list_nodes
from kinegrade.worked.document import Block, list_block_formulas

_AXES = (Letter("x"), Letter("y"))


def names_axes(blocks: Sequence[Block]) -> bool:
    """Whether an axis, a coordinate or a component along an axis stands in some formula.

    >>> from kinegrade.worked.document import Prose
    >>> names_axes([Prose("Projected on the $x$ axis:")]), names_axes([Prose("Projected on $AB$:")])
    (True, False)
    """
    return any(
        node in _AXES
        for block in blocks
        for row in list_block_formulas(block)
        for node in list_nodes(row)
    )
