"""Distances between points: dimension lines at several distances, or the symbol next to a drawn
line or at the end of a leader.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from math import copysign, pi
from typing import assert_never

from kinegrade.figure.placing.mark import Mark
from kinegrade.figure.placing.obstacles import Obstacles, Segment
from kinegrade.figure.placing.place import Wish, list_spots_around, list_spots_beside
from kinegrade.figure.plane import NEAR, length, nearest_of, polar, unit
from kinegrade.figure.scene import THIN, Primitive, Strokes
from kinegrade.figure.symbols import HEAD_LENGTH, draw_arrowhead
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Length, Projection

# Millimetres, of dimension lines
_OFFSETS = tuple(
    side * offset
    for offset in (5.5, 8.0, 10.5, 13.0, 16.0, 19.5, 23.0, 26.5)
    for side in (1.0, -1.0)
)
_LEAVING = 1.6  # millimetres from a point to its extension line, where nothing is in the way
# Millimetres around a point in which its support is, in steps, and from there to the line
_SUPPORT, _PROBES, _OUTSIDE = (7.0, 10, 0.5)
_SHORT = 4.0  # millimetres of a gap that still leave room for a line of the least offset
# Millimetres, of the leader from a symbol to a bar with no room next to it
_LEADERS = (6.0, 9.0)
_TURNS = tuple(turn * pi / 6 for turn in range(12))
_DRAWN_GAP = 2.5  # millimetres by which a line between two points may miss either of them


def _measure(along: Projection | None, start: Vector, end: Vector) -> Vector:
    """The direction in which a distance is measured."""
    match along:
        case "horizontal":
            return Vector(1.0, 0.0)
        case "vertical":
            return Vector(0.0, 1.0)
        case None:
            return unit(end - start)
        case _:
            assert_never(along)


def mark_lengths(at: Mapping[str, Vector], hint: Length, drawn: Obstacles) -> list[Mark]:
    """Dimension lines, and the symbol alone where a line is drawn exactly between the two
    points.
    """
    start, end = at[hint.start], at[hint.end]
    measured = _measure(hint.along, start, end)
    backwards = hint.signed and measured.dot(end - start) < 0
    symbol = rf"\left|{hint.symbol}\right|" if backwards else hint.symbol
    gaps = {
        side: (
            _find_gap(start, measured.turned() * side, drawn),
            _find_gap(end, measured.turned() * side, drawn),
        )
        for side in (1.0, -1.0)
    }
    found: list[Mark] = [
        _draw_dimension((start, end), measured, offset, symbol, gaps[copysign(1.0, offset)])
        for offset in _OFFSETS
    ]
    others = [point for name, point in at.items() if name not in (hint.start, hint.end)]
    whole = hint.along is None and not _between(start, end, others)
    if whole and drawn.joins(start, end, _DRAWN_GAP):
        found.append(_Lettered(start, end, symbol))
        found += [
            _Leader((start + end) / 2, angle, reach, symbol)
            for reach in _LEADERS
            for angle in _TURNS
        ]
    return found


def _find_gap(point: Vector, away: Vector, drawn: Obstacles) -> float:
    """How far from a point an extension line begins: beyond a support that stands there."""
    (x, y), last = point, _LEAVING
    near = drawn.near((x - _SUPPORT, y - _SUPPORT, x + _SUPPORT, y + _SUPPORT))
    for step in range(1, _PROBES + 1):
        reach = _SUPPORT * step / _PROBES
        if near.under_box(x + away.x * reach, y + away.y * reach, 0.2, 0.2) > 0:
            last = max(last, reach + _OUTSIDE)
    return last


def _draw_dimension(
    points: Segment, measured: Vector, offset: float, symbol: str, gaps: tuple[float, float]
) -> _Dimension:
    """The dimension line at an offset from the outer one of the two points, outside supports."""
    across = measured.turned()
    offset += copysign(max(0.0, max(gaps) - _SHORT), offset)
    outer = max if offset > 0 else min
    level = outer(across.dot(point) for point in points) + offset
    feet = [point + across * (level - across.dot(point)) for point in points]
    return _Dimension(points, (feet[0], feet[1]), symbol, 0.3 * abs(offset), gaps)


def _between(start: Vector, end: Vector, others: Iterable[Vector]) -> bool:
    """Whether one of the other points divides the line, so that a letter beside it could mean only
    a part of it.
    """
    return any(
        length(point - nearest_of(point, start, end)) < NEAR
        and length(point - start) > NEAR < length(point - end)
        for point in others
    )


@dataclass(frozen=True)
class _Dimension:
    """Extension lines from two points to their feet, and the dimension line between the feet."""

    points: Segment
    feet: Segment
    symbol: str
    demerit: float
    gaps: tuple[float, float]
    shared: bool = True

    def path(self) -> tuple[Segment, ...]:
        """The dimension line, and the extension lines from where they leave their points."""
        return (self._line(), *self._extensions())

    def wish(self) -> Wish:
        """Beside the dimension line."""
        return Wish(self.symbol, list_spots_beside(self.symbol, *self._line()))

    def primitives(self) -> tuple[Primitive, ...]:
        """Thin lines and two arrowheads, from outside where there is no room between the feet."""
        along = unit(self.feet[1] - self.feet[0]) * (1.0 if self._outside() else -1.0)
        heads = (draw_arrowhead(self.feet[0], along), draw_arrowhead(self.feet[1], -along))
        return (Strokes((*self._extensions(), self._line()), THIN), *heads)

    def _outside(self) -> bool:
        return length(self.feet[1] - self.feet[0]) < 2 * HEAD_LENGTH + 1.5

    def _line(self) -> Segment:
        tail = unit(self.feet[1] - self.feet[0]) * (3.0 if self._outside() else 0.0)
        return (self.feet[0] - tail, self.feet[1] + tail)

    def _extensions(self) -> tuple[Segment, ...]:
        """From a gap beyond each point to a little beyond its foot."""
        found = []
        for point, end, gap in zip(self.points, self.feet, self.gaps, strict=True):
            away = unit(end - point)
            if length(end - point) > gap + 0.9:
                found.append((point + away * gap, end + away * 1.2))
        return tuple(found)


@dataclass(frozen=True)
class _Lettered:
    """The symbol alone, close to a line that is drawn between the two points, where the most room
    is.
    """

    start: Vector
    end: Vector
    symbol: str
    demerit: float = 0.0
    shared: bool = True

    def path(self) -> tuple[Segment, ...]:
        """Empty: no line is drawn."""
        return ()

    def wish(self) -> Wish:
        """Close beside the line."""
        return Wish(
            self.symbol,
            list_spots_beside(self.symbol, self.start, self.end, gaps=(0.8, 1.3), stations=5),
        )

    def primitives(self) -> tuple[Primitive, ...]:
        """Empty: no line is drawn."""
        return ()


@dataclass(frozen=True)
class _Leader:
    """The symbol at the end of a leader to the middle of a bar, for bars that are short and
    crowded.
    """

    middle: Vector
    angle: float
    reach: float
    symbol: str
    shared: bool = True

    @property
    def demerit(self) -> float:
        """Higher than that of any unobstructed dimension line."""
        return 1.0 * self.reach

    def path(self) -> tuple[Segment, ...]:
        """The leader without its start, which touches the bar in any case."""
        return ((self.middle + polar(self.angle, 1.5), self._end()),)

    def wish(self) -> Wish:
        """Around the far end."""
        return Wish(
            self.symbol, list_spots_around(self.symbol, self._end(), away=polar(self.angle))[:6]
        )

    def primitives(self) -> tuple[Primitive, ...]:
        """The leader."""
        return (Strokes(((self.middle, self._end()),), THIN),)

    def _end(self) -> Vector:
        return self.middle + polar(self.angle, self.reach)
