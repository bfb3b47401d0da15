"""The labels of points, of free ends of bars and of bodies, and where they may stand."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from math import pi

import numpy as np

from kinegrade.errors import TemplateError
from kinegrade.figure.joints.symbol import Rim
from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.mechanism.straight_parts import Bar, Rod
from kinegrade.figure.placing.extent import measure_symbol
from kinegrade.figure.placing.mark import direction
from kinegrade.figure.placing.place import Floats, Wish, list_spots_around, rate_nearness
from kinegrade.figure.plane import NEAR, length, on_line, polar, unit
from kinegrade.figure.scene import Label
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.mechanics.joints import Line
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Angle, FigureHints

# Cost of a letter that may be read as that of another point: between a thin and a firm line
_MISTAKEN = 20.0
_NEAR_SPOTS = 48  # spots for a letter of which those outside an angle at its point come first
# Cost of the name of a body beside another letter, less than a fault; millimetres between words
_ONE_WORD, _SPACE = 0.45, 2.5
_INSIDE = 0.95  # share of a radius: nearer to the rim a letter may stand on either side
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
    ends = list(_find_free_ends(mechanism, drawing))
    places = [*mechanism.points.values(), *(end for _, end in ends)]
    for name in _find_named_points(mechanism, hints, drawing):
        symbol = hints.labels.get(name, write_point_symbol(name))
        if symbol:
            wish = _label_point(symbol, mechanism.points[name], drawing, places)
            angles = [angle for angle in hints.angles if angle.at == name]
            yield _keep_out_of_angles(wish, mechanism.points, angles) if angles else wish
    for name, end in ends:
        yield _label_point(write_point_symbol(name), end, drawing, places)


def _label_point(symbol: str, at: Vector, drawing: Drawing, places: list[Vector]) -> Wish:
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
    return Wish(symbol, spots, demerits=demerits, names=at)


def _keep_out_of_angles(wish: Wish, at: Mapping[str, Vector], angles: Iterable[Angle]) -> Wish:
    """The letter of a vertex first outside its angles, in which it would seem to name them, as
    long as it stands near.
    """
    within = np.zeros(len(wish.spots))
    for angle in angles:
        vertex = at[angle.at]
        sides = [unit(direction(at, vertex, name)) for name in (angle.start, angle.end)]
        middle = unit(sides[0] + sides[1])
        steps = wish.spots - np.array(vertex)
        within[steps @ np.array(middle) > np.hypot(*steps.T) * middle.dot(sides[0])] = 1
    within[_NEAR_SPOTS:] = 2
    order = np.argsort(within, kind="stable")
    demerits = None if wish.demerits is None else wish.demerits[order]
    return replace(wish, spots=wish.spots[order], demerits=demerits)


def label_bodies(
    mechanism: Mechanism, hints: FigureHints, drawing: Drawing, written: Sequence[Label]
) -> Iterator[Wish]:
    """The labels of bodies, which may stand anywhere in or next to them, rather not beside what is
    written already: the two would read as one word.

    Raises TemplateError for the label of a body of which nothing is drawn.
    """
    for body, symbol in hints.labels.items():
        if symbol and body not in mechanism.points:
            wish = _label_body(body, symbol, drawing)
            yield replace(wish, demerits=_ONE_WORD * _find_beside(wish, written))


def _find_beside(wish: Wish, written: Sequence[Label]) -> Floats:
    """For each spot of a wish 1 where a letter stands close to its left or right, else 0."""
    beside = np.zeros(len(wish.spots))
    width, height = measure_symbol(wish.symbol)
    for label in written:
        steps = np.abs(wish.spots - np.array(label.centre))
        level = steps[:, 1] < (height + label.height) / 2
        close = steps[:, 0] < (width + label.width) / 2 + _SPACE
        beside = np.maximum(beside, level & close)
    return beside


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


def _find_named_points(mechanism: Mechanism, hints: FigureHints, drawing: Drawing) -> list[str]:
    """Points that belong to a body, to a circle or to the ground, or are labelled; all others serve
    only for construction.
    """
    used = {name for body in mechanism.bodies for name in body.points} | {
        rim.centre for rim in drawing.rims
    }
    used |= {symbol.point for symbol in drawing.symbols if symbol.point}
    return [name for name in mechanism.points if name in used or hints.labels.get(name)]


def _find_free_ends(mechanism: Mechanism, drawing: Drawing) -> Iterator[tuple[str, Vector]]:
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


def _label_body(body: str, symbol: str, drawing: Drawing) -> Wish:
    circles: list[Rim] = [rim for rim in drawing.rims if rim.body == body]
    if circles:
        shares = (0.7, 0.55, 0.4)
        inner = [
            circles[0].at + polar(pi / 4 * turn, circles[0].radius * share)
            for share in shares
            for turn in range(8)
        ]
        return Wish(
            symbol,
            np.concatenate(
                (np.array(inner), list_spots_around(symbol, circles[0].at, circles[0].radius))
            ),
        )
    parts = [part for part in drawing.parts if isinstance(part, Bar | Rod) and part.body == body]
    if not parts:
        what = Message("figure.nothing-to-label", body=Quoted(body))
        raise TemplateError(Fault(f"figure.labels.{body}", what))
    return Wish(symbol, list_spots_around(symbol, (parts[0].start + parts[0].end) / 2))
