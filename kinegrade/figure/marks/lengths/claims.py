"""Letters of lengths that something else could own, or that would be read as a factor."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from kinegrade.figure.marks.lengths.dimension_lines import SymbolBeside
from kinegrade.figure.marks.straight.motions import list_arrows
from kinegrade.figure.placing.beside import makes_product
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.obstacles import Obstacles
from kinegrade.figure.placing.ownership import is_claimed, widen_labels
from kinegrade.figure.scene import Label
from kinegrade.problem.template.hints import Length


def find_claimed(layout: Layout) -> tuple[str, ...]:
    """The symbols beside lines of which each is nearer to something else than to its own line, or
    makes a product with the symbol of an arrow.
    """
    arrows = {arrow.hint.symbol for arrow in list_arrows(layout.marks)}
    rates = [label for label in layout.labels if label.symbol in arrows]
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


def _is_claimed(mark: SymbolBeside, label: Label, drawn: Obstacles, rates: Sequence[Label]) -> bool:
    """Whether the symbol of a length is read as that of something else, or with that of a rate."""
    line = (mark.start, mark.end)
    return is_claimed(label, line, mark.half, drawn) or makes_product(label, rates)


def widen_written(layout: Layout, lengths: Iterable[Length]) -> Obstacles:
    """The letters of lengths that are written already, with what is about them."""
    symbols = {each.symbol for each in lengths}
    return widen_labels(label for label in layout.labels if label.symbol in symbols)
