"""The arc of an angle, the lines that its sides need, its letter between them or at a leader."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import product
from math import pi

from kinegrade.figure.marks.sides import LEFT, Side
from kinegrade.figure.placing.mark import chords
from kinegrade.figure.placing.obstacles import COST_LABEL, Obstacles, Segment
from kinegrade.figure.placing.place import Wish, list_spots_around
from kinegrade.figure.placing.wedge import list_spots_in_wedge
from kinegrade.figure.plane import length, polar
from kinegrade.figure.scene import THIN, Bow, Primitive, Strokes
from kinegrade.figure.symbols import draw_arc_head
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Angle

_TRIM = 1.5  # millimetres at either end of an arc where it meets its sides, as it should
# Millimetres of the leader from an arc to a letter that has no room at it, and the demerit of one,
# which grows with the millimetres beyond the shortest
_LEADERS, _LED, _LONGER = (4.0, 6.5), 7.0, 0.8
_PLACES = (0.5, 0.3, 0.7)  # of the arc, where its leader ends
_LEAVES, _AT_END = 0.6, -0.6  # millimetres of a leader at its arc, and from its end to the letter
_TWELFTHS = tuple(turn * pi / 6 for turn in range(12))


@dataclass(frozen=True)
class AngleArc:
    """An arc, with an arrowhead when the sense matters, and the thin lines its sides need."""

    bow: Bow
    legs: tuple[Side, ...]
    hint: Angle
    demerit: float
    shared: bool = True

    def path(self) -> tuple[Segment, ...]:
        """The arc between its sides, and the lines along them beyond what leaves the vertex."""
        bow = self.bow
        inset = min(_TRIM / bow.radius, abs(bow.sweep) / 3)
        inset = inset if bow.sweep > 0 else -inset
        arc = chords(replace(bow, start=bow.start + inset, sweep=bow.sweep - 2 * inset))
        return (*arc, *self._list_far_lines())

    def list_sides(self) -> tuple[Segment, ...]:
        """The thin lines along its sides."""
        bow = self.bow
        return tuple(line for leg in self.legs if (line := leg.line(bow.centre, bow.radius)))

    def _list_far_lines(self) -> Iterator[Segment]:
        bow = self.bow
        for leg in self.legs:
            line = None if leg.broad else leg.line(bow.centre, bow.radius)
            near = max(leg.drawn + LEFT / 2 if leg.drawn else 0.0, LEFT)
            if line and length(line[1] - bow.centre) > near:
                yield bow.centre + polar(leg.angle) * near, line[1]

    def wish(self) -> Wish:
        """Between the sides."""
        return list_spots_in_wedge(self.hint.symbol, self.bow)

    def primitives(self) -> tuple[Primitive, ...]:
        """The sides, the arrowhead, the arc."""
        bow = self.bow
        sides = self.list_sides()
        parts: tuple[Primitive, ...] = (Strokes(sides, THIN),) if sides else ()
        if self.hint.sense or self.hint.signed:
            parts += (draw_arc_head(bow),)
        return (*parts, bow)


def add_leaders(arc: AngleArc, obstacles: Obstacles, dear: float) -> Iterator[LedAngleArc]:
    """An arc with leaders to its letter, the shortest first, and demerits below `dear`; none where
    the arc strikes a label.
    """
    covered = obstacles.along(arc.path(), arc.shared)
    if covered >= COST_LABEL:
        return
    bow = arc.bow
    starts = [bow.centre + polar(bow.start + share * bow.sweep, bow.radius) for share in _PLACES]
    for reach in _LEADERS:
        demerit = arc.demerit + covered + _LED + _LONGER * (reach - _LEADERS[0])
        if demerit >= dear:
            return
        for start, turn in product(starts, _TWELFTHS):
            yield LedAngleArc(arc, start, turn, reach, demerit)


@dataclass(frozen=True)
class LedAngleArc:
    """An arc whose letter stands at the end of a leader, where there is no room at the arc; the
    demerit is also for what the arc covers.
    """

    arc: AngleArc
    start: Vector
    turn: float
    reach: float
    demerit: float
    shared: bool = True

    def path(self) -> tuple[Segment, ...]:
        """The leader without its start at the arc."""
        return ((self.start + polar(self.turn, _LEAVES), self._end()),)

    def wish(self) -> Wish:
        """Around the far end of the leader."""
        symbol, toward = self.arc.hint.symbol, polar(self.turn)
        return Wish(symbol, list_spots_around(symbol, self._end(), _AT_END, toward)[:6])

    def primitives(self) -> tuple[Primitive, ...]:
        """The arc with the lines of its sides, and the leader."""
        return (*self.arc.primitives(), Strokes(((self.start, self._end()),), THIN))

    def _end(self) -> Vector:
        return self.start + polar(self.turn, self.reach)
