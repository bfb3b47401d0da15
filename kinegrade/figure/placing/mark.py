"""One way to draw a mark (a dimension, an angle, a motion): each mark has several alternatives."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise
from typing import Protocol

from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.place import Wish
from kinegrade.figure.plane import SIDE_VECTORS
from kinegrade.figure.scene import Bow, Primitive
from kinegrade.mechanics.vector import Vector


class Mark(Protocol):
    """One way to draw a mark. Only a few alternatives are asked for their wish, and one for its
    primitives.
    """

    @property
    def demerit(self) -> float:
        """How much worse it looks than the best way; 10 weighs as much as crossing one firm
        line.
        """

    @property
    def shared(self) -> bool:
        """Whether its lines may coincide with thin ones."""

    def path(self) -> tuple[Segment, ...]:
        """The straight pieces that should not cross anything."""

    def wish(self) -> Wish:
        """The symbol of the mark and where it may stand."""

    def primitives(self) -> tuple[Primitive, ...]:
        """The mark without its symbol."""


def direction(at: Mapping[str, Vector], vertex: Vector, name: str) -> Vector:
    """A side of the paper, or the direction towards a point."""
    return at[name] - vertex if name in at else SIDE_VECTORS[name]


def chords(bow: Bow, step: float = 0.35) -> tuple[Segment, ...]:
    """An arc as straight pieces of so many radians, accurate enough to find what it crosses."""
    return tuple(pairwise(bow.path(step)))
