"""A rotation as one curved arrow, and how well it is told from what else there is at its pivot."""

from __future__ import annotations

from collections.abc import Sequence
from math import copysign, hypot

from msgspec import Struct
from msgspec.structs import replace

from kinegrade.figure.joints.symbol import Rim
from kinegrade.figure.placing.mark import chords
from kinegrade.figure.placing.obstacles import NOTHING, Obstacles, Segment
from kinegrade.figure.placing.ownership import CLAIMING, UNCLAIMED, Claims
from kinegrade.figure.placing.place import Wish, list_spots_along_arc, rate_nearness, widen
from kinegrade.figure.plane import length, nearest_of, parts, polar, shorter_way
from kinegrade.figure.scene import Bow, Primitive
from kinegrade.figure.symbols.arrows import HEADS, draw_curved_arrow
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Turning

_COARSE = 0.7  # radians of an arrow that count as straight when its way is looked at
# Millimetres to be kept free before the head of an arrow and behind its tail, and of a tail on the
# bar that turns
_FREE_END, _ON_BAR = 0.6, 1.2
# Millimetres between an arrow and the arc of an angle within it or along it, and the demerit of
# less; the same where an arc of about the same radius ends where the arrow begins
_APART, _ALONG, _MERGED = 3.0, 1.5, 4.0
_ONE_RADIUS, _ONE_CURVE = 1.8, 2.0
# Millimetres between two arrows at one pivot along their arcs, and the demerit of each that lacks;
# half as much where their radii differ by so many millimetres, else they cannot be told apart
_BETWEEN, _FOLLOWING, _NESTED, _COVERED = 6.0, 0.6, 2.5, 100.0
# Millimetres along their arcs at which two arrows of one radius touch, and the demerit of less
_TOUCH, _TOUCHING = 2.0, 6.0
# Millimetres between the radii of two arrows one inside the other that leave room for a symbol
# between them, and the demerit of less
_ROOM, _STACKED = 6.5, 4.0
# Millimetres between the tips of two arrows at one pivot, and the demerit of each that lacks
_TIPS, _MEETING = 5.0, 1.0
_FOREIGN = 4.5  # millimetres between an arrow and the rim of another body, 1 demerit for each less
# Millimetres between an arrow and the line that a dimension may draw from its pivot, and the
# demerit of less
_BESIDE_LINE, _ON_LINE = 1.5, 5.0
# Demerits of an arrow in the disc of another body, and of one with another body's bar before it
_ASTRAY, _BEYOND_BAR = 6.0, 12.0
# Demerit of an arrow between its pivot and the centre of its own body's circle, farther from its
# pivot than that: about the centre it would show the other sense
_ABOUT_CENTRE = 12.0
# Demerit of an arrow nearer than its pivot to another pin, by so many millimetres
_AT_OTHER, _NEARER = 3.0, 1.0
# Demerits of a symbol about as near to another arrow, and of one not clearly nearer to its own, by
# so many millimetres
_MISTAKEN, _UNCLEAR, _CLEARLY = 6.0, 2.0, 1.2
# Demerit of an arrow much nearer to another body's bar than to its pivot, by that share, and
# millimetres between a pivot and the bars that lead to it
_AT_BAR, _MUCH, _AT_PIVOT = 2.5, 0.6, 1.0
_CLOSE = 15  # places of a symbol by which an arrow is chosen
_STATIONS = 0.25  # radians between the points of an arrow to which its symbol should be near


class Company(Struct, frozen=True):
    """What else there is about the pivot of an arrow: the arcs of angles, other arrows, the radii
    of other bodies' rims (millimetres), the directions (radians) in which dimension lines may
    need a line from the pivot, the other bodies' discs that do not lie over the pivot, and bars
    that do not lead to it; the other pins there, letters of lengths with what is about them and
    dimension lines, and the circles of its `own` body.
    """

    arcs: tuple[Bow, ...]
    twins: tuple[Bow, ...]
    rims: tuple[float, ...]
    lines: tuple[float, ...]
    discs: tuple[Rim, ...] = ()
    bars: tuple[Segment, ...] = ()
    pins: tuple[Vector, ...] = ()
    letters: Obstacles = NOTHING
    own: tuple[Rim, ...] = ()

    def rate(self, bow: Bow) -> float:
        """The demerit of an arrow in this company."""
        middle = bow.centre + polar(bow.start + bow.sweep / 2, bow.radius)
        return (
            sum(_rate_arc(bow, arc) for arc in self.arcs)
            + sum(_rate_twin(bow, twin) for twin in self.twins)
            + sum(max(0.0, _FOREIGN - abs(bow.radius - radius)) for radius in self.rims)
            + sum(_ON_LINE for angle in self.lines if _measure_gap(bow, angle) < _BESIDE_LINE)
            + sum(_ASTRAY for disc in self.discs if length(middle - disc.at) < disc.radius)
            + sum(_BEYOND_BAR for bar in self.bars if parts(*bar, bow.centre, middle))
            + _AT_BAR * any(_stands_at(bow, middle, bar) for bar in self.bars)
            + (_AT_OTHER if self.pins and _stands_at_any(bow, middle, self.pins) else 0.0)
            + _ABOUT_CENTRE * any(_faces_centre(bow, middle, rim) for rim in self.own)
            + CLAIMING * (self.letters.along(chords(bow, _COARSE), shared=False) > 0)
        )


class TurningArrow(Struct, frozen=True):
    """A curved arrow along an arc; that of a bar among round bodies may be `tied` to it, its tail
    on the bar. Its symbol stands where it is not taken for that of what else is `around`.
    """

    bow: Bow
    hint: Turning
    demerit: float
    shared: bool = False
    tied: bool = False
    around: Claims = UNCLAIMED

    def among(self, company: Company, around: Claims = UNCLAIMED) -> TurningArrow:
        """The arrow with its demerit in some company, and what is around it."""
        return replace(self, demerit=self.demerit + company.rate(self.bow), around=around)

    def path(self) -> tuple[Segment, ...]:
        """The arc, a little longer at both ends, in few pieces: there are many arrows to choose
        from.
        """
        bow = self.bow
        tail, tip = -_ON_BAR if self.tied else _FREE_END, _FREE_END
        sense = copysign(1 / bow.radius, bow.sweep)
        whole = replace(bow, start=bow.start - sense * tail, sweep=bow.sweep + sense * (tail + tip))
        return chords(whole, _COARSE)

    def wish(self) -> Wish:
        """Close along the arc, rather where nothing else could own the symbol."""
        wish = list_spots_along_arc(self.hint.symbol, self.bow)
        close = replace(wish, spots=wish.spots[:_CLOSE])
        return close.worse_by(self.around.rate(wish.symbol, close.spots, self.list_stations()))

    def wish_apart(self, others: Sequence[TurningArrow]) -> Wish:
        """The wish, where the symbol is nearest to its own arrow, and around that, first."""
        wish, own = widen(list_spots_along_arc(self.hint.symbol, self.bow)), self.list_stations()
        near = [at for other in others for at in other.bow.path(_STATIONS)]
        worse = _MISTAKEN * rate_nearness(self.hint.symbol, wish.spots, own, near)
        worse += _UNCLEAR * rate_nearness(self.hint.symbol, wish.spots, own, near, _CLEARLY)
        return wish.worse_by(worse + self.around.rate(wish.symbol, wish.spots, own))

    def list_stations(self) -> Sequence[Vector]:
        """Points along the arrow, without its tail on a bar."""
        return self.bow.path(_STATIONS)[self.tied :]

    def primitives(self) -> tuple[Primitive, ...]:
        """The arc and its arrowhead, dashed where the rotation is sought."""
        return draw_curved_arrow(self.bow, HEADS[self.hint.level], sought=self.hint.sought)


def _rate_arc(bow: Bow, arc: Bow) -> float:
    """The demerit of an arrow that would look like a part of the arc of an angle at the same
    pivot.
    """
    between, room = _measure_between(bow, arc), arc.radius - bow.radius
    nested = between < 0 and 0 < room < _ROOM
    alike = abs(room) < _APART and between < _ALONG
    runs_on = abs(room) < _ONE_RADIUS and abs(between) < _ALONG
    return _STACKED * nested + _MERGED * alike + _ONE_CURVE * runs_on


def _stands_at(bow: Bow, middle: Vector, bar: Segment) -> bool:
    """Whether an arrow is much nearer to a bar, which does not lead to its pivot, than to that."""
    away = length(middle - nearest_of(middle, *bar))
    return (
        away < _MUCH * bow.radius and length(bow.centre - nearest_of(bow.centre, *bar)) > _AT_PIVOT
    )


def _faces_centre(bow: Bow, middle: Vector, rim: Rim) -> bool:
    """Whether an arrow lies within a circle, between its own pivot and the centre of that."""
    step = rim.at - bow.centre
    between = length(step) > bow.radius and (middle - bow.centre).dot(step) > 0
    return between and length(middle - rim.at) < rim.radius


def _stands_at_any(bow: Bow, middle: Vector, pins: Sequence[Vector]) -> bool:
    """Whether an arrow is nearer to one of some pins than to its own pivot, as if it turned about
    that.
    """
    x, y = middle
    return any(hypot(pin.x - x, pin.y - y) < bow.radius - _NEARER for pin in pins)


def _rate_twin(bow: Bow, twin: Bow) -> float:
    """The demerit of an arrow that follows, meets or covers another one at the same pivot, so that
    the two read as one: they stand opposite one another, else one well outside the other.
    """
    gap = _measure_between(bow, twin)
    apart = abs(bow.radius - twin.radius) / _NESTED
    worse = _FOLLOWING * max(0.0, 1 - apart / 2) * max(0.0, _BETWEEN - max(gap, 0.0))
    tips = [arrow.centre + polar(arrow.start + arrow.sweep, arrow.radius) for arrow in (bow, twin)]
    worse += _STACKED * (gap < 0 and abs(bow.radius - twin.radius) < _ROOM)
    worse += _MEETING * max(0.0, _TIPS - length(tips[1] - tips[0]))
    worse += _TOUCHING * (0 <= gap < _TOUCH and apart < 1)
    return worse + _COVERED * (gap < 0 and apart < 1)


def _measure_between(one: Bow, other: Bow) -> float:
    """Millimetres between two arcs about one centre along them; negative where they overlap."""
    turned = one.start + one.sweep / 2 - other.start - other.sweep / 2
    shafts = (abs(one.sweep) + abs(other.sweep)) / 2
    return (one.radius + other.radius) / 2 * (abs(shorter_way(turned)) - shafts)


def _measure_gap(bow: Bow, angle: float) -> float:
    """Millimetres along an arc between it and the line from its centre in a direction."""
    aside = abs(shorter_way(bow.start + bow.sweep / 2 - angle))
    return bow.radius * (aside - abs(bow.sweep) / 2)
