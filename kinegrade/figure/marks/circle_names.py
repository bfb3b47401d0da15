"""Where the name of a round body may stand: in its circle, or about its ring."""

from __future__ import annotations

from math import cos, pi

import numpy as np

from kinegrade.figure.joints.symbol import Rim
from kinegrade.figure.placing.extent import measure_symbol
from kinegrade.figure.placing.place import Floats, list_spots_around
from kinegrade.figure.plane import polar
from kinegrade.figure.teeth import TOOTH_TIP

_SHARES = (0.7, 0.55, 0.4)  # of the radius of a circle, for the name of its body
_FINER_SHARES = (0.8, 0.7, 0.6, 0.5, 0.4, 0.3)  # the same, in more directions
# Where the corners of the paper are about a ring, millimetres from its pitch circle to a name
# there, and the share of the name's width and height that reaches towards it
_CORNERS, _CORNER_GAPS = (pi / 4, 3 * pi / 4, -pi / 4), (3.0, 3.6, 4.4, 5.4)
_DIAGONAL = cos(pi / 4) / 2
_AT_TEETH = 0.8  # millimetres between the teeth of a ring and its name


def list_spots_in_circle(symbol: str, rim: Rim) -> Floats:
    """Spots within a circle, then about it."""
    if rim.ring and rim.kind == "gear":
        return _list_spots_at_ring(symbol, rim)
    levels = [rim.radius * share for share in _SHARES]
    inner = [rim.at + polar(pi / 4 * turn, level) for level in levels for turn in range(8)]
    finer = [rim.radius * share for share in _FINER_SHARES] if not rim.ring else []
    inner += [rim.at + polar(pi / 12 * turn, level) for level in finer for turn in range(24)]
    around = list_spots_around(symbol, rim.at, rim.radius)
    return np.concatenate((np.array(inner), around))


def _list_spots_at_ring(symbol: str, ring: Rim) -> Floats:
    """Spots outside a ring in the corners of the paper, which it leaves free, then at its teeth
    and about it.
    """
    size = measure_symbol(symbol)
    levels = [ring.radius + gap + sum(size) * _DIAGONAL for gap in _CORNER_GAPS]
    corners = [ring.at + polar(turn, level) for level in levels for turn in _CORNERS]
    level = ring.radius - TOOTH_TIP - _AT_TEETH - max(size) / 2
    at_teeth = [ring.at + polar(pi / 4 * turn, level) for turn in range(8)]
    around = list_spots_around(symbol, ring.at, ring.radius)
    return np.concatenate((np.array(corners + at_teeth), around))
