"""The ways to mark a distance: a dimension line, a symbol close to a line that is drawn, and a
symbol at the end of a leader.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np
from msgspec import Struct

from kinegrade.figure.placing.beside import adjoins
from kinegrade.figure.placing.extent import measure_symbol
from kinegrade.figure.placing.leading import list_spots_at_leader
from kinegrade.figure.placing.obstacles import NOTHING, Obstacles, Segment
from kinegrade.figure.placing.ownership import rate_beside_line
from kinegrade.figure.placing.place import Wish, list_spots_beside
from kinegrade.figure.plane import NEAR, length, nearest_of, polar, unit
from kinegrade.figure.scene import THIN, Label, Primitive, Strokes
from kinegrade.figure.symbols.arrows import HEAD_LENGTH, draw_arrowhead, draw_gap
from kinegrade.mechanics.vector import Vector

_LEFT = 4.2  # millimetres from a point in which its own bars leave beside an extension line
_ONE_FOOT = 0.1  # millimetres within which the ends of two dimension lines are one
_BESIDE = 3.6  # millimetres between parallel dimension lines side by side
# Millimetres from a pin to the middle of a symbol that would seem to name it, and demerit of one
_AT_PIN, _NAMING = 6.0, 0.3
_AMONG = 0.1  # demerit of a symbol on the side of other pins, where one of them is near
_IN_PLATE = 3.0  # demerit of the symbol of a plate's edge amid the plate
_AT_RATE = 1.3  # demerit of a symbol close to that of a rate, with which it would be a fraction
_OF_OTHER = 3.0  # demerit of a symbol no nearer to its own line than to something else


class DimensionLine(Struct, frozen=True, dict=True):
    """Extension lines from two points to their feet, and the dimension line between the feet; which
    of its heads lie on a black edge, which is interrupted there.
    """

    points: Segment
    feet: Segment
    symbol: str
    demerit: float
    gaps: tuple[float, float]
    shared: bool = True
    pins: tuple[Vector, ...] = ()
    on_edge: tuple[bool, bool] = (False, False)

    def path(self) -> tuple[Segment, ...]:
        """The dimension line, and the extension lines from where they have left their points."""
        return (self.line(), *self._extend(_LEFT))

    def whole(self) -> tuple[Segment, ...]:
        """The dimension line and all of the extension lines."""
        return (self.line(), *self.extensions)

    def beginnings(self) -> tuple[Segment, ...]:
        """The extension lines, up to where they have left their points."""
        return tuple(
            (start, start + unit(end - start) * min(_LEFT, length(end - start)))
            for start, end in self.extensions
        )

    def crowds(self, other: DimensionLine) -> bool:
        """Whether its line stands close beside that of another dimension."""
        along, (start, end) = unit(self.feet[1] - self.feet[0]), other.feet
        if abs(unit(end - start).cross(along)) > NEAR:
            return False
        low, high = sorted((foot - self.feet[0]).dot(along) for foot in other.feet)
        beside = low < length(self.feet[1] - self.feet[0]) - NEAR and high > NEAR
        gap = abs((start - self.feet[0]).cross(along))
        return bool(beside and gap < _BESIDE)

    def adjoins(self, other: DimensionLine) -> bool:
        """Whether it measures on from a point of another dimension in the same direction."""
        ways = [unit(feet[1] - feet[0]) for feet in (self.feet, other.feet)]
        shared = any(length(one - two) < NEAR for one in self.points for two in other.points)
        return shared and abs(ways[0].cross(ways[1])) < NEAR

    def goes_on_from(self, other: DimensionLine) -> bool:
        """Whether its line goes on from that of another dimension, as in a chain."""
        meets = any(length(one - two) < _ONE_FOOT for one in self.feet for two in other.feet)
        return meets and self.adjoins(other)

    def cuts(self, other: DimensionLine) -> bool:
        """Whether its line crosses another dimension, or an extension line of it the other line."""
        pieces = (other.line(), *other.extensions)
        return _cross_any(pieces, self.line()) or _cross_any(self.extensions, other.line())

    def begins_at(self, point: Vector, aside: float) -> bool:
        """Whether one of its extension lines passes a point within so many millimetres, and seems
        to begin there.
        """
        return any(length(point - nearest_of(point, *line)) < aside for line in self.extensions)

    def wish(self) -> Wish:
        """Beside the dimension line, rather not where it would seem to name a pin, then rather on
        the side without other pins, whose dimensions end there.
        """
        start, end = self.line()
        spots = list_spots_beside(self.symbol, start, end)
        near = [any(length(Vector(*spot) - pin) < _AT_PIN for pin in self.pins) for spot in spots]
        demerits = _NAMING * np.array(near)
        if any(near):
            across = np.array((end - start).turned())
            sides = np.sign([(pin - start).dot((end - start).turned()) for pin in self.pins])
            levels = np.sign((spots - np.array(start)) @ across)
            demerits += _AMONG * np.array([np.all(sides == level) for level in levels])
        return Wish(self.symbol, spots, demerits=demerits)

    def primitives(self) -> tuple[Primitive, ...]:
        """Thin lines and two arrowheads, from outside where there is no room between the feet."""
        along = unit(self.feet[1] - self.feet[0]) * (1.0 if self._outside() else -1.0)
        heads = (draw_arrowhead(self.feet[0], along), draw_arrowhead(self.feet[1], -along))
        over = zip(heads, self.on_edge, strict=True)
        gaps = [draw_gap(head) for head, on_edge in over if on_edge]
        return (*gaps, Strokes((*self.extensions, self.line()), THIN), *heads)

    def heads(self) -> tuple[Segment, Segment]:
        """The pieces under its arrowheads."""
        along = unit(self.feet[1] - self.feet[0]) * (
            -HEAD_LENGTH if self._outside() else HEAD_LENGTH
        )
        return (self.feet[0], self.feet[0] + along), (self.feet[1], self.feet[1] - along)

    def _outside(self) -> bool:
        return length(self.feet[1] - self.feet[0]) < 2 * HEAD_LENGTH + 1.5

    def line(self) -> Segment:
        """The dimension line, as far as it is drawn beyond the feet."""
        tail = unit(self.feet[1] - self.feet[0]) * (3.0 if self._outside() else 0.0)
        return (self.feet[0] - tail, self.feet[1] + tail)

    @cached_property
    def extensions(self) -> tuple[Segment, ...]:
        """From a gap beyond each point to a little beyond its foot."""
        return self._extend(0.0)

    def _extend(self, least: float) -> tuple[Segment, ...]:
        """The same, from so far from each point at least."""
        found = []
        for point, end, gap in zip(self.points, self.feet, self.gaps, strict=True):
            step = end - point
            if length(step) > gap + 0.9:
                away = unit(step)
                found.append((point + away * max(gap, least), end + away * 1.2))
        return tuple(found)


def _cross_any(lines: tuple[Segment, ...], across: Segment) -> bool:
    """Whether a line passes through others, not only from an end of it."""
    start, end = across
    step = end - start
    for one, other in lines:
        sides = step.cross(one - start) * step.cross(other - start)
        ends = (other - one).cross(start - one) * (other - one).cross(end - one)
        if sides < -NEAR and ends < -NEAR:
            return True
    return False


class SymbolBeside(Struct, frozen=True, dict=True):
    """The symbol alone, close to a line that is drawn between the two points, or to the edge of a
    link of `half` a width, where the most room is, and clearly nearer to it than to anything else
    that is `drawn`; rather `outward` of the edge of a plate.
    """

    start: Vector
    end: Vector
    symbol: str
    demerit: float = 0.0
    half: float = 0.0
    drawn: Obstacles = NOTHING
    shared: bool = True
    outward: Vector | None = None
    rates: tuple[Label, ...] = ()

    def path(self) -> tuple[Segment, ...]:
        """Empty: no line is drawn."""
        return ()

    def wish(self) -> Wish:
        """Close beside the line."""
        return self._wish

    @cached_property
    def _wish(self) -> Wish:
        gaps = (self.half + 0.8, self.half + 1.3, self.half + 0.5)  # the last at thin lines
        spots = list_spots_beside(self.symbol, self.start, self.end, gaps=gaps, stations=5)
        own = (self.start, self.end)
        other = rate_beside_line(self.symbol, spots, own, self.half, self.drawn)
        demerits = _OF_OTHER * other
        places = [Label(self.symbol, Vector(*spot), *measure_symbol(self.symbol)) for spot in spots]
        demerits += _AT_RATE * np.array([adjoins(place, self.rates) for place in places])
        if self.outward:
            inside = (spots - np.array(self.start)) @ np.array(self.outward) < 0
            demerits = demerits + _IN_PLATE * inside
        return Wish(self.symbol, spots, demerits=demerits)

    def primitives(self) -> tuple[Primitive, ...]:
        """Empty: no line is drawn."""
        return ()


class Leader(Struct, frozen=True):
    """The symbol at the end of a leader to the middle of a bar, for bars that are short and
    crowded; `worse` is how much its place is.
    """

    middle: Vector
    angle: float
    reach: float
    symbol: str
    worse: float = 0.0
    shared: bool = False

    @property
    def demerit(self) -> float:
        """Higher than that of any unobstructed dimension line."""
        return self.reach + self.worse

    def path(self) -> tuple[Segment, ...]:
        """The leader without its start, which touches the bar in any case."""
        return ((self.middle + polar(self.angle, 1.5), self._end()),)

    def wish(self) -> Wish:
        """At the far end."""
        return Wish(self.symbol, list_spots_at_leader(self.symbol, self._end(), polar(self.angle)))

    def primitives(self) -> tuple[Primitive, ...]:
        """The leader."""
        return (Strokes((self.line(),), THIN),)

    def line(self) -> Segment:
        """From the bar to the far end."""
        return (self.middle, self._end())

    def _end(self) -> Vector:
        return self.middle + polar(self.angle, self.reach)
