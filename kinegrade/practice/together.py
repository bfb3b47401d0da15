"""Places that go with two others, as those of one body do: such a place is written by these."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from kinegrade.motion.path import Array

_Places = NDArray[np.complex128]  # x + iy, at all positions

_SAME = 1.5  # steps: what rounding alone makes of a place that is written by two others
_MOST_OFF = 2.0  # of what the others are off, at most
_DIGITS = 9  # after the point


@dataclass(frozen=True)
class Together:
    """A place by two others: so much of the way from the first to the second, and across it, which
    is a quarter turn on from x to y.
    """

    first: int
    second: int
    along: float
    across: float

    def __str__(self) -> str:
        return f"{self.first} {self.second} {self.along:.{_DIGITS}g} {self.across:.{_DIGITS}g}"


def find_together(steps: Array, kept: Collection[int]) -> dict[int, Together]:
    """The places that go with two of those which are written; `steps` has rows of x and y, not
    rounded. The `kept` are always written, and what stays is.
    """
    exact = steps[0::2] + 1j * steps[1::2]
    rounded = np.rint(steps[0::2]) + 1j * np.rint(steps[1::2])
    written = sorted(kept)
    found: dict[int, Together] = {}
    for number in range(len(exact)):
        if number in kept:
            continue
        ways = () if _stays(rounded[number]) else _list_ways(exact[number], rounded, written)
        way = next(iter(ways), None)
        if way is None:
            written.append(number)
        else:
            found[number] = way
    return found


def _stays(place: _Places) -> bool:
    return bool((place == place[0]).all())


def _list_ways(place: _Places, others: _Places, written: Collection[int]) -> Iterator[Together]:
    """The pairs that the place goes with at all positions, and how."""
    for first, second in combinations(written, 2):
        way, from_first = others[second] - others[first], place - others[first]
        if not way.any():
            continue
        share = complex(np.vdot(way, from_first) / np.vdot(way, way))
        off = float(np.abs(from_first - share * way).max())
        if off <= _SAME and abs(share) + abs(1 - share) <= _MOST_OFF:
            yield Together(first, second, share.real, share.imag)
