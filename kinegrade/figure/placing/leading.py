"""The symbol at the far end of a leader, which points at it and does not run along under it."""

from __future__ import annotations

import numpy as np

from kinegrade.figure.placing.extent import measure_symbol
from kinegrade.figure.placing.place import Floats, list_spots_around
from kinegrade.mechanics.vector import Vector

_AT_END = -0.6  # millimetres by which a symbol stands closer to its leader than to a point
_AROUND = 6  # spots about the end of a leader, those ahead first
_WITHIN = 0.85  # share of a symbol's half in which the leader has to meet it


def list_spots_at_leader(symbol: str, end: Vector, toward: Vector) -> Floats:
    """Spots for a symbol at the end of a leader in a direction (a unit vector), the one straight
    ahead first.
    """
    spots = list_spots_around(symbol, end, _AT_END, toward)[:_AROUND]
    wide, high = measure_symbol(symbol)
    steps, across = spots - np.array(end), toward.turned()
    half = (abs(across.x) * wide + abs(across.y) * high) / 2
    met = np.abs(steps @ np.array(across)) <= _WITHIN * half
    met[0] = True
    return np.asarray(spots[met])
