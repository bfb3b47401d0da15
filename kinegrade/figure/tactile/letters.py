"""Where a Braille label may stand: close to what it names, or at the end of a thin line to it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from math import pi

from kinegrade.figure.plane import polar, unit
from kinegrade.figure.scene import Bow, Strokes
from kinegrade.figure.tactile.braille import measure_label
from kinegrade.figure.tactile.piece import Way
from kinegrade.figure.tactile.sizes import CLEAR, MARK, PIN
from kinegrade.mechanics.vector import Vector

_TURNS = tuple(number * pi / 12 for number in (3, 9, 15, 21, 0, 6, 12, 18, 2, 4, 8, 10, 14, 16, 20))
_ALL_TURNS = tuple(number * pi / 24 for number in range(48))
_NEAR = (0.2, 2.0, 4.0)  # millimetres beyond the least distance from a dot
_LED = (10.0, 15.0, 20.0, 26.0, 33.0, 41.0, 50.0)  # length of a line that leads to a label
_SHARES = (0.5, 0.35, 0.65, 0.22, 0.78)
_BESIDE = (0.2, 2.5, 5.0, 9.5, 13.5)  # millimetres beyond the least distance from a line


def list_letter_ways(cells: str, at: Vector, radius: float = PIN) -> Iterator[Way]:
    """Labels around a dot of that radius, then at the end of lines that lead to it."""
    close = [
        at + polar(turn, radius + CLEAR + more + _reach(cells, polar(turn)))
        for more in _NEAR
        for turn in _TURNS
    ]
    yield Way((), alone(close))
    yield from list_led_ways(cells, at)


def list_led_ways(cells: str, at: Vector) -> Iterator[Way]:
    """Labels at the end of lines that lead to a point."""
    for size in _LED:
        for turn in _ALL_TURNS:
            toward = polar(turn)
            leader = Strokes(((at, at + toward * size),), MARK)
            label = at + toward * (size + MARK.width / 2 + CLEAR + 0.1 + _reach(cells, toward))
            yield Way((leader,), ((label,),))


def alone(spots: Iterable[Vector]) -> tuple[tuple[Vector], ...]:
    """The places of a single label at these spots."""
    return tuple((spot,) for spot in spots)


def list_beside(cells: str, start: Vector, end: Vector, half: float) -> Iterator[Vector]:
    """The middles of labels beside a line of that half width, then beyond its ends."""
    along = unit(end - start)
    for more in _BESIDE:
        for share in _SHARES:
            for across in (along.turned(), -along.turned()):
                away = half + CLEAR + more + _extent(cells, across)
                yield start + (end - start) * share + across * away
    for tip, toward in ((end, along), (start, -along)):
        yield tip + toward * (half + 2 * CLEAR + _extent(cells, toward))


def list_along_arc(cells: str, bow: Bow, half: float) -> Iterator[Vector]:
    """The middles of labels outside an arc of that half width, then inside it."""
    for more in _BESIDE:
        for side in (1.0, -1.0):
            for share in _SHARES:
                toward = polar(bow.start + share * bow.sweep)
                away = half + CLEAR + more + _extent(cells, toward)
                if bow.radius + side * away > 0:
                    yield bow.centre + toward * (bow.radius + side * away)


def _reach(cells: str, toward: Vector) -> float:
    """From the middle of a label to its edge, against a direction."""
    width, height = measure_label(cells)
    sides = (width / 2 / max(abs(toward.x), 1e-9), height / 2 / max(abs(toward.y), 1e-9))
    return float(min(sides))


def _extent(cells: str, toward: Vector) -> float:
    """Half of what a label takes across a direction."""
    width, height = measure_label(cells)
    return float(abs(toward.x) * width / 2 + abs(toward.y) * height / 2)
