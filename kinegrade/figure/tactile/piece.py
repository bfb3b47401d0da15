"""What is put on a tactile sheet: whole or not at all, in one of several ways."""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.figure.scene import Primitive
from kinegrade.mechanics.vector import Vector


@dataclass(frozen=True)
class Way:
    """One way to draw a piece: its lines, and the places for its Braille labels, the best first,
    each with the middle of every label.
    """

    primitives: tuple[Primitive, ...]
    places: tuple[tuple[Vector, ...], ...] = ((),)


@dataclass(frozen=True)
class Piece:
    """A part, a letter or a given; `cells` are its labels in Braille, `ways` the best first, and
    `at` the points without which it means nothing. Its lines may meet others, but those of one mark
    never those of another.
    """

    ways: tuple[Way, ...]
    cells: tuple[str, ...] = ()
    at: tuple[Vector, ...] = ()
    is_mark: bool = False
