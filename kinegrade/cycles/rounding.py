"""What rounding leaves of zero, by the size of what a mechanism does over its cycle."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from kinegrade.mechanics.rates import Rates
from kinegrade.motion.path import Array, MotionPath
from kinegrade.numbers.floats import Floats
from kinegrade.numbers.units import Unit

_TRIED = 49  # positions that show how fast a mechanism usually is
_NOTHING = 1e-8  # near dead points, rounding leaves as much


@dataclass(frozen=True)
class Scales:
    """The `length` of a mechanism, m, and what its rates, 1/s, and their changes, 1/s^2, usually
    are: the greatest of all, as angles or in its lengths.
    """

    length: float
    rate: float
    change: float

    def clear(self, values: Array, unit: Unit) -> Array:
        """Values in a unit; zero where rounding alone is left of them."""
        paces = {0: 1.0, -1: self.rate, -2: self.rate**2 + self.change}
        usual = self.length**unit.length * paces.get(unit.time, 0.0)
        least = _NOTHING * usual / Floats().scale(unit.scale)
        return np.where(np.abs(values) <= least, 0.0, values)


def find_scales(path: MotionPath) -> Scales:
    """The scales of a path."""
    motion = path.place(path.spread(_TRIED)).motion
    return Scales(path.size, *(_find_usual(path, each) for each in (motion.rates, motion.changes)))


def _find_usual(path: MotionPath, rates: Rates) -> float:
    """What the greatest of some rates usually is."""
    units = path.system.units
    rows = [
        np.broadcast_to(np.abs(np.asarray(rates[rate], dtype=float)) / unit, _TRIED)
        for rate, unit in zip(path.system.rates, units[:-1], strict=True)
    ]
    return float(np.median(np.max(rows, axis=0)))
