"""The labels of points, of free ends of bars and of bodies, and where they may stand."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from itertools import pairwise
from math import pi

import numpy as np
from msgspec.structs import replace

from kinegrade.figure.joints.symbol import Rim
from kinegrade.figure.marks.lengths.dimension_lines import DimensionLine
from kinegrade.figure.marks.letter_owners import keep_off_disc, keep_off_supports
from kinegrade.figure.marks.straight.moving_arrow import MovingArrow
from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.mechanism.straight_parts import Bar, Rod
from kinegrade.figure.placing.mark import Mark, direction
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.place import (
    Floats,
    Wish,
    list_close_spots,
    list_spots_around,
    rate_nearness,
)
from kinegrade.figure.plane import NEAR, length, nearest_of, on_line, unit
from kinegrade.figure.scene import THIN, Bow, Strokes
from kinegrade.mechanics.joints import Line
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Angle, FigureHints

# Cost of a letter that may be read as that of another point: between a thin and a firm line
_MISTAKEN = 20.0
_NEAR_SPOTS = 48  # spots for a letter of which those outside an angle at its point come first
_NAMING = 3.0  # cost of a letter in an angle at its point, which it would seem to name
_TEETH = 4.5  # millimetres of the leader to a point among teeth that may cross these
_INSIDE = 0.95  # share of a radius: nearer to the rim a letter may stand on either side
_WITHIN = 1.5  # millimetres inside a rim from which on a letter is rather inside it as well
# Millimetres from its tail, and from a point, to where an arrow is past it, and cost of a letter
# about as near to it: no fault
_AT_TAIL, _AT_ARROW = 3, 0.45
_TAKEN = 2.0  # cost of a place looked for closely that is about as near to an arrow: a fault
_Wedge = tuple[Vector, float]  # the bisector of an angle, and the cosine of its half
_POINT = re.compile(r"([A-Za-z])(\d*)(p*)")


def write_point_symbol(name: str) -> str:
    """A point's name as LaTeX math: digits as subscript, a trailing p as prime.

    >>> write_point_symbol("O1"), write_point_symbol("Op")
    ('O_{1}', "O'")
    """
    match = _POINT.fullmatch(name)
    if match is None:
        return "\\mathrm{" + re.sub(r"[^A-Za-z0-9]", "", name) + "}"
    letter, digits, primes = match.groups()
    return letter + (f"_{{{digits}}}" if digits else "") + "'" * len(primes)


def label_points(mechanism: Mechanism, hints: FigureHints, drawing: Drawing) -> Iterator[Wish]:
    """The labels of points, then of free ends: each has to stand close to its point."""
    ends = list(find_free_ends(mechanism, drawing))
    places = [*mechanism.points.values(), *(end for _, end in ends)]
    for name in find_named_points(mechanism, hints, drawing):
        symbol = hints.labels.get(name, write_point_symbol(name))
        if symbol:
            angles = [angle for angle in hints.angles if angle.at == name]
            wedges = [_find_wedge(mechanism.points, angle) for angle in angles]
            at = mechanism.points[name]
            wish = label_point(symbol, at, drawing, places, wedges)
            wish = keep_off_supports(wish, at, mechanism.points, drawing)
            if any(joint.point == name and joint.edge for joint in drawing.symbols):
                wish = keep_off_disc(wish, at, drawing)
            yield _keep_out_of_angles(wish, at, wedges) if wedges else wish
    for name, end in ends:
        yield label_point(write_point_symbol(name), end, drawing, places)


def label_point(
    symbol: str,
    at: Vector,
    drawing: Drawing,
    places: Iterable[Vector],
    wedges: Sequence[_Wedge] = (),
) -> Wish:
    """A letter at its point, in the same circles as this first; covering a thin line is preferred
    to standing nearer to another point.
    """
    spots = list_spots_around(symbol, at, away=_find_free_direction(at, drawing))
    for rim in drawing.rims:
        if length(at - rim.at) < _INSIDE * rim.radius:
            beyond = np.hypot(*(spots - np.array(rim.at)).T) > rim.radius
            spots = spots[np.argsort(beyond, kind="stable")]
    others = [place for place in places if length(place - at) > NEAR]
    demerits = _MISTAKEN * rate_nearness(symbol, spots, [at], others)
    amid, closely = (
        _TEETH * _meshes(at, drawing),
        partial(_look_closely, symbol, at, others, wedges),
    )
    walls = (
        *_list_grounds(at, drawing),
        *(chord for rim in drawing.rims if _lies_within(at, rim) for chord in _list_chords(rim)),
    )
    side = next((side for pin, side in drawing.half_pins if length(pin - at) < NEAR), None)
    return Wish(symbol, spots, None, demerits, at, amid, closely, walls, side)


def _list_grounds(at: Vector, drawing: Drawing) -> Iterator[Segment]:
    """The lines of supports and guides on which a point does not lie itself, each with the far end
    of its hatching.
    """
    for hatching, line in pairwise(drawing.ground):
        if isinstance(hatching, Strokes) and isinstance(line, Strokes) and line.pen != THIN:
            ((start, end),) = line.lines
            if length(at - nearest_of(at, start, end)) > NEAR:
                yield from ((start, end), (hatching.lines[0][1], hatching.lines[-1][1]))


def _lies_within(at: Vector, rim: Rim) -> bool:
    """Whether a point lies in the disc of a rim, away from its edge."""
    return not rim.ring and length(at - rim.at) < rim.radius - _WITHIN


def _list_chords(rim: Rim) -> tuple[Segment, ...]:
    return tuple(pairwise(Bow(rim.at, rim.radius, 0.0, 2 * pi, THIN).path()))


def keep_from_marks(wish: Wish, marks: Sequence[Mark]) -> Wish:
    """The wish of a point's letter, which is rather not about as near to the arrow of a straight
    motion, nor beyond a dimension line.
    """
    at = wish.names
    if at is None:
        return wish
    arrows = [mark.list_stations()[_AT_TAIL:] for mark in marks if isinstance(mark, MovingArrow)]
    stations = [place for each in arrows for place in each if length(place - at) > _AT_TAIL]
    worse = _AT_ARROW * rate_nearness(wish.symbol, wish.spots, [at], stations)
    lines = tuple(mark.line() for mark in marks if isinstance(mark, DimensionLine))
    closely = partial(_look_off_arrows, wish.closely, at, stations) if wish.closely else None
    return replace(wish.worse_by(worse), walls=(*wish.walls, *lines), closely=closely)


def _look_off_arrows(
    look: Callable[[float], Wish], at: Vector, stations: Sequence[Vector], farthest: float
) -> Wish:
    """The many places close to a point for its letter, none of them at an arrow."""
    close = look(farthest)
    worse = _TAKEN * rate_nearness(close.symbol, close.spots, [at], stations, 0.0)
    return close.worse_by(worse)


def _look_closely(
    symbol: str, at: Vector, others: Sequence[Vector], wedges: Sequence[_Wedge], farthest: float
) -> Wish:
    """The many places close to a point for its letter, outside the angles there."""
    spots = list_close_spots(symbol, at, farthest)
    mistaken = rate_nearness(symbol, spots, [at], others) + _find_within(spots, at, wedges)
    return Wish(symbol, spots, demerits=_MISTAKEN * mistaken)


def _meshes(at: Vector, drawing: Drawing) -> bool:
    """Whether a point lies on the pitch circle of a gear."""
    gears = (rim for rim in drawing.rims if rim.kind == "gear")
    return any(abs(length(at - gear.at) - gear.radius) < NEAR for gear in gears)


def _keep_out_of_angles(wish: Wish, at: Vector, wedges: Sequence[_Wedge]) -> Wish:
    """The letter of a vertex first outside its angles, in which it would seem to name them, as
    long as it stands near.
    """
    within = _find_within(wish.spots, at, wedges)
    wish = wish.worse_by(_NAMING * within)
    within[_NEAR_SPOTS:] = 2
    order = np.argsort(within, kind="stable")
    demerits = None if wish.demerits is None else wish.demerits[order]
    return replace(wish, spots=wish.spots[order], demerits=demerits)


def _find_wedge(at: Mapping[str, Vector], angle: Angle) -> _Wedge:
    """The bisector of an angle, and the cosine of its half."""
    sides = [unit(direction(at, at[angle.at], name)) for name in (angle.start, angle.end)]
    middle = unit(sides[0] + sides[1])
    return middle, middle.dot(sides[0])


def _find_within(spots: Floats, at: Vector, wedges: Iterable[_Wedge]) -> Floats:
    """For each spot 1 in an angle at a point, else 0."""
    within, steps = np.zeros(len(spots)), spots - np.array(at)
    for middle, least in wedges:
        within[steps @ np.array(middle) > np.hypot(*steps.T) * least] = 1
    return within


def _find_free_direction(at: Vector, drawing: Drawing) -> Vector | None:
    """The direction away from a point's bars and its circle; None when no direction is better."""
    toward = Vector(0.0, 0.0)
    for part in drawing.parts:
        if isinstance(part, Bar | Rod) and on_line(at, Line(part.start, part.end - part.start)):
            for end in (part.start, part.end):
                toward = toward + (unit(end - at) if length(end - at) > 1.0 else Vector(0.0, 0.0))
    for rim in drawing.rims:
        if abs(length(at - rim.at) - rim.radius) < 0.01:
            toward = toward + unit(rim.at - at) * 1.2
    return -toward if length(toward) > 0.2 else None


def find_named_points(mechanism: Mechanism, hints: FigureHints, drawing: Drawing) -> list[str]:
    """Points that belong to a body, to a circle or to the ground, or are labelled; all others serve
    only for construction.
    """
    used = {name for body in mechanism.bodies for name in body.points} | {
        rim.centre for rim in drawing.rims
    }
    used |= {symbol.point for symbol in drawing.symbols if symbol.point}
    return [name for name in mechanism.points if name in used or hints.labels.get(name)]


def find_free_ends(mechanism: Mechanism, drawing: Drawing) -> Iterator[tuple[str, Vector]]:
    """The letters of free ends: a bar called AB on which only A is marked ends in B; of two free
    letters the rod takes the later.
    """
    for body in mechanism.bodies:
        letters = [letter for letter in _split_letters(body.name) if letter not in mechanism.points]
        straight = [
            part for part in drawing.parts if isinstance(part, Bar | Rod) and part.body == body.name
        ]
        ends = [
            end
            for part in sorted(straight, key=lambda part: isinstance(part, Bar))
            for end in part.free
        ]
        yield from zip(reversed(letters), ends, strict=False)


def _split_letters(name: str) -> list[str]:
    """The point names that a body's name is made of; none when it is a word or a numeral."""
    if not re.fullmatch(r"(?:[A-Z]\d*p?){2,}", name) or set(name) <= set("IVX"):
        return []
    return re.findall(r"[A-Z]\d*p?", name)
