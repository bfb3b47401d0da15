"""Symbols of arrows that leave them no place beside: they stand off, tied by a thin line."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product

import numpy as np

from kinegrade.figure.placing.extent import measure_symbol
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.letters import trace_leader
from kinegrade.figure.placing.obstacles import COST_FIRM, Bounds, Obstacles, Segment
from kinegrade.figure.placing.place import Floats, Wish, is_covered
from kinegrade.figure.plane import length
from kinegrade.figure.scene import THIN, Label, Strokes
from kinegrade.figure.vectors.arrows import VectorArrow, measure_distances
from kinegrade.mechanics.vector import Vector

_WAYS = np.arange(0.0, 2 * np.pi, np.pi / 12)  # directions from an arrow
_OFF = np.arange(4.5, 15.0, 0.9)  # millimetres from there to the middle of a symbol
_STEPS = (np.stack((np.cos(_WAYS), np.sin(_WAYS)), axis=1) * _OFF[:, None, None]).reshape(-1, 2)
_SHARES = (0.5, 0.3, 0.7)  # of an arrow, where a line may meet it
# Millimetres, and of a short arrow: a line that meets an arrow nearer to another might be of either
_APART, _APART_SHARE = (0.7, 0.2)
_FAR = 2.2  # millimetres of paper from an arrow to its symbol, from which on it may be another's
# What a line may cross: nothing, one other arrow, or the walls of a slot in which the arrow lies
NOTHING, ONE_ARROW, WALLS = (0.0, COST_FIRM, 4 * COST_FIRM)


def write_symbol(
    layout: Layout, arrow: VectorArrow, arrows: Sequence[VectorArrow], crossed: float, wish: Wish
) -> Layout:
    """The layout with the symbol of an arrow where it wishes to be; where other things leave it no
    place of its own there, or one that is far from the arrow, at the nearest free place, with a
    thin line to the arrow that crosses no more than `crossed`.
    """
    beside = layout.written((wish,))
    if beside.crowded == layout.crowded and _measure_gap(beside.labels[-1], arrow) < _FAR:
        return beside
    for foot in _find_feet(arrow, [other for other in arrows if other is not arrow]):
        for label, line in _list_leaders(arrow.symbol, foot, layout.obstacles):
            if layout.obstacles.along((line,), shared=False) <= crossed:
                spot = Wish(arrow.symbol, np.array([label.centre]))
                leader = Strokes(((line[0], foot),), THIN)
                return layout.written((spot,)).drawn((leader,))
    return beside


def _measure_gap(label: Label, arrow: VectorArrow) -> float:
    """Millimetres of paper between a symbol and its arrow."""
    half = np.array((label.width, label.height)) / 2
    return float(measure_distances(np.array([label.centre]), half, arrow.edges)[0])


def _find_feet(arrow: VectorArrow, others: Sequence[VectorArrow]) -> Iterator[Vector]:
    """Points of an arrow that are not points of another as well."""
    shafts = Obstacles.of((Strokes(tuple(line for other in others for line in other.edges), THIN),))
    for share, (start, end) in product(_SHARES, arrow.edges):
        room = min(_APART, _APART_SHARE * length(end - start))
        foot = start + (end - start) * share
        if not shafts.under_box(*foot, room, room):
            yield foot


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
