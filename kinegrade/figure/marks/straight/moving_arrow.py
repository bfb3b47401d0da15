"""A given straight motion as one arrow at its point or beside it, tied to it by a thin line."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from msgspec import Struct
from msgspec.structs import replace

from kinegrade.figure.mechanism.rails import Rail
from kinegrade.figure.placing.extent import measure_symbol
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.place import (
    LOST,
    Wish,
    list_spots_around,
    list_spots_beside,
    rate_nearness,
    widen,
)
from kinegrade.figure.plane import NEAR, length
from kinegrade.figure.scene import THIN, Disc, Outline, Primitive, Strokes
from kinegrade.figure.symbols.arrows import HEAD_LENGTH, HEADS, draw_arrow
from kinegrade.figure.symbols.pins import PIN
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Moving

ARROW = 9.0  # millimetres, length of the arrow of a straight motion
# Demerits of an arrow that stands tail to tail with another beside its point, or lies over it
_OPPOSED, _OVER = 8.0, 100.0
# Millimetres between two parallel arrows at one point, and the demerit of less; the same where
# their heads meet
_APART, _TIGHT = 2.5, 6.0
_HEADS_APART, _HEADS_MEET = 1.5, 40.0
_ACROSS_ROD = 2.2  # millimetres between two at their point with a rod between them
# Millimetres between two of one sense that leave room for a symbol, and the demerit of less
_ROOM_FOR_SYMBOL, _IN_BETWEEN = 4.8, 4.0
_MISTAKEN = 20.0  # demerit of a symbol about as near to another arrow at the same point
_NEARER = 0.5  # millimetres by which a symbol is nearer to its own arrow than to another one
_CLAIMED = 4.0  # millimetres past the tip of an arrow that are its own
# Demerit of a symbol on the other side of the rail of the arrow's point, and millimetres of paper
# between an end of the rail and a symbol for which there is no other side
_PARTED, _PAST_END = LOST, 0.4
_LEAST_OFFSET = 1.3  # millimetres from which on an arrow stands beside its point
_ONE_LINE = 1.0  # millimetres within which two arrows lie on one line
# Millimetres by which an arrow is longer than another one on whose line it is, and the demerit
_LONGER, _ON_ONE_LINE = 8.5, 45.0
# Spots for the symbol there, and about the tip of one of two arrows
_BEYOND_TIP, _AROUND_TIP = 1, 6
# Millimetres from a point within which an arrow may lie close to a bar, and sideways its block
LEAVING, _BLOCK = 3.0, 2.4
# Millimetres from the ground between which hatching is cleared, and on either side of a line there
_HATCHING, _CLEARED = (0.3, 1.5), 0.9
_OFF_PIN = 0.2  # millimetres between a pin and the line from it to a tail
_ABOUT_HEAD = 0.5  # millimetres about a head that keep off what would merge with it
_PAST_ARROW = 1.6  # millimetres from an arrow to the way past it


class MovingArrow(Struct, frozen=True):
    """A straight arrow from `start` in the direction `toward`; `ground` is how far from its point
    the ground is that lies between them, 0 for none, and `leaving` from where on it keeps off bars.
    Where a `short` one from the same point lies on it, that is the length of that one; its symbol
    stands from `lettered` on. One of two beside one another at their point has the other one on the
    side that is not `outward`.
    """

    start: Vector
    toward: Vector
    hint: Moving
    demerit: float
    point: Vector
    past: float = _BLOCK
    ground: float = 0.0
    size: float = ARROW
    leaving: float = LEAVING
    short: float = 0.0
    lettered: float = 3.0
    outward: Vector | None = None

    @property
    def shared(self) -> bool:
        """Whether it may lie on an axis or another thin line: where it begins at its point."""
        return self.is_ahead()

    def among(self, others: Sequence[MovingArrow]) -> MovingArrow:
        """The arrow beside others at its point, past which is the way to it."""
        if not others:
            return self
        if any(other.point != self.point and other.toward.dot(self.toward) > 0 for other in others):
            return replace(self, demerit=self.demerit + _OVER)
        aside = self._find_aside(self.start)
        for other in others:
            apart = aside - self._find_aside(other.start)
            alike = self.toward.dot(other.toward) > 0 and abs(apart) < _ONE_LINE
            if self.is_ahead() and other.is_ahead() and alike:
                worse = self.demerit + _ON_ONE_LINE
                return replace(self, size=other.size + _LONGER, short=other.size, demerit=worse)
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
        if self.is_ahead():
            near = max(self.leaving - (self.start - self.point).dot(self.toward), self.short)
            return ((self.start + self.toward * near, self._end()),)
        past, line = self.point + away * (self.past / aside), self._trace_line(self.past)
        return ((self.start, self._end()), (past, self.point + away), *([line] if line else []))

    def list_unseen(self) -> tuple[Segment, ...]:
        """The piece of an arrow past the parts at its point that may lie close to a bar."""
        if not self.is_ahead() or self.leaving <= LEAVING:
            return ()
        level = self.start - self.toward * (self.start - self.point).dot(self.toward)
        return ((level + self.toward * LEAVING, level + self.toward * self.leaving),)

    def head(self, about: float = _ABOUT_HEAD) -> Segment:
        """The piece under its arrowheads and so many millimetres about them."""
        heads = HEAD_LENGTH * HEADS[self.hint.level] + about
        return (self._end() - self.toward * heads, self._end() + self.toward * about)

    def is_ahead(self) -> bool:
        """Whether it begins at its point, ahead of which it stands."""
        return self.outward is not None or abs(self._find_aside(self.start)) < _LEAST_OFFSET

    def is_level(self) -> bool:
        """Whether its tail is level with its point, or on its line of motion."""
        return bool(abs((self.start - self.point).dot(self.toward)) < NEAR)

    def _find_aside(self, at: Vector) -> float:
        """Millimetres from the line of motion to a place, on the left positive."""
        return float((at - self.point).dot(self.toward.turned()))

    def _rate_beside(self, other: MovingArrow, apart: float) -> float:
        """The demerit of an arrow too close beside another one at its point, or on one line with
        it: over it, or beside their point in opposite senses.
        """
        alike = self.toward.dot(other.toward) >= 0
        both_ahead = self.is_ahead() and other.is_ahead()
        if both_ahead and (not alike or abs(apart) >= _ACROSS_ROD):
            return 0.0
        if abs(apart) >= _ONE_LINE:
            tight = _HEADS_MEET if abs(apart) < _HEADS_APART else _TIGHT
            level = _IN_BETWEEN if alike and abs(apart) < _ROOM_FOR_SYMBOL else 0.0
            return tight if abs(apart) < _APART else level
        if alike:
            return _OVER
        beside = abs(self._find_aside(self.start)) >= _LEAST_OFFSET
        return _OPPOSED if beside else 0.0

    def wish(self) -> Wish:
        """Beside the arrow, away from one beside it, beyond its tip, farther beside it, else around
        its tip.
        """
        symbol, end, outward = self.hint.symbol, self._end(), self.outward
        lettered = self.start + self.toward * max(self.lettered, self.short)
        shaft = list_spots_beside(symbol, lettered, end)
        away, count = self.toward, _BEYOND_TIP
        if outward:
            shaft = shaft[(shaft - np.array(self.start)) @ np.array(outward) > 0]
            away, count = away + outward, _AROUND_TIP
        tip = list_spots_around(symbol, end, away=away)[:count]
        close = len(shaft) // 3
        return Wish(symbol, np.concatenate((shaft[:close], tip, shaft[close:])), end)

    def wish_apart(self, others: Sequence[MovingArrow], rails: Sequence[Rail] = ()) -> Wish:
        """The wish, where the symbol cannot be taken for that of another arrow first, and no rail
        of its point parts them.
        """
        if not others and not rails:
            return self.wish()
        wish = widen(self.wish())
        near = [at for arrow in others for at in arrow.list_claimed()]
        own = self.list_stations()
        mistaken = rate_nearness(self.hint.symbol, wish.spots, own, near, _NEARER)
        parted, (width, height) = np.zeros(len(wish.spots)), measure_symbol(self.hint.symbol)
        for rail in rails:
            levels = (wish.spots - np.array(rail.at)) @ np.array(rail.side)
            behind = (self.start - rail.at).dot(rail.side) > rail.level
            steps = (wish.spots - np.array(rail.at)) @ np.array(rail.along)
            first, last = sorted((end - rail.at).dot(rail.along) for end in (rail.start, rail.end))
            reach = _PAST_END + abs(rail.along.x) * width / 2 + abs(rail.along.y) * height / 2
            before = (steps > first - reach) & (steps < last + reach)
            parted = np.maximum(parted, before & ((levels > rail.level) != behind))
        return replace(wish, demerits=_MISTAKEN * mistaken + _PARTED * parted)

    def list_stations(self) -> list[Vector]:
        """Points along the arrow, a millimetre apart, past a short one that lies on it."""
        steps = range(round(self.short), int(self.size) + 1)
        return [self.start + self.toward * step for step in steps]

    def is_past(self, at: Vector) -> bool:
        """Whether a place lies past its tip on its line."""
        step = at - self.start
        return bool(
            step.dot(self.toward) > self.size + _ONE_LINE
            and abs(step.cross(self.toward)) < _ONE_LINE
        )

    def lies_in(self, disc: Disc) -> bool:
        """Whether all of it lies within a circle."""
        ends = (self.start, self._end())
        return all(length(end - disc.centre) < disc.radius for end in ends)

    def list_claimed(self) -> list[Vector]:
        """Those and places just past its tip, where the symbol of another one would seem its."""
        beyond = range(int(self.size) + 1, int(self.size + _CLAIMED) + 1)
        return [*self.list_stations(), *(self.start + self.toward * step for step in beyond)]

    def primitives(self) -> tuple[Primitive, ...]:
        """The shaft and its arrowhead; beside its point also the line from there to its tail."""
        arrow = draw_arrow(self.start, self._end(), HEADS[self.hint.level])
        if self.is_ahead():
            return arrow
        line = self._trace_line(self._find_aside_at_pin())
        if not line:
            return arrow
        return (*arrow, *self._clear_hatching(), Strokes((line,), THIN))

    def _clear_hatching(self) -> tuple[Primitive, ...]:
        """White in the hatching through which the line to the tail passes."""
        if not self.ground:
            return ()
        away = (self.start - self.point) / abs(self._find_aside(self.start))
        near, far = (self.point + away * (self.ground + each) for each in _HATCHING)
        beside = self.toward * _CLEARED
        return (Outline((near - beside, far - beside, far + beside, near + beside), None, "white"),)

    def _trace_line(self, past: float) -> Segment | None:
        """The line to the tail of an arrow beside its point, from so many millimetres beside that;
        None where the arrow is nearer.
        """
        aside, step = abs(self._find_aside(self.start)), self.start - self.point
        return (self.point + step * (past / aside), self.start) if aside > past else None

    def _find_aside_at_pin(self) -> float:
        """Millimetres beside the point at which the line to the tail leaves its pin."""
        size = length(self.start - self.point)
        return (PIN + _OFF_PIN) * abs(self._find_aside(self.start)) / size if size else 0.0

    def _end(self) -> Vector:
        return self.start + self.toward * self.size
