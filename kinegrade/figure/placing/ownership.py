"""What a symbol might be read as that of besides its own mark, and what may cut it off from it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from math import ceil

import numpy as np

from kinegrade.figure.placing.extent import measure_symbol
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.place import Floats
from kinegrade.figure.placing.wedge import rate_cut_off
from kinegrade.figure.plane import length
from kinegrade.figure.scene import Disc
from kinegrade.mechanics.vector import Vector

# Demerits of a symbol on the other side of a circle or a bar, and of one nearer to a pin, or to a
# thin line, than to its own mark
_CUT_OFF, _CLAIMED, _AT_LINE = 20.0, 6.0, 4.0
_AT_PIN = 1.0  # millimetres by which a symbol is nearer to its own mark than to the middle of a pin
_STEP = 0.8  # millimetres between the places on a line that are looked at


@dataclass(frozen=True)
class Claims:
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
        worse = np.zeros(len(spots))
        places = np.array([*own, *self.pins, *self.lines])
        half = np.array(measure_symbol(symbol)) / 2
        gaps = np.maximum(np.abs(spots[:, None] - places) - half, 0.0)
        away = np.hypot(gaps[..., 0], gaps[..., 1])
        first, last = len(own), len(own) + len(self.pins)
        gap = away[:, :first].min(axis=1)
        if self.pins:
            worse += _CLAIMED * (away[:, first:last].min(axis=1) < gap + _AT_PIN)
        if self.lines:
            worse += _AT_LINE * (away[:, last:].min(axis=1) < gap)
        middle = own[len(own) // 2]
        for circle in self.circles:
            within = length(middle - circle.centre) < circle.radius
            far = np.hypot(*(spots - np.array(circle.centre)).T)
            worse += _CUT_OFF * ((far < circle.radius) != within)
        if self.bars:
            steps = spots[:, None] - places[:first]
            feet = places[(steps**2).sum(axis=2).argmin(axis=1)]
            worse += _CUT_OFF * rate_cut_off(spots, feet, self.bars)
        return worse


UNCLAIMED = Claims()


def list_places(lines: Iterable[Segment], about: Vector, within: float) -> Iterator[Vector]:
    """Places along lines, as far as they are so many millimetres from a point at most."""
    for start, end in lines:
        count = max(1, ceil(length(end - start) / _STEP))
        for step in range(count + 1):
            at = start + (end - start) * (step / count)
            if length(at - about) < within:
                yield at
