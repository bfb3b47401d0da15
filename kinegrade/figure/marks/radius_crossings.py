"""What the arrow of a radius should not cross, however thin: the arrows of motions, the sides and
arcs of angles, dimensions.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from kinegrade.figure.marks.in_angles import list_arcs
from kinegrade.figure.marks.lengths.dimension_lines import DimensionLine
from kinegrade.figure.marks.straight.motions import gather_arrows
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.mark import Mark
from kinegrade.figure.placing.obstacles import Obstacles
from kinegrade.figure.placing.ownership import CLAIMING, widen_labels
from kinegrade.figure.scene import THIN, Primitive, Strokes

# Cost of an arrow across that of a motion, and across a side or arc of an angle or a dimension
_ACROSS_ARROW, _ACROSS_LINE = 12.0, 6.0


def rate_crossings(arrows: Iterable[Mark], layout: Layout) -> Iterator[float]:
    """The demerit of each arrow of a radius for what it crosses and what letters it claims."""
    motions, lines = gather_arrows(layout.marks), Obstacles.of(_list_lines(layout.marks))
    claimed = widen_labels(layout.labels)
    costs = ((motions, _ACROSS_ARROW), (lines, _ACROSS_LINE), (claimed, CLAIMING))
    for arrow in arrows:
        path = arrow.path()
        yield sum(cost * (drawn.along(path, shared=False) > 0) for drawn, cost in costs)


def _list_lines(drawn: Sequence[Mark]) -> Iterator[Primitive]:
    """The sides and arcs of angles, and dimensions with their extension lines."""
    for arc in list_arcs(drawn):
        yield from (Strokes(arc.list_sides(), THIN), arc.bow)
    for mark in drawn:
        if isinstance(mark, DimensionLine):
            yield from mark.primitives()
