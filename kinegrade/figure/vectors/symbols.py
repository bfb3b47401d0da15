"""Where the symbol of an arrow may stand: beside the arrow, nearer to it than to any other."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from kinegrade.figure.placing.extent import measure_symbol
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.place import Floats, Wish, list_spots_around, list_spots_beside
from kinegrade.figure.plane import length
from kinegrade.figure.scene import Label
from kinegrade.figure.vectors.arrows import VectorArrow
from kinegrade.mechanics.vector import Vector

_NEARER = 0.3  # millimetres by which a symbol has to be nearer to its arrow than to any other
# Along a line, of its points whose distance from a symbol is measured
_SHARES = np.linspace(0.0, 1.0, 41)[:, None, None]
# Cost of a symbol that may be read as that of another arrow: more than covering a firm line
_MISTAKEN = 40.0


def wish_beside(arrow: VectorArrow, arrows: Iterable[VectorArrow]) -> Wish:
    """The symbol beside the middle of the arrow, nearer to it than to any other."""
    start, end = arrow.line
    beside = list_spots_beside(arrow.symbol, start, end)
    return _wish(arrow, np.concatenate((beside, _list_spots_about_tip(arrow))), arrows)


def wish_at_tip(arrow: VectorArrow, arrows: Iterable[VectorArrow]) -> Wish:
    """The symbol around the tip of the arrow, or beside its half near the tip, at last beside the
    other half, nearer to it than to any other.
    """
    start, end = arrow.line
    middle, about = (start + end) / 2, _list_spots_about_tip(arrow)
    near, far = (
        list_spots_beside(arrow.symbol, *half, gaps=(0.5, 1.4))
        for half in ((middle, end), (start, middle))
    )
    return _wish(arrow, np.concatenate((about[:8], near, about[8:], far)), arrows)


def foresee_symbol(arrow: VectorArrow) -> Label:
    """The symbol at the first of its places around the tip."""
    return Wish(arrow.symbol, _list_spots_about_tip(arrow)).label_at(0)


def _list_spots_about_tip(arrow: VectorArrow) -> Floats:
    start, end = arrow.line
    return list_spots_around(arrow.symbol, end, away=end - start)


def _wish(arrow: VectorArrow, spots: Floats, arrows: Iterable[VectorArrow]) -> Wish:
    others = [other for other in arrows if other is not arrow]
    lines = [line for other in others for line in list_lines_beyond(other, (arrow,))]
    own = list_lines_beyond(arrow, others)
    mistaken = rate_nearness_to_lines(arrow.symbol, spots, own, lines)
    return Wish(arrow.symbol, spots, None, _MISTAKEN * mistaken)


def list_lines_beyond(arrow: VectorArrow, others: Iterable[VectorArrow]) -> list[Segment]:
    """The lines of an arrow that are no other's: of one that goes on where another ends, what goes
    on.
    """
    start, _ = arrow.line
    within = [other.line[1] for other in others if arrow.goes_on_from(other)]
    if within:
        start = max(within, key=lambda tip: length(tip - start))
    return list(_list_lines(arrow, start))


def _list_lines(arrow: VectorArrow, start: Vector) -> Iterator[Segment]:
    """The lines of an arrow from a point of it, with the sides of its head."""
    if arrow.around:
        yield from arrow.edges
        return
    tip, *back = arrow.head_corners
    yield start, tip
    for corner in back:
        yield tip, corner


def rate_nearness_to_lines(
    symbol: str, spots: Floats, own: Sequence[Segment], others: Sequence[Segment]
) -> Floats:
    """For each spot 1 where a symbol would stand about as near to another line as to its `own`,
    else 0.
    """
    if not others:
        return np.zeros(len(spots))
    half = np.array(measure_symbol(symbol)) / 2
    mine, theirs = (measure_distances(spots, half, lines) for lines in (own, others))
    return np.asarray(theirs < mine + _NEARER, dtype=float)


def measure_distances(spots: Floats, half: Floats, lines: Sequence[Segment]) -> Floats:
    """The distances from boxes about the spots to the nearest of the lines, each line sampled as a
    row of points.
    """
    starts, ends = (np.array(corners) for corners in zip(*lines, strict=True))
    rows = starts + _SHARES * (ends - starts)
    off = [
        np.maximum(np.abs(spots[:, axis, None] - rows[..., axis].ravel()) - half[axis], 0.0)
        for axis in (0, 1)
    ]
    return np.asarray(np.sqrt((off[0] ** 2 + off[1] ** 2).min(axis=1)))
