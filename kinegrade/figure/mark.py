"""One way to draw a mark (a dimension, an angle, a motion): every mark has several to choose
from.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise
from typing import Protocol

from kinegrade.figure.obstacles import Segment
from kinegrade.figure.place import Wish
from kinegrade.figure.plane import SIDE_VECTORS
from kinegrade.figure.scene import Bow, Primitive
from kinegrade.mechanics.vector import Vector


class Mark(Protocol):
    """One way to draw a mark; few of them are ever asked for their wish, and one for its
    primitives.
    """

    @property
    def demerit(self) -> float:
        """How much less nice it is than the nicest way; 10 weighs as much as one firm line
        crossed.
        """

    @property
    def shared(self) -> bool:
        """Whether its lines may lie on thin ones and be one with them."""

    def path(self) -> tuple[Segment, ...]:
        """The straight pieces that should not cross anything."""

    def wish(self) -> Wish:
        """Its symbol and where that may stand."""

    def primitives(self) -> tuple[Primitive, ...]:
        """The mark without its symbol."""


def direction(at: Mapping[str, Vector], vertex: Vector, name: str) -> Vector:
    """A side of the paper, or towards a point."""
    return at[name] - vertex if name in at else SIDE_VECTORS[name]


def chords(bow: Bow) -> tuple[Segment, ...]:
    """An arc as straight pieces, accurate enough to ask what it crosses."""
    return tuple(pairwise(bow.path(0.35)))
