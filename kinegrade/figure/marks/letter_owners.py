"""Letters of points off what would own them: the supports of others, the disc below a follower."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import pairwise

import numpy as np

from kinegrade.figure.joints.symbol import find_fixed_pins
from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.ownership import list_places
from kinegrade.figure.placing.place import Wish, rate_nearness
from kinegrade.figure.plane import NEAR, length
from kinegrade.figure.scene import FIRM, Strokes
from kinegrade.mechanics.vector import Vector

# Demerit of a letter nearer to the support of another point than to its own, by so many millimetres
_AT_SUPPORT, _NEARER = 1.5, 0.8
_WIDEST = 6.0  # millimetres of the base of a support; longer ground is a floor or a guide
_IN_DISC = 0.45  # cost of the letter of a tip in the disc beneath it: no fault
_LOOKED = 16.0  # millimetres about a point in which supports are


def keep_off_supports(
    wish: Wish, at: Vector, points: Mapping[str, Vector], drawing: Drawing
) -> Wish:
    """The wish of a point's letter, rather not nearer to the hatching of another one's support."""
    pins = [points[name] for name in find_fixed_pins(drawing.symbols)]
    foreign = [
        place
        for base, hatching in _list_bases(drawing)
        if _find_owner(base, pins) != at
        for place in list_places([base, hatching], at, _LOOKED)
    ]
    nearer = rate_nearness(wish.symbol, wish.spots, [at], foreign, -_NEARER)
    return wish.worse_by(_AT_SUPPORT * nearer)


def keep_off_disc(wish: Wish, at: Vector, drawing: Drawing) -> Wish:
    """The letter of the tip of a follower, rather not in the disc on which it stands."""
    for rim in drawing.rims:
        if abs(length(at - rim.at) - rim.radius) < NEAR:
            within = np.hypot(*(wish.spots - np.array(rim.at)).T) < rim.radius
            wish = wish.worse_by(_IN_DISC * within)
    return wish


def _list_bases(drawing: Drawing) -> Iterator[tuple[Segment, Segment]]:
    """The ground lines of supports, each with the line of the far ends of its hatching."""
    for hatching, line in pairwise(drawing.ground):
        if isinstance(hatching, Strokes) and isinstance(line, Strokes) and line.pen == FIRM:
            (base,) = line.lines
            start, end = base
            if length(end - start) < _WIDEST:
                yield base, (hatching.lines[0][1], hatching.lines[-1][1])


def _find_owner(base: Segment, pins: list[Vector]) -> Vector | None:
    """The fixed pin whose support has that base."""
    start, end = base
    middle = (start + end) / 2
    return min(pins, key=lambda pin: length(pin - middle), default=None)
