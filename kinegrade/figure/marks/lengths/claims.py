"""Letters of lengths that something else could own."""

from __future__ import annotations

from collections.abc import Iterable

from kinegrade.figure.marks.lengths.dimension_lines import SymbolBeside
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.obstacles import Obstacles
from kinegrade.figure.placing.ownership import is_claimed, widen_labels
from kinegrade.problem.template.hints import Length


def find_claimed(layout: Layout) -> tuple[str, ...]:
    """The symbols beside lines of which each is nearer to something else than to its own line."""
    return tuple(
        mark.symbol
        for mark in layout.marks
        if isinstance(mark, SymbolBeside)
        and all(
            is_claimed(label, (mark.start, mark.end), mark.half, layout.obstacles)
            for label in layout.labels
            if label.symbol == mark.symbol
        )
    )


def widen_written(layout: Layout, lengths: Iterable[Length]) -> Obstacles:
    """The letters of lengths that are written already, with what is about them."""
    symbols = {each.symbol for each in lengths}
    return widen_labels(label for label in layout.labels if label.symbol in symbols)
