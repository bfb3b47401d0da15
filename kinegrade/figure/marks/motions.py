"""Given straight motions as arrows at a point, each with several alternatives."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from kinegrade.figure.marks.imposed import find_imposed_direction
from kinegrade.figure.mechanism.rails import Rail
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.mark import direction
from kinegrade.figure.placing.obstacles import Obstacles, Segment
from kinegrade.figure.placing.place import (
    Wish,
    list_spots_around,
    list_spots_beside,
    rate_nearness,
    widen,
)
from kinegrade.figure.plane import NEAR, length, mean, unit
from kinegrade.figure.scene import THIN, Bow, Primitive, Strokes
from kinegrade.figure.symbols import HEADS, PIN, draw_arrow
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Moving

_ARROW = 9.0  # millimetres, length of the arrow of a straight motion
# Millimetres from the point to the tail, with their demerits: at its pin, at the free face of its
# block
_AHEAD = {PIN + 0.2: 0.0, 3.4: 1.0}
# Millimetres beside the line of motion, on the free side first, and along it to the tail: level
# with the point, unless a bar leaves it there
_OFFSETS = {3.6: 1.0, -3.6: 1.3, 2.8: 1.6, -2.8: 1.9, 5.0: 2.0, -5.0: 2.3, 6.6: 3.0, -6.6: 3.3}
_SHIFTS = {0.0: 0.0, 2.5: 2.0, 4.0: 4.0}
_BEHIND = 6.0  # demerit of an arrow on the far side of the rail on which its point slides
_FREER = 3.0  # millimetres by which the mechanism lies on one side for the other to be the free one
_OPPOSED = 8.0  # demerit of an arrow that stands tail to tail with another beside its point
# Millimetres between two parallel arrows at one point, and the demerit of less
_APART, _TIGHT = 2.5, 6.0
_ACROSS_ARC = 12.0  # demerit of an arrow across the arc of an angle, which would seem to end there
_MISTAKEN = 3.0  # demerit of a symbol about as near to another arrow at the same point
_LEAST_OFFSET = 1.0  # millimetres from which on an arrow stands beside its point
_BEYOND_TIP = 1  # spots for the symbol there
# Millimetres from a point within which an arrow may lie close to a bar, and sideways its block
_LEAVING, _BLOCK = 3.0, 2.0
# Millimetres to the way past another arrow, and from a rail to that past its hatching
_PAST_ARROW, _PAST_HATCHING = 1.6, 1.4


def add_motions(
    layout: Layout, mechanism: Mechanism, hints: Sequence[Moving], rails: Iterable[Rail] = ()
) -> Layout:
    """The layout with an arrow for each motion of one point, in its direction, and then their
    symbols, each nearest to its own.

    Beside the point an arrow keeps off the line of another one that goes the other way: the two
    would read as a dimension. It stays on the open side of the rail on which the point slides.
    """
    arcs = [line for line in layout.lines if isinstance(line, Bow) and line.pen == THIN]
    around = _Surroundings(tuple(rails), Obstacles.of(arcs))
    arrows: list[_MovingArrow] = []
    for hint in hints:
        ways = [around.rate(arrow.among(arrows)) for arrow in _list_arrows(mechanism, hint)]
        layout, _ = layout.chosen(ways)
        arrows += [mark for mark in layout.marks[-1:] if isinstance(mark, _MovingArrow)]
    for arrow in arrows:
        layout = layout.captioned(arrow.wish_apart([other for other in arrows if other != arrow]))
    return layout


@dataclass(frozen=True)
class _Surroundings:
    """What else decides where an arrow may stand: rails, and the arcs of angles."""

    rails: tuple[Rail, ...]
    angles: Obstacles

    def rate(self, arrow: _MovingArrow) -> _MovingArrow:
        """The arrow with its demerit here; the way to one in the ground is past the hatching."""
        worse, past = 0.0, arrow.past
        if self.angles.lines and self.angles.along(arrow.path(), arrow.shared) > 0:
            worse += _ACROSS_ARC
        for rail in self.rails:
            slides = length(rail.at - arrow.point) < NEAR
            if slides and (arrow.start - rail.at).dot(rail.side) > rail.level:
                worse, past = worse + _BEHIND, max(past, rail.level + _PAST_HATCHING)
        same = not worse and past == arrow.past
        return arrow if same else replace(arrow, demerit=arrow.demerit + worse, past=past)


def _list_arrows(mechanism: Mechanism, hint: Moving) -> list[_MovingArrow]:
    """Arrows in the direction of the motion: from the point, then beside it, first those clear of
    the mechanism; never behind something.
    """
    point = mechanism.points[hint.point]
    toward = (
        unit(direction(mechanism.points, point, hint.along))
        if hint.along
        else find_imposed_direction(mechanism, hint)
    )
    across = toward.turned()
    beyond = (point - mean(mechanism.points.values())).dot(across)
    across = across if beyond > _FREER else -across
    ahead = [
        _MovingArrow(point + toward * gap, toward, hint, demerit, point)
        for gap, demerit in _AHEAD.items()
    ]
    beside = [
        _MovingArrow(point + across * offset + toward * shift, toward, hint, nearby + level, point)
        for offset, nearby in _OFFSETS.items()
        for shift, level in _SHIFTS.items()
    ]
    return [*ahead, *beside]


@dataclass(frozen=True)
class _MovingArrow:
    """A straight arrow from `start` in the direction `toward`."""

    start: Vector
    toward: Vector
    hint: Moving
    demerit: float
    point: Vector
    past: float = _BLOCK
    shared: bool = False

    def among(self, others: Sequence[_MovingArrow]) -> _MovingArrow:
        """The arrow beside others at its point, past which is the way to it."""
        if not others:
            return self
        aside = self._find_aside(self.start)
        levels = [(other, self._find_aside(other.start)) for other in others]
        worse = sum(self._rate_beside(other, aside - level) for other, level in levels)
        within = [abs(level) for _, level in levels if 0 < level * aside < aside**2]
        past = max([self.past, *(level + _PAST_ARROW for level in within)])
        return replace(self, demerit=self.demerit + worse, past=past)

    def path(self) -> tuple[Segment, ...]:
        """The arrow without its start at the pin, which leaves the parts there; beside its point
        the way there as well, past a block: no wall or bar lies between; and the line to its tail.
        """
        away = (self.start + self._end()) / 2 - self.point
        aside = abs(self._find_aside(self.start))
        if aside < _LEAST_OFFSET:
            near = max(0.0, _LEAVING - length(self.start - self.point))
            return ((self.start + self.toward * near, self._end()),)
        past, line = self.point + away * (self.past / aside), self._trace_line(self.past)
        return ((self.start, self._end()), (past, self.point + away), *([line] if line else []))

    def _find_aside(self, at: Vector) -> float:
        """Millimetres from the line of motion to a place, on the left positive."""
        return float((at - self.point).dot(self.toward.turned()))

    def _rate_beside(self, other: _MovingArrow, apart: float) -> float:
        """The demerit of an arrow too close beside another one at its point, or on one line with
        it beside their point, in opposite senses.
        """
        if abs(apart) >= _LEAST_OFFSET:
            return _TIGHT if abs(apart) < _APART else 0.0
        against: bool = self.toward.dot(other.toward) < 0
        beside = abs(self._find_aside(self.start)) >= _LEAST_OFFSET
        return _OPPOSED if against and beside else 0.0

    def wish(self) -> Wish:
        """Beside the arrow, beyond its tip, farther beside it, else around its tip."""
        symbol, end = self.hint.symbol, self._end()
        shaft = list_spots_beside(symbol, self.start + self.toward * 3, end)
        tip = list_spots_around(symbol, end, away=self.toward)[:_BEYOND_TIP]
        close = len(shaft) // 3
        spots = np.concatenate((shaft[:close], tip, shaft[close:]))
        return Wish(symbol, spots, end)

    def wish_apart(self, others: Sequence[_MovingArrow]) -> Wish:
        """The wish, where the symbol cannot be taken for that of another arrow first."""
        if not others:
            return self.wish()
        wish = widen(self.wish())
        near = [at for arrow in others for at in arrow._list_stations()]
        mistaken = rate_nearness(self.hint.symbol, wish.spots, self._list_stations(), near)
        return replace(wish, demerits=_MISTAKEN * mistaken)

    def _list_stations(self) -> list[Vector]:
        """Points along the arrow, a millimetre apart."""
        return [self.start + self.toward * step for step in range(int(_ARROW) + 1)]

    def primitives(self) -> tuple[Primitive, ...]:
        """The shaft and its arrowhead; beside its point also the line from there to its tail."""
        arrow = draw_arrow(self.start, self._end(), HEADS[self.hint.level])
        line = self._trace_line(_BLOCK)
        return (*arrow, Strokes((line,), THIN)) if line else arrow

    def _trace_line(self, past: float) -> Segment | None:
        """The line to the tail of an arrow beside its point, from so many millimetres beside that;
        None where the arrow is nearer.
        """
        aside, step = abs(self._find_aside(self.start)), self.start - self.point
        return (self.point + step * (past / aside), self.start) if aside > past else None

    def _end(self) -> Vector:
        return self.start + self.toward * _ARROW
