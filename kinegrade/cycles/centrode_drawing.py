"""The centrodes of a mechanism in its moving figure: the fixed ones as solid curves, the moving
ones as dashed curves that roll on them, and the poles, where both touch.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from kinegrade.cycles.centrodes import Centrodes, trace_centrodes
from kinegrade.cycles.frame import is_inside
from kinegrade.figure.scene import Box, Disc, Outline, Pen, Primitive, move
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


@dataclass(frozen=True, eq=False)
class TracedCentrodes:
    """In m: the `fixed` centrodes, and at each displacement drawn the moving ones (`carried`: x and
    y, places, drawings) and the `poles` (x and y, drawings) of the same `bodies`; of `count`
    drawings.
    """

    bodies: tuple[str, ...]
    fixed: tuple[Array, ...]
    carried: tuple[Array, ...]
    poles: tuple[Array, ...]
    count: int

    @property
    def curves(self) -> tuple[Array, ...]:
        """All of the curves."""
        return (*self.fixed, *self.carried)

    def find_poles(self, number: int, scale: float, frame: Box) -> Mapping[str, Vector]:
        """The poles of one drawing in mm, by body, as far as they lie in a frame in mm."""
        places = {
            body: poles[:, number] * scale
            for body, poles in zip(self.bodies, self.poles, strict=True)
        }
        return {
            body: Vector(*place.tolist())
            for body, place in places.items()
            if is_inside(place, frame)
        }


def trace_drawn_centrodes(path: MotionPath, moved: Array, bodies: Sequence[str]) -> TracedCentrodes:
    """The centrodes of these bodies at displacements of the input."""
    fine = path.spread(_FINE)
    whole = trace_centrodes(
        path.place(fine[(fine >= moved[0]) & (fine <= _find_last(path, moved))]), bodies
    )
    placement = path.place(moved)
    placing = Placing(path.motion.frames, placement.at)
    return TracedCentrodes(
        tuple(each.body for each in whole),
        tuple(each.fixed for each in whole),
        tuple(_carry(placing, each, len(moved)) for each in whole),
        tuple(each.fixed for each in trace_centrodes(placement, bodies)),
        len(moved),
    )


def draw_centrodes(
    traced: TracedCentrodes, scale: float, frame: Box, letters: Mapping[str, Primitive]
) -> CentrodeDrawing:
    """The centrodes and poles in mm, as far as they lie in a frame; the letter of each body's pole
    is one about the origin.
    """
    still = _draw_fixed(traced, scale, frame)
    moving = (
        tuple(_draw_moving(traced, number, scale, frame, letters)) for number in range(traced.count)
    )
    return CentrodeDrawing(still, tuple(moving))


def draw_curves(
    traced: TracedCentrodes, number: int, scale: float, frame: Box
) -> tuple[Primitive, ...]:
    """The centrodes of one drawing in mm, as far as they lie in a frame."""
    return (*_draw_fixed(traced, scale, frame), *_draw_carried(traced, number, scale, frame))


def _draw_fixed(traced: TracedCentrodes, scale: float, frame: Box) -> tuple[Primitive, ...]:
    return tuple(part for each in traced.fixed for part in _draw_curve(each * scale, frame, _FIXED))


def _draw_carried(
    traced: TracedCentrodes, number: int, scale: float, frame: Box
) -> Iterator[Primitive]:
    for curve in traced.carried:
        yield from _draw_curve(curve[:, :, number] * scale, frame, _MOVING)


def _find_last(path: MotionPath, moved: Array) -> float:
    return path.bounds[1] if path.is_closed else float(moved[-1])


def _carry(placing: Placing, centrodes: Centrodes, count: int) -> Array:
    """The moving centrode in so many positions of its body: x and y, places, positions."""
    x, y = centrodes.moving
    placed = placing.place(centrodes.body, Vector(x[:, None], y[:, None]))
    return np.array([np.broadcast_to(part, (len(x), count)) for part in placed])


def _draw_moving(
    traced: TracedCentrodes,
    number: int,
    scale: float,
    frame: Box,
    letters: Mapping[str, Primitive],
) -> Iterator[Primitive]:
    """The moving centrodes and the poles of one drawing."""
    yield from _draw_carried(traced, number, scale, frame)
    for body, pole in traced.find_poles(number, scale, frame).items():
        yield Disc(pole, _POLE, None, "black")
        if body in letters:
            yield move(letters[body], pole)


def _draw_curve(places: Array, frame: Box, pen: Pen) -> Iterator[Primitive]:
    """The parts of a curve that lie in the frame."""
    inside = is_inside(places, frame)
    ends = np.flatnonzero(np.diff(np.concatenate([[False], inside, [False]])))
    for start, end in ends.reshape(-1, 2).tolist():
        if end - start > 1:
            corners = places[:, start:end].T.round(3).tolist()
            yield Outline(tuple(Vector(x, y) for x, y in corners), pen, closed=False)
