"""Lengths that are hard to read: letters that something else could own, or that would be read as a
factor, dimension lines across bars, long leaders.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import chain

from kinegrade.figure.marks.lengths.dimension_lines import DimensionLine, Leader, SymbolBeside
from kinegrade.figure.marks.straight.motions import list_arrows
from kinegrade.figure.placing.beside import makes_product
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.obstacles import Obstacles
from kinegrade.figure.placing.ownership import is_claimed, widen_labels
from kinegrade.figure.scene import Label
from kinegrade.problem.template.hints import Length

# Costs of a dimension line that crosses no bar and no letter, and of a leader that is short and
# clear of the marks of others
_EASY, _SHORT = 95.0, 12.5


def measure_strain(layout: Layout, count: int) -> float:
    """What those of so many lengths cost too much that were marked last: nothing where they are
    easily read.
    """
    first = len(layout.marks) - count
    marks = zip(layout.marks[first:], layout.costs[first:], strict=True)
    dear = (cost - (_SHORT if isinstance(mark, Leader) else _EASY) for mark, cost in marks)
    return sum((cost for cost in dear if cost > 0), 0.0)


def find_claimed(layout: Layout) -> tuple[str, ...]:
    """The symbols beside lines of which each is nearer to something else than to its own line, or
    makes a product with the symbol of an arrow.
    """
    rates = list_rates(layout)
    return tuple(
        mark.symbol
        for mark in layout.marks
        if isinstance(mark, SymbolBeside)
        and all(
            _is_claimed(mark, label, layout.obstacles, rates)
            for label in layout.labels
            if label.symbol == mark.symbol
        )
    )


def list_rates(layout: Layout) -> tuple[Label, ...]:
    """The symbols of the arrows of motions."""
    arrows = {arrow.hint.symbol for arrow in list_arrows(layout.marks)}
    return tuple(label for label in layout.labels if label.symbol in arrows)


def _is_claimed(mark: SymbolBeside, label: Label, drawn: Obstacles, rates: Sequence[Label]) -> bool:
    """Whether the symbol of a length is read as that of something else, or with that of a rate."""
    line = (mark.start, mark.end)
    return is_claimed(label, line, mark.half, drawn) or makes_product(label, rates)


def widen_written(layout: Layout, lengths: Iterable[Length]) -> Obstacles:
    """The letters of lengths that are written already, with what is about them, and the lines of
    dimensions.
    """
    symbols = {each.symbol for each in lengths}
    written = widen_labels(label for label in layout.labels if label.symbol in symbols)
    lines = (mark.primitives() for mark in layout.marks if isinstance(mark, DimensionLine))
    return written.with_drawn(chain.from_iterable(lines))
