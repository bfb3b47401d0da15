"""Marks of right angles: small squares in the corner."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import product
from math import acos, degrees

from kinegrade.errors import TemplateError
from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.mechanism.straight_parts import Bar, Rod, is_slender, list_ways
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.plane import length, unit
from kinegrade.figure.scene import THIN, Outline
from kinegrade.figure.symbols.bars import BAR_WIDTH
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.mechanics.vector import Vector

_SIDES = (2.6, 3.4, 4.4, 5.4)  # millimetres; larger squares go round a gusset or a sleeve
_SHARE = 0.8  # of the shorter leg that a square may take
_TRIM = 0.9  # millimetres at either end where a square meets the legs, as it should
_RIGHT = 1e-4  # cosine of an angle that passes for a right one


def add_right_angle(
    layout: Layout, at: Mapping[str, Vector], names: tuple[str, str, str], drawing: Drawing
) -> Layout:
    """The layout with the square in the corner at the second point, as small as it can be without
    covering more than a larger one, and smaller than its legs; where a bar runs on, it may be
    beyond the corner; at a broad bar it stands on the edge of that.

    Raises TemplateError when the angle is no right angle.
    """
    start, corner, end = (at[name] for name in names)
    legs = unit(start - corner), unit(end - corner)
    if abs(legs[0].dot(legs[1])) > _RIGHT:
        angle = degrees(acos(legs[0].dot(legs[1])))
        found = Message("figure.no-right-angle", at=Quoted(names[1]), angle=f"{angle:.1f}")
        raise TemplateError(Fault("figure.right_angles", found))
    pairs = list(product(*(_list_sides(leg, corner, drawing) for leg in legs)))
    most = _SHARE * min(length(start - corner), length(end - corner))
    sides = [side for side in _SIDES if side <= most] or _SIDES[:1]
    inner = [(_find_inner_corner(corner, pair, drawing), pair) for pair in pairs]
    squares = [_trace_square(at_edge, pair, side) for side in sides for at_edge, pair in inner]
    return layout.drawn((min(squares, key=lambda square: _measure_covering(square, layout)),))


def _list_sides(leg: Vector, corner: Vector, drawing: Drawing) -> list[Vector]:
    """A leg, and its opposite where a bar runs on beyond the corner."""
    bars = [part for part in drawing.parts if isinstance(part, Bar | Rod)]
    ways = [unit(way) for bar in bars for way in list_ways(bar, corner)]
    return [leg, *(way for way in ways if way.dot(leg) < _RIGHT - 1)]


def _find_inner_corner(corner: Vector, legs: Sequence[Vector], drawing: Drawing) -> Vector:
    """Where the edges meet of what is drawn along the legs from a corner."""
    bars = [part for part in drawing.parts if isinstance(part, Bar) and not is_slender(part)]
    ways = [unit(way) for bar in bars for way in list_ways(bar, corner)]
    for leg, other in (legs, legs[::-1]):
        if any(abs(way.dot(leg)) > 1 - _RIGHT for way in ways):
            corner = corner + other * (BAR_WIDTH / 2)
    return corner


def _trace_square(corner: Vector, legs: Sequence[Vector], side: float) -> Outline:
    first, second = (corner + leg * side for leg in legs)
    return Outline((first, first + second - corner, second), THIN, closed=False)


def _measure_covering(square: Outline, layout: Layout) -> float:
    first, far, second = square.corners
    ends = (end + unit(far - end) * _TRIM for end in (first, second))
    return layout.obstacles.along([(end, far) for end in ends], shared=False)
