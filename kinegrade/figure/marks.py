"""The marks an author asked for: of every one the way that covers least of what is there."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from kinegrade.figure.dimensions import angle_marks, length_marks, radius_marks
from kinegrade.figure.layers import Drawing
from kinegrade.figure.mark import Mark
from kinegrade.figure.motions import moving_marks, turning_marks
from kinegrade.figure.place import Obstacles, Wish
from kinegrade.figure.scene import Primitive
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.problem.hints import FigureHints, Moving, Turning


def marks(
    mechanism: Mechanism, hints: FigureHints, drawing: Drawing, drawn: Obstacles
) -> tuple[tuple[Primitive, ...], tuple[Wish, ...]]:
    """All marks of the hints, each the alternative that covers least, and the labels they wish for."""
    chosen: tuple[Mark, ...] = ()
    reserved = drawn
    for alternatives in _alternatives(mechanism, hints, drawing):
        mark = _least_covering(alternatives, reserved)
        chosen += (mark,)
        lines = reserved.with_drawn(mark.primitives)
        reserved = lines.with_drawn((lines.label(mark.wish),))
    return tuple(part for mark in chosen for part in mark.primitives), tuple(mark.wish for mark in chosen)


def _alternatives(mechanism: Mechanism, hints: FigureHints, drawing: Drawing) -> Iterator[list[Mark]]:
    """Angles and rotations first: they belong close to their pivot; dimensions can give way."""
    at = mechanism.points
    for angle in hints.angles:
        yield from angle_marks(at, angle, drawing)
    for given in hints.arrows:
        if isinstance(given, Turning):
            yield turning_marks(mechanism, given, drawing)
    for radius in hints.radii:
        yield radius_marks(drawing.rims, radius)
    for dimension in hints.lengths:
        yield length_marks(at, dimension)
    for given in hints.arrows:
        if isinstance(given, Moving):
            yield moving_marks(mechanism, given)


def _least_covering(alternatives: list[Mark], obstacles: Obstacles) -> Mark:
    """The cheapest by what its line covers, what its label covers, and its demerit; the first of equals."""
    lines = obstacles.along([mark.path for mark in alternatives])
    labels = obstacles.cheapest([mark.wish for mark in alternatives])
    demerits = np.array([mark.demerit for mark in alternatives])
    return alternatives[int(np.argmin(lines + labels + demerits))]
