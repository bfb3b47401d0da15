"""What a symbol might be read as that of besides its own mark, and what may cut it off from it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from math import ceil

import numpy as np

from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.place import Floats, rate_nearness
from kinegrade.figure.placing.wedge import rate_cut_off
from kinegrade.figure.plane import length
from kinegrade.figure.scene import Disc
from kinegrade.mechanics.vector import Vector

# Demerits of a symbol on the other side of a circle or a bar, and of one nearer to a pin or to a
# thin line than to its own mark
_CUT_OFF, _CLAIMED = 20.0, 6.0
_AT_PIN = 1.0  # millimetres by which a symbol is nearer to its own mark than to the middle of a pin
_STEP = 0.8  # millimetres between the places on a line that are looked at


@dataclass(frozen=True)
class Surroundings:
    """The outlines of discs and the axes of bars, which may part a symbol from its mark; the pins
    and, as places along them, the thin lines that it may seem to belong to.
    """

    circles: tuple[Disc, ...] = ()
    bars: tuple[Segment, ...] = ()
    pins: tuple[Vector, ...] = ()
    lines: tuple[Vector, ...] = ()

    def rate(self, symbol: str, spots: Floats, own: Sequence[Vector]) -> Floats:
        """For each spot of a symbol the demerit of its not being read as that of a mark, which is
        given by places along that.
        """
        worse = _CLAIMED * rate_nearness(symbol, spots, own, self.pins, _AT_PIN)
        worse += _CLAIMED * rate_nearness(symbol, spots, own, self.lines, 0.0)
        middle = own[len(own) // 2]
        for circle in self.circles:
            within = length(middle - circle.centre) < circle.radius
            away = np.hypot(*(spots - np.array(circle.centre)).T)
            worse += _CUT_OFF * ((away < circle.radius) != within)
        if self.bars:
            steps = spots[:, None] - np.array(own)
            feet = np.array(own)[np.hypot(steps[..., 0], steps[..., 1]).argmin(axis=1)]
            worse += _CUT_OFF * rate_cut_off(spots, feet, self.bars)
        return worse


UNCLAIMED = Surroundings()


def list_places(lines: Iterable[Segment], about: Vector, within: float) -> Iterator[Vector]:
    """Places along lines, as far as they are so many millimetres from a point at most."""
    for start, end in lines:
        count = max(1, ceil(length(end - start) / _STEP))
        for step in range(count + 1):
            at = start + (end - start) * (step / count)
            if length(at - about) < within:
                yield at
