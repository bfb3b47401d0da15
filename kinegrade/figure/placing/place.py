"""Where a symbol may stand, the best spots first, and which of them it takes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache
from math import hypot, inf, pi

import numpy as np
from msgspec import Struct
from msgspec.structs import replace
from numpy.typing import NDArray

from kinegrade.figure.placing.extent import measure_symbol
from kinegrade.figure.placing.obstacles import COST_THIN, Obstacles, Segment
from kinegrade.figure.plane import length, polar
from kinegrade.figure.scene import Bow, Label
from kinegrade.mechanics.vector import Vector

Floats = NDArray[np.float64]

CLEARANCE = 0.25  # millimetres kept free around a label
# Cost of each later spot: a hundred of them weigh as much as covering one thin line
_FARTHER = 0.04
_LABEL_WEIGHT = 3.0  # a symbol on a line is worse than a line across a line
_AMBIGUOUS = 0.4  # millimetres by which a letter has to be nearer to its point than to any other
LOST = 20.0  # demerit of a spot at which a symbol is too far from its mark to be found
_FAULT = 0.5  # cost of a spot from which on there is a fault: less than covering a thin line
_AT_ONCE = 16  # spots checked together; nearly always one of the first is free
_TURNS = np.array((2, 6, -2, -6, 4, -4, 0, 8, 1, 3, 5, 7, -1, -3, -5, -7)) * (pi / 8)
_TOWARD = np.stack((np.cos(_TURNS), np.sin(_TURNS)), axis=1).round(9)
# Millimetres: farther a letter means nothing
_RINGS = np.array((1.2, 1.8, 2.6, 3.4, 4.2, 5.0, 6.2))
# Of the spots of a closer look: directions, and millimetres of paper between letter and point
_FINE = np.arange(0.0, 2 * pi, pi / 20)
_FINELY = np.stack((np.cos(_FINE), np.sin(_FINE)), axis=1).round(9)
_CLOSE_RINGS, _NEAREST = np.arange(1.2, 4.3, 0.3), 1.1
_BOW_STATIONS = np.array((0.5, 0.38, 0.62, 0.25, 0.75))
_CORNERS = np.array(((1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)))
_BOW_SIDES, _BOW_GAPS = np.array((1, -1, 1, -1, 1)), np.array((0.4, 0.5, 1.4, 1.4, 2.4))
_STATIONS = (0.5, 0.38, 0.62, 0.26, 0.74, 0.12, 0.88)


class Wish(Struct, frozen=True):
    """A label to be placed: its symbol, the centres it may have (rows x, y), the best first, and
    the point it belongs to.

    When none of its spots is free, any other spot around that point is allowed. A spot may have a
    demerit as well. A letter far from the point that it `names` gets a leader, whose last
    millimetres may cross what the point lies `amid`; before that its places are looked for more
    `closely`, as they are where it would stand behind one of the `walls`.
    The pin of the point may be beside its bar, on the `pin_side`.
    """

    symbol: str
    spots: Floats
    at: Vector | None = None
    demerits: Floats | None = None
    names: Vector | None = None
    amid: float = 0.0
    closely: Callable[[float], Wish] | None = None
    walls: tuple[Segment, ...] = ()
    pin_side: Vector | None = None

    def label_at(self, spot: int) -> Label:
        """The label at one of its spots."""
        return Label(self.symbol, Vector(*self.spots[spot].tolist()), *measure_symbol(self.symbol))

    def worse_by(self, demerits: Floats) -> Wish:
        """The wish with those demerits more."""
        more = demerits if self.demerits is None else self.demerits + demerits
        return replace(self, demerits=more)


class Placed(Struct, frozen=True):
    """A label at its spot, whether that has a fault: something is under it, or the spot has a
    demerit; and whether it is so far from its mark that nobody would find it.
    """

    label: Label
    faulty: bool
    lost: bool


def place_label(wish: Wish, obstacles: Obstacles) -> Placed:
    """The label at the first free spot of its wish, or where it covers least."""
    spot, cost = _choose_best(wish.symbol, wish.spots, obstacles, wish.demerits)
    if cost >= _FARTHER * len(wish.spots) and wish.at is not None:
        wish = widen(wish)
        spot, cost = _choose_best(wish.symbol, wish.spots, obstacles)
    demerit = 0.0 if wish.demerits is None else wish.demerits[spot]
    return Placed(wish.label_at(spot), cost - _FARTHER * spot >= _FAULT, lost=bool(demerit >= LOST))


def widen(wish: Wish) -> Wish:
    """The wish with the other spots around its point as its last; demerits are to be rated anew."""
    if wish.at is None:
        return wish
    around = list_spots_around(wish.symbol, wish.at)
    return replace(wish, spots=np.concatenate((wish.spots, around)), at=None, demerits=None)


def measure_gap(one: Label, other: Label) -> float:
    """Millimetres of paper between two labels."""
    across, upward = one.centre.x - other.centre.x, one.centre.y - other.centre.y
    wide, high = (one.width + other.width) / 2, (one.height + other.height) / 2
    return hypot(max(abs(across) - wide, 0.0), max(abs(upward) - high, 0.0))


def is_covered(label: Label, obstacles: Obstacles) -> bool:
    """Whether something is under a label, or too close to it."""
    width, height = (size + 2 * CLEARANCE for size in (label.width, label.height))
    return obstacles.under_box(*label.centre, width, height, COST_THIN) > 0


def measure_crowding(wish: Wish, obstacles: Obstacles, enough: float = inf) -> float:
    """The cost of the best of the first spots: how little room there is for the label. Not all is
    counted once it is `enough`.
    """
    demerits = None if wish.demerits is None else wish.demerits[:_AT_ONCE]
    return _choose_best(wish.symbol, wish.spots[:_AT_ONCE], obstacles, demerits, enough)[1]


def _choose_best(
    symbol: str,
    spots: Floats,
    obstacles: Obstacles,
    demerits: Floats | None = None,
    enough: float = inf,
) -> tuple[int, float]:
    """Index and cost of the best spot, if that is below what is `enough`; the farther ones are
    checked only while none is free.
    """
    width, height = (size + 2 * CLEARANCE for size in measure_symbol(symbol))
    worse = [0.0] * len(spots) if demerits is None else demerits.tolist()
    best, least = 0, enough
    for first in range(0, len(spots), _AT_ONCE):
        if least <= _FARTHER * first:
            break
        some = spots[first : first + _AT_ONCE].tolist()
        across, upward = zip(*some, strict=True)
        near = obstacles.near(
            (
                min(across) - width / 2,
                min(upward) - height / 2,
                max(across) + width / 2,
                max(upward) + height / 2,
            )
        )
        for index, (x, y) in enumerate(some, first):
            demerit = _FARTHER * index + worse[index]
            if demerit < least:
                enough = (least - demerit) / _LABEL_WEIGHT
                cost = _LABEL_WEIGHT * near.under_box(x, y, width, height, enough) + demerit
                best, least = (index, cost) if cost < least else (best, least)
    return best, least


def list_spots_around(
    symbol: str, anchor: Vector, gap: float = 0.0, away: Vector | None = None
) -> Floats:
    """Spots for a symbol around a point, in sixteen directions, nearest first, towards `away`
    first.
    """
    return np.asarray(np.array(anchor) + _list_steps_around(symbol, gap, away))


@lru_cache(maxsize=1024)
def _list_steps_around(symbol: str, gap: float, away: Vector | None) -> Floats:
    """The steps to those spots from any point."""
    half = np.array(measure_symbol(symbol)) / 2
    toward = _TOWARD
    if away is not None:
        toward = _TOWARD[np.argsort(-(_TOWARD @ np.array(away)).round(6), kind="stable")]
    reach = (half / np.maximum(np.abs(toward), 1e-9)).min(axis=1)
    steps = toward * (gap + _RINGS[:, None] + reach)[:, :, None]
    return np.asarray(steps.reshape(-1, 2))


def list_close_spots(symbol: str, anchor: Vector, farthest: float) -> Floats:
    """Spots for a symbol close to a point, in many directions, the nearest to the point first, so
    many millimetres from it at most.
    """
    half = np.array(measure_symbol(symbol)) / 2
    reach = (half / np.maximum(np.abs(_FINELY), 1e-9)).min(axis=1)
    steps = (_FINELY * (_CLOSE_RINGS[:, None] + reach)[:, :, None]).reshape(-1, 2)
    gaps = np.hypot(*np.maximum(np.abs(steps) - half, 0.0).T).round(6)
    order = np.argsort(gaps, kind="stable")
    close = (gaps[order] > _NEAREST) & (gaps[order] < farthest)
    return np.asarray(np.array(anchor) + steps[order][close])


def rate_nearness(
    symbol: str,
    spots: Floats,
    own: Sequence[Vector],
    others: Sequence[Vector],
    least: float = _AMBIGUOUS,
) -> Floats:
    """For each spot 1 where a symbol would stand about as near to another point as to those it
    belongs to, not nearer by the `least` millimetres, else 0.
    """
    if not others:
        return np.zeros(len(spots))
    half = np.array(measure_symbol(symbol)) / 2
    gaps = np.maximum(np.abs(spots[:, None] - np.array([*own, *others])) - half, 0.0)
    distances = np.hypot(gaps[..., 0], gaps[..., 1])
    to_own, to_others = distances[:, : len(own)], distances[:, len(own) :]
    nearer = to_others.min(axis=1) < to_own.min(axis=1) + least
    return np.asarray(nearer, dtype=float)


def list_spots_beside(
    symbol: str,
    start: Vector,
    end: Vector,
    *,
    gaps: tuple[float, ...] = (0.5, 1.7, 3.1),
    stations: int = len(_STATIONS),
) -> Floats:
    """Spots for a symbol beside a line, at each gap near its middle first, on either side."""
    width, height = measure_symbol(symbol)
    line = end - start
    across = line.turned() / length(line) if length(line) > 1e-9 else Vector(0.0, 1.0)
    reach = abs(across.x) * width / 2 + abs(across.y) * height / 2
    along = np.array(start) + np.outer(_STATIONS[:stations], line)
    offsets = np.array([[reach + gap, -reach - gap] for gap in gaps])
    spots: Floats = np.add(along[None, :, None, :], offsets[:, None, :, None] * np.array(across))
    return spots.reshape(-1, 2)


def list_spots_along_arc(symbol: str, bow: Bow) -> Wish:
    """Spots for a symbol outside an arc, then inside it, near its middle first; then around it."""
    half = np.array(measure_symbol(symbol)) / 2
    angles = bow.start + bow.sweep * _BOW_STATIONS
    toward = np.stack((np.cos(angles), np.sin(angles)), axis=1)
    outside = bow.radius + np.abs(toward) @ half
    corners = _CORNERS * half
    across = (corners @ (toward[:, ::-1] * (1.0, -1.0)).T) ** 2
    rows = []
    for side, gap in zip(_BOW_SIDES.tolist(), _BOW_GAPS.tolist(), strict=True):
        if side > 0:
            rows.append(outside + gap)
        else:
            room = np.sqrt(np.maximum((bow.radius - gap) ** 2 - across, 0.0))
            rows.append((room - corners @ toward.T).min(axis=0))
    spots = np.array(bow.centre) + toward * np.array(rows)[:, :, None]
    return Wish(
        symbol, spots.reshape(-1, 2), bow.centre + polar(bow.start + bow.sweep / 2, bow.radius)
    )
