"""The arc of an angle, the lines that its sides need, its letter between them or at a leader."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from math import cos, pi

import numpy as np
from msgspec import Struct
from msgspec.structs import replace

from kinegrade.figure.marks.sides import LEFT, SHORT, Side
from kinegrade.figure.placing.aligned import runs_on
from kinegrade.figure.placing.leading import list_spots_at_leader
from kinegrade.figure.placing.mark import chords
from kinegrade.figure.placing.obstacles import COST_LABEL, Obstacles, Segment
from kinegrade.figure.placing.place import LOST, Wish, rate_nearness
from kinegrade.figure.placing.wedge import (
    Wedge,
    list_spots_in_wedge,
    rate_outside,
    rate_parted,
    rate_parted_by_rims,
)
from kinegrade.figure.plane import length, polar, unit
from kinegrade.figure.scene import PITCH, THIN, Bow, Disc, Primitive, Strokes
from kinegrade.figure.symbols.arrows import draw_arc_head, draw_gap
from kinegrade.figure.symbols.bars import BAR_WIDTH
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Angle

_PAST_BAR = 0.9  # millimetres from the round end of a broad bar to a line past it
# Millimetres on either side of the line of a dimension to come that are kept clear of a letter, and
# the demerit of one in there; sine of the angle between a side and a line along it
_LANE, _IN_LANE, _ALONG = 0.22, 1.0, 0.02
_TRIM = 1.5  # millimetres at either end of an arc where it meets its sides, as it should
# Millimetres of the leader from an arc to a letter that has no room at it, and the demerit of one,
# which grows with the millimetres beyond the shortest
_LEADERS, _LED, _LONGER = (4.0, 6.5), 7.0, 0.8
_PLACES = (0.5, 0.3, 0.7)  # of the arc, where its leader ends
_LEAVES = 0.6  # millimetres of a leader at its arc
# Demerits of a letter beyond a bar from its arc, and of one about as near to another arc; radians
# between the points of an arc to which its letter should be near
_PARTED, _MISTAKEN, _STATIONS = 20.0, 6.0, 0.25
_AT_PIN = 5.0  # demerit of a letter nearer to a pin than to its arc
# Demerit of a leader through a side, and millimetres from the end of a side to one that passes it
_THROUGH, _PAST_SIDE = 20.0, 2.0
_AT_OTHER = 3.2  # millimetres from the middle of a letter to the arc of an angle that it would name
# Demerits of a leader that seems to run on from a side or from another thin line, and of one across
# a thin line
_RUNS_ON, _ACROSS = 10.0, 10.0
_LEAST_LEAVING = cos(pi / 3.5)  # of the angle between a leader and the radius at its start
_IN_LETTER = 1.5  # millimetres from the end of a leader to the middle of its letter
_TWELFTHS = tuple(turn * pi / 6 for turn in range(12))


class Neighbours(Struct, frozen=True):
    """What else there is about an angle: circles along which its arc would merge with them, the
    axes of bars, the arcs of other angles, which its letter must not seem to name, thin lines,
    pins, to which it must not seem to belong, and lines that are likely `to_come`.
    """

    circles: tuple[Disc | Bow, ...] = ()
    bars: tuple[Segment, ...] = ()
    arcs: tuple[Bow, ...] = ()
    lines: tuple[Segment, ...] = ()
    pins: tuple[Vector, ...] = ()
    to_come: tuple[Segment, ...] = ()


ALONE = Neighbours()


class AngleArc(Struct, frozen=True):
    """An arc, with an arrowhead when the sense matters, and the thin lines its sides need."""

    bow: Bow
    legs: tuple[Side, ...]
    hint: Angle
    demerit: float
    neighbours: Neighbours = ALONE
    shared: bool = True

    @property
    def wedge(self) -> Wedge:
        """The arc between what is drawn along its sides."""
        return Wedge(self.bow, (self.legs[0].half, self.legs[1].half))

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

    def measure_sides(self) -> tuple[tuple[Vector, float], ...]:
        """The direction of each side, and how far it is drawn."""
        centre = self.bow.centre
        lines = [(leg, leg.line(centre, self.bow.radius)) for leg in self.legs]
        return tuple(
            (polar(leg.angle), length(line[1] - centre) if line else leg.drawn)
            for leg, line in lines
        )

    def _list_far_lines(self) -> Iterator[Segment]:
        bow = self.bow
        for leg in self.legs:
            line = leg.line(bow.centre, bow.radius)
            past = BAR_WIDTH / 2 + _PAST_BAR if leg.broad else LEFT / 2
            near = max(leg.drawn + past if leg.drawn else 0.0, LEFT)
            if line and length(line[1] - bow.centre) > near:
                yield bow.centre + polar(leg.angle) * near, line[1]

    def wish(self) -> Wish:
        """Between the sides, first at this arc and not at another one."""
        wish, near = list_spots_in_wedge(self.hint.symbol, self.wedge), self.neighbours
        if near == ALONE:
            return wish
        others = [at for arc in near.arcs for at in arc.path(_STATIONS)]
        own = self.bow.path(_STATIONS)
        worse = _PARTED * rate_parted(wish.spots, self.bow, near.bars)
        worse += _PARTED * rate_parted_by_rims(wish.spots, self.bow, near.circles)
        worse += _MISTAKEN * rate_nearness(wish.symbol, wish.spots, own, others)
        worse += _AT_PIN * rate_nearness(wish.symbol, wish.spots, own, near.pins, 0.0)
        lanes = self._find_lanes()
        if lanes != self.wedge:
            worse += _IN_LANE * rate_outside(wish.symbol, wish.spots, lanes)
        if wish.demerits is not None:
            worse += wish.demerits
        return replace(wish, demerits=worse)

    def _find_lanes(self) -> Wedge:
        """The arc between what is drawn along its sides, or is to come along them."""
        first, last = (self._measure_half(leg) for leg in self.legs)
        return Wedge(self.bow, (first, last))

    def _measure_half(self, side: Side) -> float:
        """Half the width of what is drawn along a side, or of the lane of a line to come there."""
        to_come = any(self._runs_along(side, *line) for line in self.neighbours.to_come)
        return max(side.half, _LANE if to_come else 0.0)

    def _runs_along(self, side: Side, start: Vector, end: Vector) -> bool:
        """Whether a line from the vertex runs along a side."""
        toward, way = polar(side.angle), unit(end - start)
        return start == self.bow.centre and abs(way.cross(toward)) < _ALONG and way.dot(toward) > 0

    def primitives(self) -> tuple[Primitive, ...]:
        """The sides, those along a broad body as its axis, the arc and its arrowhead, about which
        the edge of such a body is interrupted.
        """
        bow = self.bow
        parts: tuple[Primitive, ...] = ()
        for broad, pen in ((False, THIN), (True, PITCH)):
            legs = (leg for leg in self.legs if leg.broad == broad)
            sides = tuple(line for leg in legs for line in leg.list_seen(bow.centre, bow.radius))
            parts += (Strokes(sides, pen),) if sides else ()
        if self.hint.sense or self.hint.signed:
            head = draw_arc_head(bow)
            last = self.legs[1]
            on_edge = last.edged and bow.radius < last.drawn + BAR_WIDTH / 2
            parts += (draw_gap(head), head) if on_edge else (head,)
        return (*parts, bow)


def add_leaders(arc: AngleArc, cost: float, dear: float) -> Iterator[LedAngleArc]:
    """An arc of some cost with leaders to its letter, the shortest first, and demerits below
    `dear`; none where the arc strikes a label.
    """
    if cost >= COST_LABEL:
        return
    bow = arc.bow
    arc = replace(arc, legs=tuple(replace(leg, beyond=SHORT) for leg in arc.legs))
    outward = [bow.start + share * bow.sweep for share in _PLACES]
    lines = (*arc.neighbours.lines, *arc.list_sides())
    others = Obstacles.of((Strokes(arc.neighbours.lines, THIN),))
    leaving = [(way, turn) for way in outward for turn in (way, *_TWELFTHS)]
    sides = arc.measure_sides()
    for reach in _LEADERS:
        demerit = cost + _LED + _LONGER * (reach - _LEADERS[0])
        if demerit >= dear:
            return
        for way, turn in leaving:
            if abs(cos(turn - way)) > _LEAST_LEAVING:
                start = bow.centre + polar(way, bow.radius)
                led = LedAngleArc(arc, start, turn, reach, demerit)
                worse = _THROUGH * led.crosses(sides) + _RUNS_ON * runs_on(led.line(), lines)
                worse += _ACROSS * (others.along(led.path(), shared=False) > 0)
                yield replace(led, demerit=demerit + worse) if worse else led


class LedAngleArc(Struct, frozen=True):
    """An arc whose letter stands at the end of a leader, where there is no room at the arc; the
    demerit is also for what the arc covers.
    """

    arc: AngleArc
    start: Vector
    turn: float
    reach: float
    demerit: float
    shared: bool = True

    def crosses(self, sides: Iterable[tuple[Vector, float]]) -> bool:
        """Whether the leader, or its letter at its end, crosses a side of the angle as far as that
        is drawn.
        """
        start = self.start - self.arc.bow.centre
        step = polar(self.turn, self.reach + _IN_LETTER)
        for toward, drawn in sides:
            aside, further = start.cross(toward), step.cross(toward)
            if aside * (aside + further) <= 0:
                at = start + step * (-aside / further)
                if 0 < at.dot(toward) < drawn + _PAST_SIDE:
                    return True
        return False

    def path(self) -> tuple[Segment, ...]:
        """The leader without its start at the arc."""
        return ((self.start + polar(self.turn, _LEAVES), self._end()),)

    def wish(self) -> Wish:
        """Around the far end of the leader, rather not at the arc of another angle; lost outside
        its own, where it would seem to name another one.
        """
        symbol, toward = self.arc.hint.symbol, polar(self.turn)
        spots = list_spots_at_leader(symbol, self._end(), toward)
        worse = LOST * rate_outside(symbol, spots, self.arc.wedge)
        others = [at for arc in self.arc.neighbours.arcs for at in arc.path(_STATIONS)]
        beside = [any(length(Vector(*spot) - at) < _AT_OTHER for at in others) for spot in spots]
        return Wish(symbol, spots, demerits=worse + _MISTAKEN * np.array(beside))

    def primitives(self) -> tuple[Primitive, ...]:
        """The arc with the lines of its sides, and the leader."""
        return (*self.arc.primitives(), Strokes((self.line(),), THIN))

    def line(self) -> Segment:
        """The leader."""
        return (self.start, self._end())

    def _end(self) -> Vector:
        return self.start + polar(self.turn, self.reach)
