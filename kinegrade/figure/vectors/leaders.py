"""Symbols of arrows that leave them no place beside: they stand off, tied by a thin line."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product
from typing import TypeAlias

import numpy as np

from kinegrade.figure.placing.extent import measure_symbol
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.letters import trace_leader
from kinegrade.figure.placing.obstacles import COST_FIRM, Bounds, Obstacles, Segment
from kinegrade.figure.placing.place import Floats, Wish, is_covered
from kinegrade.figure.plane import length
from kinegrade.figure.scene import THIN, Label, Strokes
from kinegrade.figure.vectors.arrows import VectorArrow
from kinegrade.figure.vectors.symbols import list_lines_beyond, measure_distances
from kinegrade.mechanics.vector import Vector

Crossed: TypeAlias = tuple[float, ...]

_WAYS = np.arange(0.0, 2 * np.pi, np.pi / 12)  # directions from an arrow
_OFF = np.arange(4.5, 15.0, 0.9)  # millimetres from there to the middle of a symbol
_STEPS = (np.stack((np.cos(_WAYS), np.sin(_WAYS)), axis=1) * _OFF[:, None, None]).reshape(-1, 2)
_SHARES = (0.5, 0.3, 0.7, 0.85)  # of an arrow, where a line may meet it
# Millimetres, and of a short arrow: a line that meets an arrow nearer to another might be of either
_APART, _APART_SHARE = (0.7, 0.2)
_AT_HEAD = 0.5  # millimetres about a corner of a head that are free of other arrows
_FAR = 2.2  # millimetres of paper from an arrow to its symbol, from which on it may be another's
# What a line may cross: nothing, one other arrow, or the walls of a slot in which the arrow lies,
# and at last the walls of another as well
NOTHING, ONE_ARROW, WALLS = ((0.0,), (COST_FIRM,), (4 * COST_FIRM, 8 * COST_FIRM))


def write_symbol(
    layout: Layout, arrow: VectorArrow, arrows: Sequence[VectorArrow], crossed: Crossed, wish: Wish
) -> Layout:
    """The layout with the symbol of an arrow where it wishes to be; where other things leave it no
    place of its own there, or one that is far from the arrow, at the nearest free place, with a
    thin line to the arrow that crosses no more than `crossed`.
    """
    beside = layout.written((wish,))
    if beside.crowded == layout.crowded and _measure_gap(beside.labels[-1], arrow) < _FAR:
        return beside
    found = _find_leader(arrow, arrows, layout.obstacles, crossed)
    if found is None:
        return beside
    label, leader = found
    spot = Wish(arrow.symbol, np.array([label.centre]))
    return layout.written((spot,)).drawn((Strokes((leader,), THIN),))


def _find_leader(
    arrow: VectorArrow, arrows: Sequence[VectorArrow], obstacles: Obstacles, crossed: Crossed
) -> tuple[Label, Segment] | None:
    """A symbol that stands off and the thin line from it to its arrow, that crosses as little as
    any of those steps allows.
    """
    last: tuple[Label, Segment] | None = None
    for foot in _find_feet(arrow, [other for other in arrows if other is not arrow]):
        for label, line in _list_leaders(arrow.symbol, foot, obstacles):
            covered = obstacles.along((line,), shared=False)
            if covered <= crossed[0]:
                return label, (line[0], foot)
            if last is None and covered <= crossed[-1]:
                last = label, (line[0], foot)
    return last


def _measure_gap(label: Label, arrow: VectorArrow) -> float:
    """Millimetres of paper between a symbol and its arrow."""
    half = np.array((label.width, label.height)) / 2
    return float(measure_distances(np.array([label.centre]), half, arrow.edges)[0])


def _find_feet(arrow: VectorArrow, others: Sequence[VectorArrow]) -> Iterator[Vector]:
    """Points of an arrow that are not points of another as well."""
    lines = tuple(line for other in others for line in list_lines_beyond(other, (arrow,)))
    shafts = Obstacles.of((Strokes(lines, THIN),))
    own = list_lines_beyond(arrow, others)
    for share, (start, end) in product(_SHARES, arrow.edges if arrow.around else own[:1]):
        room = min(_APART, _APART_SHARE * length(end - start))
        foot = start + (end - start) * share
        if not shafts.under_box(*foot, room, room):
            yield foot
    for corner in arrow.head_corners[1:]:
        if not shafts.under_box(*corner, _AT_HEAD, _AT_HEAD):
            yield corner


def _list_leaders(
    symbol: str, foot: Vector, obstacles: Obstacles
) -> Iterator[tuple[Label, Segment]]:
    """Free places that stand off from a point of an arrow, the nearest first, and the lines from
    there to just before it.
    """
    size, centres = measure_symbol(symbol), np.array(foot) + _STEPS
    around = obstacles.near(_find_bounds(centres, size))
    for x, y in centres.tolist():
        label = Label(symbol, Vector(x, y), *size)
        if is_covered(label, around):
            continue
        line = trace_leader(label, foot, amid=True)
        if line:
            yield label, line


def _find_bounds(centres: Floats, size: tuple[float, float]) -> Bounds:
    """The box around labels at all of their places, with more than what is kept free around one."""
    (left, bottom), (right, top) = centres.min(axis=0).tolist(), centres.max(axis=0).tolist()
    width, height = size
    return left - width, bottom - height, right + width, top + height
