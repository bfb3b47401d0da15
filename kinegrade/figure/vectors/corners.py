"""The corners of a polygon of vectors and where their letters stand."""

from __future__ import annotations

from collections.abc import Container, Iterable, Mapping, Sequence

import numpy as np

from kinegrade.figure.placing.extent import measure_symbol
from kinegrade.figure.placing.place import (
    Floats,
    Wish,
    list_close_spots,
    list_spots_around,
    rate_nearness,
)
from kinegrade.figure.plane import length
from kinegrade.figure.vectors.arrows import VectorArrow
from kinegrade.mechanics.vector import Vector

_ORIGINS = ("o", "p")  # letters of the origin: another where it is that of a corner
_CLOSE = 2.0  # millimetres: a letter is hardly told to be that of one of two corners that close
FAR = 2.5  # millimetres of paper from a corner to its letter, from which on that is not seen as its
_EVERY = 6  # of the places close to a corner, one in so many is tried
_STRAY = 1.0  # demerit of a letter that far
_MISTAKEN = 20.0  # demerit of a letter that may be read as that of another corner
_SAME = 0.05  # millimetres within which two corners coincide
_ZERO = Vector(0.0, 0.0)


def list_corners(arrows: Sequence[VectorArrow]) -> list[Vector]:
    """The origin and the other corners, each once."""
    corners = [_ZERO]
    corners.extend(arrow.end for arrow in arrows if not _is_among(arrow.end, corners))
    return corners


def _is_among(place: Vector, places: Iterable[Vector]) -> bool:
    return any(length(place - other) < _SAME for other in places)


def name_origin(letters: Container[str]) -> str:
    """The letter of the origin beside those of other corners."""
    return next(letter for letter in _ORIGINS if letter not in letters)


def name_corners(
    vertices: Mapping[str, Vector], corners: Sequence[Vector], scale: float, undrawn: float
) -> dict[str, Vector]:
    """The letters of the origin and of those vertices that the polygon has, but for vectors that
    are not drawn, `undrawn` millimetres together: the arrow before them leads past its vertex.
    """
    named = {name_origin(vertices): _ZERO}
    for letter, vertex in vertices.items():
        off, place = min(
            (length(corner - vertex * scale), place) for place, corner in enumerate(corners)
        )
        if place > 0 and off < undrawn + _SAME:
            named[letter] = corners[place]
    return named


def wish_letter(letter: str, corner: Vector, corners: Sequence[Vector]) -> Wish:
    """A letter outside its corner, nearer to it than to any other, clearly so than to those that
    are not close.
    """
    middle = sum(corners, _ZERO) * (1 / len(corners))
    spots, far = _list_letter_spots(letter, corner, corner - middle)
    away = [length(other - corner) for other in corners]
    others = [other for other, gap in zip(corners, away, strict=True) if gap > _CLOSE]
    close = [other for other, gap in zip(corners, away, strict=True) if _SAME < gap <= _CLOSE]
    mistaken = rate_nearness(letter, spots, (corner,), others)
    beyond = rate_nearness(letter, spots, (corner,), close)
    worse = _MISTAKEN * (mistaken + beyond) + _STRAY * far
    return Wish(letter, spots, None, worse, names=corner)


def _list_letter_spots(letter: str, corner: Vector, away: Vector) -> tuple[Floats, Floats]:
    """Places of a letter about its corner, and for each 1 where it is far from it, else 0: those
    near it come first, of them the ones outside; few, as a place costs more the later
    it comes, and a letter on a line is worse than one far off.
    """
    outside = list_spots_around(letter, corner, away=away)
    spots = np.concatenate((outside, list_close_spots(letter, corner, FAR)[::_EVERY]))
    off = np.abs(spots - np.array(corner)) - np.array(measure_symbol(letter)) / 2
    far = np.hypot(*np.maximum(off, 0.0).T) > FAR
    order = np.argsort(far, kind="stable")
    return spots[order], np.asarray(far[order], dtype=float)
