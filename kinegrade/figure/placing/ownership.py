"""What a symbol might be read as that of besides its own mark, and what may cut it off from it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from math import ceil, inf, pi

import numpy as np
from msgspec import Struct
from msgspec.structs import replace

from kinegrade.figure.placing.extent import measure_symbol
from kinegrade.figure.placing.obstacles import COST_LABEL, Obstacles, Segment
from kinegrade.figure.placing.place import Floats
from kinegrade.figure.placing.wedge import rate_cut_off
from kinegrade.figure.plane import length
from kinegrade.figure.scene import BOLD, Disc, Label
from kinegrade.mechanics.vector import Vector

# Demerits of a symbol on the other side of a circle or a bar, and of one nearer to a pin, or to a
# thin line, than to its own mark
_CUT_OFF, _CLAIMED, _AT_LINE = 20.0, 6.0, 4.0
_AT_PIN = 1.0  # millimetres by which a symbol is nearer to its own mark than to the middle of a pin
_STEP = 0.8  # millimetres between the places on a line that are looked at
# Millimetres by which a symbol is clearly nearer to its own line than to anything else, about a
# line that are its own, and from a symbol within which other things are looked for
_CLEARLY, _ITS_OWN, _LOOKED = 0.8, 1.0, 3.0
_ABOUT = 0.8  # millimetres about an earlier letter that lines of other things keep off
CLAIMING = 4.0  # demerit of a line that does not
_SHARES = np.linspace(0.0, 1.0, 17)[:, None]  # of a line, where it is looked at
_ROUND = np.arange(0.0, 2 * pi, pi / 36)  # radians, where a circle is looked at


class Claims(Struct, frozen=True):
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
        places = np.concatenate((np.array(own), _place_others(self.pins, self.lines)))
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


@lru_cache(maxsize=64)
def _place_others(pins: tuple[Vector, ...], lines: tuple[Vector, ...]) -> Floats:
    """The pins, then the places along lines, which are the same for every way to draw a mark."""
    return np.array([*pins, *lines]).reshape(-1, 2)


def list_places(lines: Iterable[Segment], about: Vector, within: float) -> Iterator[Vector]:
    """Places along lines, as far as they are so many millimetres from a point at most."""
    for start, end in lines:
        way = end - start
        count = max(1, ceil(length(way) / _STEP))
        for step in range(count + 1):
            at = start + way * (step / count)
            if length(at - about) < within:
                yield at


def widen_labels(labels: Iterable[Label]) -> Obstacles:
    """Letters with what is about them, where a line of something else would own them."""
    return Obstacles.of(
        replace(each, width=each.width + 2 * _ABOUT, height=each.height + 2 * _ABOUT)
        for each in labels
    )


def rate_beside_line(
    symbol: str, spots: Floats, own: Segment, half: float, drawn: Obstacles
) -> Floats:
    """For each spot of a symbol beside a line, or a link of `half` a width about it, how far it is
    from being clearly nearer to that than to anything else that is drawn: 0 where it is, 1 where
    something else is as near.
    """
    lead = _measure_lead(symbol, spots, own, half, drawn)
    return np.asarray(np.clip(1.0 - lead / _CLEARLY, 0.0, 1.0).round(6))


def is_claimed(label: Label, own: Segment, half: float, drawn: Obstacles) -> bool:
    """Whether a symbol beside a line, or a link of `half` a width about it, is nearer to something
    else that is drawn than to that, or to the edge of the pen of a bar.
    """
    lead = _measure_lead(label.symbol, np.array([label.centre]), own, half, drawn)
    return bool(lead[0] < -BOLD.width / 2)


def _measure_lead(
    symbol: str, spots: Floats, own: Segment, half: float, drawn: Obstacles
) -> Floats:
    """For each spot of a symbol the millimetres by which it is nearer to its own line than to
    anything else; negative where something else is nearer.
    """
    box = np.array(measure_symbol(symbol)) / 2
    low, high = spots.min(axis=0) - box - _LOOKED, spots.max(axis=0) + box + _LOOKED
    places, pens = _sample(drawn.near((*low.tolist(), *high.tolist())))
    foreign = _measure_off(places, own) > half + _ITS_OWN
    if not foreign.any():
        return np.full(len(spots), inf)
    theirs = (_measure_gaps(spots, box, places[foreign]) - pens[foreign]).min(axis=1)
    start, end = (np.array(at) for at in own)
    mine = _measure_gaps(spots, box, start + _SHARES * (end - start)).min(axis=1) - half
    return np.asarray(theirs - mine)


def _sample(drawn: Obstacles) -> tuple[Floats, Floats]:
    """Places along everything but letters, and half the width of the pen at each."""
    lines = np.array([line[4] for line in drawn.lines if line[4][-1] < COST_LABEL]).reshape(-1, 8)
    rings = np.array([ring[4] for ring in drawn.rings]).reshape(-1, 5)
    along = lines[:, None, :2] + _SHARES * lines[:, None, 2:4]
    ways = np.stack((np.cos(_ROUND), np.sin(_ROUND)), axis=1)
    about = rings[:, None, :2] + ways * rings[:, None, 3:4]
    pens = np.repeat(lines[:, 6], len(_SHARES))
    places = np.concatenate((along.reshape(-1, 2), about.reshape(-1, 2)))
    return places, np.concatenate((pens, np.zeros(about.shape[0] * about.shape[1])))


def _measure_off(places: Floats, line: Segment) -> Floats:
    """How far places are from a line."""
    start, end = (np.array(at) for at in line)
    step = end - start
    shares = np.clip((places - start) @ step / max(float(step @ step), 1e-9), 0.0, 1.0)
    return np.asarray(np.hypot(*(places - start - shares[:, None] * step).T))


def _measure_gaps(spots: Floats, half: Floats, places: Floats) -> Floats:
    """The distance from a box about each spot (rows) to each place (columns)."""
    gaps = np.maximum(np.abs(spots[:, None] - places) - half, 0.0)
    return np.asarray(np.hypot(gaps[..., 0], gaps[..., 1]))
