"""Rotations as curved arrows about a pivot, each with several alternatives."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from math import pi

from kinegrade.figure.joints.symbol import find_fixed_pin
from kinegrade.figure.marks.imposed import find_imposed_sense
from kinegrade.figure.marks.turning_arrow import TurningArrow, rate_room
from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.mechanism.straight_parts import Bar, SlottedDisc
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.place import Wish
from kinegrade.figure.plane import NEAR, angle_of, length, mean, shorter_way
from kinegrade.figure.scene import THIN, Bow
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level
from kinegrade.problem.template.hints import TURN, Sense, Turning

_RADII = (5.0, 6.5, 8.0, 10.0)  # millimetres, of the arrow of a rotation about its pivot
# Millimetres, length of that arrow; an acceleration has one head more
_ARCS: Mapping[Level, float] = {"velocity": 6.5, "acceleration": 7.6}
# Millimetres, of the arrow of a rotation relative to another body
_RELATIVE_RADII, _RELATIVE_ARC = (7.0, 8.5, 10.0, 11.5, 13.0, 14.5, 5.5), 9.0
_TWELFTHS = tuple(index * pi / 6 for index in range(12))
# Millimetres between the rim of a body and an arrow within it, or beyond it
_WITHIN, _BEYOND = 2.6, 2.0
# Demerit of each radian between the arrow and the body, or where the rim of a disc is nearest
_ASTRAY, _AT_RIM = 1.2, 5.0
_ROOMY = 11.0  # millimetres from a pivot to the nearest rim that leave room for an arrow within
# Millimetres about a pivot within which the arrow of a rotation keeps clear of letters
_LETTERED = 8.0


def add_rotation(
    layout: Layout, mechanism: Mechanism, hint: Turning, drawing: Drawing, named: Iterable[Wish]
) -> Layout:
    """The layout with an arrow about the pivot of a body, the preferred one close to it, where the
    body leaves it; it keeps clear of the letters `named` that are still to be written there.
    """
    if hint.of == GROUND:
        centre = _find_pivot(mechanism, hint.body, drawing)
        arrows = _list_absolute_arrows(mechanism, hint, centre, drawing)
    else:
        centre = _find_common_point(mechanism, hint)
        arrows = _list_relative_arrows(mechanism, hint, centre, drawing)
    close = [wish for wish in named if length(Vector(*wish.spots[0]) - centre) < _LETTERED]
    arcs = [line for line in layout.lines if isinstance(line, Bow) and line.pen == THIN]
    near = [arc for arc in arcs if length(arc.centre - centre) < NEAR]
    earlier = [mark for mark in layout.marks if isinstance(mark, TurningArrow)]
    twins = [twin.bow for twin in earlier if length(twin.bow.centre - centre) < NEAR]
    foreign = [rim for rim in drawing.rims if rim.body != hint.body]
    rims = [rim.radius for rim in foreign if length(rim.at - centre) < NEAR]
    apart = [
        replace(
            arrow,
            demerit=arrow.demerit + rate_room(arrow.bow, near, twins, rims),
        )
        for arrow in arrows
    ]
    return layout.marked(apart, layout.written(close).labels)


def _list_absolute_arrows(
    mechanism: Mechanism, hint: Turning, centre: Vector, drawing: Drawing
) -> list[TurningArrow]:
    """Arrows about the pivot of a body, where the body leaves it first; those of an eccentric disc,
    where there is no room inside, beyond its rim, where that is nearest.
    """
    sense = hint.sense or find_imposed_sense(mechanism, hint)
    for rim in drawing.rims:
        aside = length(centre - rim.at)
        room = rim.radius - aside
        if rim.body == hint.body and rim.kind == "wheel" and aside > NEAR and 0 < room < _ROOMY:
            away, beyond = angle_of(centre - rim.at), room + _BEYOND
            return list_turning_arrows(
                hint,
                sense,
                centre,
                (beyond, beyond + 1.5, beyond + 3.0, *_RADII),
                away,
                astray=_AT_RIM,
            )
    crank = _find_crank_direction(mechanism, hint.body, centre, drawing)
    rims = list(_list_radii(drawing, hint.body))
    if _shares_pivot(mechanism, hint.body, drawing):
        inside = [radius - _WITHIN for radius in rims if radius > 2 * _RADII[0]]
        radii = (*inside, *(radius + _BEYOND for radius in rims), *_RADII)
    else:
        radii = (*_RADII, *(radius + _BEYOND for radius in rims))
    return list_turning_arrows(hint, sense, centre, radii, crank, astray=_ASTRAY)


def _list_radii(drawing: Drawing, body: str) -> Iterator[float]:
    """The radii of the circles that a body is drawn as."""
    yield from (rim.radius for rim in drawing.rims if rim.body == body)
    for part in drawing.parts:
        if isinstance(part, SlottedDisc) and part.body == body:
            yield part.radius


def _shares_pivot(mechanism: Mechanism, body: str, drawing: Drawing) -> bool:
    """Whether other bodies turn about the pivot of a body too, so that its arrow has to stand at
    its rim to be told from theirs.
    """
    pin = find_fixed_pin(drawing.symbols, body)
    others = (other.name for other in mechanism.bodies if other.name != body)
    return pin is not None and any(find_fixed_pin(drawing.symbols, name) == pin for name in others)


def _list_relative_arrows(
    mechanism: Mechanism, hint: Turning, centre: Vector, drawing: Drawing
) -> list[TurningArrow]:
    """Arrows about the pin of two bodies that start on the one that counts as fixed."""
    sense = hint.sense or find_imposed_sense(mechanism, hint)
    start = _find_crank_direction(mechanism, hint.of, centre, drawing)
    return [
        TurningArrow(
            Bow(centre, radius, start, _RELATIVE_ARC / radius * TURN[sense], THIN), hint, rank
        )
        for rank, radius in enumerate(_RELATIVE_RADII)
    ]


def list_turning_arrows(
    hint: Turning,
    sense: Sense,
    centre: Vector,
    radii: Sequence[float],
    toward: float,
    *,
    astray: float,
) -> list[TurningArrow]:
    """Curved arrows about a centre, of each radius (millimetres, the preferred one first) and in
    twelve directions; `astray` is the demerit of each radian away from the direction `toward`.
    """
    found: list[TurningArrow] = []
    for radius in radii:
        span = _ARCS[hint.level] / radius * TURN[sense]
        for angle in _TWELFTHS:
            bow = Bow(centre, radius, angle - span / 2, span, THIN)
            demerit = 1.5 * abs(radius - radii[0]) + astray * abs(shorter_way(angle - toward))
            found.append(TurningArrow(bow, hint, demerit))
    return found


def _find_crank_direction(
    mechanism: Mechanism, body: str, centre: Vector, drawing: Drawing
) -> float:
    """The direction in which a body extends from its pivot; up when it extends in none."""
    points = [mechanism.points[name] for name in mechanism.body(body).points]
    points += [
        end
        for part in drawing.parts
        if isinstance(part, Bar) and part.body == body
        for end in part.free
    ]
    far = max(points, key=lambda point: length(point - centre))
    return angle_of(far - centre) if length(far - centre) > 1.0 else pi / 2


def _find_common_point(mechanism: Mechanism, hint: Turning) -> Vector:
    """Where a body is pinned to the one it turns relative to; the mean of its points when it is
    not.
    """
    points, others = mechanism.body(hint.body).points, mechanism.body(hint.of).points
    common = [name for name in points if name in others]
    return mean(mechanism.points[name] for name in common or points)


def _find_pivot(mechanism: Mechanism, body: str, drawing: Drawing) -> Vector:
    """Where a body's rotation is marked: its fixed pin, else its circle's centre, else the mean of
    its points.
    """
    pin = find_fixed_pin(drawing.symbols, body)
    if pin is not None:
        return mechanism.points[pin]
    for rim in drawing.rims:
        if rim.body == body:
            return rim.at
    return mean(mechanism.points[name] for name in mechanism.body(body).points)
