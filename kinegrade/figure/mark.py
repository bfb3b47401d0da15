"""One way to draw a mark (a dimension, an angle, a motion), and what its spots for a label are."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from kinegrade.figure.extent import symbol_size
from kinegrade.figure.place import Floats, Wish, around
from kinegrade.figure.plane import SIDE_VECTORS, length, polar
from kinegrade.figure.scene import Primitive
from kinegrade.mechanics.vector import Vector


@dataclass(frozen=True)
class Mark:
    """One way to draw a mark: its parts, the points it passes, its label, how much less nice it is.

    A demerit of 10 weighs as much as one thin line crossed.
    """

    primitives: tuple[Primitive, ...]
    path: tuple[Vector, ...]
    wish: Wish
    demerit: float = 0.0


def direction(at: Mapping[str, Vector], vertex: Vector, name: str) -> Vector:
    """A side of the paper, or towards a point."""
    return at[name] - vertex if name in at else SIDE_VECTORS[name]


def sampled(start: Vector, end: Vector) -> tuple[Vector, ...]:
    count = max(2, round(length(end - start) / 1.5))
    return tuple(start + (end - start) * (index / count) for index in range(count + 1))


def along_bow(vertex: Vector, radius: float, start: float, sweep: float, symbol: str) -> Floats:
    """Outside the arc, then inside it, near its middle first; then round about."""
    size = np.array(symbol_size(symbol))
    angles = start + sweep * np.array((0.5, 0.38, 0.62, 0.25, 0.75))
    toward = np.stack((np.cos(angles), np.sin(angles)), axis=1)
    half = np.abs(toward) @ size / 2
    levels = [
        radius + side * (half + more) for side, more in ((1, 0.4), (-1, 0.9), (1, 1.4), (-1, 1.8), (1, 2.4))
    ]
    spots = np.array(vertex) + toward * np.array(levels)[:, :, None]
    near = around(symbol, vertex + polar(start + sweep / 2, radius))
    return np.concatenate((spots.reshape(-1, 2), near))
