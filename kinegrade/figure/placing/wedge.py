"""Where the letter of an angle may stand: between the sides of the angle, or of their
prolongations, and on the same side as its arc of everything that passes between them.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from math import pi

import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from kinegrade.figure.placing.extent import measure_symbol
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.place import CLEARANCE, LOST, Floats, Wish
from kinegrade.figure.plane import length, polar
from kinegrade.figure.scene import Bow, Disc
from kinegrade.mechanics.vector import Vector

_APART = 0.4  # millimetres kept between the letter and the edge of a side
_FARTHEST = 27.0  # millimetres from the vertex: beyond, a letter belongs to no angle
# Millimetres of paper between an arc and a letter at it, and the demerit of each one more
_AT_ARC, _AWAY = 0.8, 1.6
_ON_ARC = 4.0  # demerit of a letter through which its own arc would run
# Shares of the angle at which a letter may stand along its arc, the middle first; for a letter near
# an end of a long arc; and millimetres between the arc and a letter outside it, or inside it
# (negative)
_SHARES, _ENDS, _GAPS = (0.5, 0.38, 0.62, 0.25, 0.75), (0.13, 0.87), (0.4, 0.52, -0.5, 1.2)
_PLACES = np.array([*product(_GAPS, _SHARES), *product(_GAPS[::2], _ENDS)])
_ABOUT = np.array((0.0, 0.25, -0.25))  # of the angle, either side of its middle
_FLAT = 3.0  # radians from which on an angle is as wide as a half plane
_LATEST = 3.2  # millimetres of paper to its arc from which on a letter is lost
# Millimetres beyond the narrowest place with room
_STEPS = np.array((0.02, 0.12, 0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.5, 7.0, 9.0, 11.0))


class Wedge(Struct, frozen=True):
    """The arc of an angle, and half the widths of what is drawn along its first and last side, in
    millimetres.
    """

    bow: Bow
    halves: tuple[float, float] = (0.0, 0.0)


def list_spots_in_wedge(symbol: str, wedge: Wedge) -> Wish:
    """Spots for the symbol of an angle: at its arc, outside it or inside, where the angle is wide
    enough for it, and last, where it is lost, outside the angle.
    """
    bow = wedge.bow
    spots = _list_spots_at(symbol, bow)
    if measure_narrow(symbol, wedge) > bow.radius / 2:
        spots = np.concatenate((spots, _list_wide_spots(symbol, wedge)))
    away = _measure_away(symbol, spots, bow)
    demerits = _AWAY * np.maximum(away - _AT_ARC, 0.0) + LOST * (away > _LATEST)
    demerits = demerits + _ON_ARC * (away < CLEARANCE)
    demerits = demerits + LOST * rate_outside(symbol, spots, wedge)
    order = np.argsort(demerits.round(6), kind="stable")
    return Wish(symbol, spots[order], demerits=demerits[order])


def _measure_away(symbol: str, spots: Floats, bow: Bow) -> Floats:
    """For each spot the millimetres of paper between a symbol there and the circle of an arc."""
    steps, half = np.abs(spots - np.array(bow.centre)), np.array(measure_symbol(symbol)) / 2
    nearest, farthest = np.hypot(*np.maximum(steps - half, 0.0).T), np.hypot(*(steps + half).T)
    return np.asarray(np.maximum(np.maximum(nearest - bow.radius, bow.radius - farthest), 0.0))


def measure_narrow(symbol: str, wedge: Wedge) -> float:
    """How far from the vertex a symbol has to stand at least to be between the sides, in
    millimetres.
    """
    return length(_find_apex(symbol, wedge) - wedge.bow.centre)


def _find_apex(symbol: str, wedge: Wedge) -> Vector:
    """The place for a symbol nearest to the vertex that is clear of both sides."""
    bow = wedge.bow
    if abs(bow.sweep) >= _FLAT:
        return bow.centre + polar(bow.start + bow.sweep / 2, max(_measure_reaches(symbol, wedge)))
    (one, other), (first, last) = _find_inward(bow), _measure_reaches(symbol, wedge)
    across = max(abs(one[0] * other[1] - one[1] * other[0]), 1e-3)
    sense = 1.0 if one[0] * other[1] > one[1] * other[0] else -1.0
    x, y = first * other[1] - last * one[1], last * one[0] - first * other[0]
    return bow.centre + Vector(x, y) * (sense / across)


def _list_wide_spots(symbol: str, wedge: Wedge) -> Floats:
    """Spots at the bisector and beside it from where the angle is wide enough."""
    bow, apex = wedge.bow, _find_apex(symbol, wedge)
    steps = _STEPS[length(apex - bow.centre) + _STEPS < _FARTHEST, None, None]
    toward = _point_toward(bow.start + bow.sweep * (0.5 + _ABOUT))
    return np.asarray(np.array(apex) + (steps * toward).reshape(-1, 2))


def _list_spots_at(symbol: str, bow: Bow) -> Floats:
    """Spots along an arc, outside and inside it."""
    gaps, shares = _PLACES.T
    toward = _point_toward(bow.start + bow.sweep * shares)
    reach = gaps + np.copysign(np.abs(toward) @ np.array(measure_symbol(symbol)) / 2, gaps)
    return np.asarray(np.array(bow.centre) + toward * (bow.radius + reach)[:, None])


def _point_toward(angles: Floats) -> Floats:
    """The unit vectors at some angles, as rows."""
    return np.stack((np.cos(angles), np.sin(angles)), axis=1)


def rate_outside(symbol: str, spots: Floats, wedge: Wedge) -> Floats:
    """For each spot 0 where a symbol stands wholly between the sides of the angle (beyond half a
    turn: beside one of them), else 1.
    """
    bow = wedge.bow
    depths = (spots - np.array(bow.centre)) @ np.array(_find_inward(bow)).T
    beyond = depths - _measure_reaches(symbol, wedge) < -1e-6
    out = beyond.any(axis=1) if abs(bow.sweep) <= pi else beyond.all(axis=1)
    return np.asarray(out, dtype=float)


def rate_parted(spots: Floats, bow: Bow, lines: Sequence[Segment]) -> Floats:
    """For each spot 1 where a line passes between it and the arc, else 0."""
    return rate_cut_off(spots, _find_feet(spots, bow), lines)


def rate_parted_by_rims(spots: Floats, bow: Bow, rims: Sequence[Disc | Bow]) -> Floats:
    """For each spot 1 where a circle passes between it and the arc, else 0."""
    feet, parted = _find_feet(spots, bow), np.zeros(len(spots))
    for rim in rims:
        within = [
            np.hypot(*(places - np.array(rim.centre)).T) < rim.radius for places in (spots, feet)
        ]
        parted = np.maximum(parted, within[0] != within[1])
    return parted


def _find_feet(spots: Floats, bow: Bow) -> Floats:
    """For each spot the place on the circle of an arc on the same ray from its centre."""
    steps = spots - np.array(bow.centre)
    distances = np.maximum(np.hypot(steps[:, 0], steps[:, 1]), 1e-9)
    return np.asarray(np.array(bow.centre) + steps * (bow.radius / distances)[:, None])


def rate_cut_off(spots: Floats, feet: Floats, lines: Sequence[Segment]) -> Floats:
    """For each spot 1 where a line passes between it and its foot, else 0."""
    if not lines:
        return np.zeros(len(spots))
    starts, ends = np.array(lines).transpose(1, 0, 2)
    parted = _lie_apart(starts, ends, spots, feet) & _lie_apart(spots, feet, starts, ends).T
    return np.asarray(parted.any(axis=1), dtype=float)


def _lie_apart(starts: Floats, ends: Floats, ones: Floats, others: Floats) -> NDArray[np.bool_]:
    """For each pair of points (rows) whether it lies on both sides of each line (columns)."""
    across = (ends - starts)[:, ::-1] * np.array((-1.0, 1.0))
    levels = [points @ across.T - (starts * across).sum(axis=1) for points in (ones, others)]
    return np.asarray(levels[0] * levels[1] < 0)


def _measure_reaches(symbol: str, wedge: Wedge) -> tuple[float, float]:
    """How far the middle of a symbol has to stay from either side, in millimetres."""
    wide, high = measure_symbol(symbol)
    inward = [(abs(x) * wide + abs(y) * high) / 2 for x, y in _find_inward(wedge.bow)]
    first, last = [reach + half + _APART for reach, half in zip(inward, wedge.halves, strict=True)]
    return first, last


def _find_inward(bow: Bow) -> tuple[tuple[float, float], ...]:
    """The normals of the first and the last side that point into the angle."""
    turn = pi / 2 if bow.sweep > 0 else -pi / 2
    first, last = polar(bow.start + turn), polar(bow.start + bow.sweep - turn)
    return (first.x, first.y), (last.x, last.y)
