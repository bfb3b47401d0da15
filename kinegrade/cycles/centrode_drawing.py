"""The centrodes of a mechanism in its moving figure: the fixed ones as solid curves, the moving
ones as dashed curves that roll on them, and the poles, where both touch.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from kinegrade.cycles.centrodes import Centrodes, trace_centrodes
from kinegrade.figure.scene import Box, Disc, Outline, Pen, Primitive
from kinegrade.mechanics.vector import Vector
from kinegrade.motion.path import Array, MotionPath
from kinegrade.motion.placing import Placing

_FINE = 361  # positions of the poles
_FIXED, _MOVING = Pen(0.25), Pen(0.25, "dashed")
_POLE = 0.7  # millimetres


@dataclass(frozen=True)
class CentrodeDrawing:
    """What stays in all drawings, and what each of them has."""

    still: tuple[Primitive, ...]
    moving: tuple[tuple[Primitive, ...], ...]


def draw_centrodes(path: MotionPath, moved: Array, scale: float, frame: Box) -> CentrodeDrawing:
    """The centrodes at displacements of the input, in mm, as far as they lie in a frame."""
    fine = path.spread(_FINE)
    whole = trace_centrodes(
        path.place(fine[(fine >= moved[0]) & (fine <= _find_last(path, moved))])
    )
    placement = path.place(moved)
    now = trace_centrodes(placement)
    placing = Placing(path.motion.frames, placement.at)
    still = [part for each in whole for part in _draw_curve(each.fixed * scale, frame, _FIXED)]
    carried = [_carry(placing, each, len(moved)) * scale for each in whole]
    moving = (
        tuple(_draw_moving([each[:, :, number] for each in carried], now, number, scale, frame))
        for number in range(len(moved))
    )
    return CentrodeDrawing(tuple(still), tuple(moving))


def _find_last(path: MotionPath, moved: Array) -> float:
    return path.bounds[1] if path.is_closed else float(moved[-1])


def _carry(placing: Placing, centrodes: Centrodes, count: int) -> Array:
    """The moving centrode in so many positions of its body: x and y, places, positions."""
    x, y = centrodes.moving
    placed = placing.place(centrodes.body, Vector(x[:, None], y[:, None]))
    return np.array([np.broadcast_to(part, (len(x), count)) for part in placed])


def _draw_moving(
    carried: list[Array], now: tuple[Centrodes, ...], number: int, scale: float, frame: Box
) -> Iterator[Primitive]:
    """The moving centrodes and the poles of one drawing."""
    for curve in carried:
        yield from _draw_curve(curve, frame, _MOVING)
    for each in now:
        pole = Vector(*(each.fixed[:, number] * scale).tolist())
        if _is_inside(np.array([[pole.x], [pole.y]]), frame)[0]:
            yield Disc(pole, _POLE, None, "black")


def _draw_curve(places: Array, frame: Box, pen: Pen) -> Iterator[Primitive]:
    """The parts of a curve that lie in the frame."""
    inside = _is_inside(places, frame)
    ends = np.flatnonzero(np.diff(np.concatenate([[False], inside, [False]])))
    for start, end in ends.reshape(-1, 2).tolist():
        if end - start > 1:
            corners = places[:, start:end].T.round(3).tolist()
            yield Outline(tuple(Vector(x, y) for x, y in corners), pen, closed=False)


def _is_inside(places: Array, frame: Box) -> Array:
    x, y = places
    across = (frame.left <= x) & (x <= frame.right)
    return np.asarray(across & (frame.bottom <= y) & (y <= frame.top))
