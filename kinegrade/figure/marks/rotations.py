"""Rotations as curved arrows about a pivot, each with several alternatives."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from math import pi

from kinegrade.figure.joints.symbol import find_fixed_pin
from kinegrade.figure.marks.imposed import find_imposed_sense
from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.mechanism.straight_parts import Bar, SlottedDisc
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.mark import chords
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.place import Wish, list_spots_along_arc
from kinegrade.figure.plane import NEAR, angle_of, length, mean, shorter_way
from kinegrade.figure.scene import THIN, Bow, Primitive
from kinegrade.figure.symbols import HEADS, draw_curved_arrow
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
_FOREIGN = 4.5  # millimetres between an arrow and the rim of another body, 1 demerit for each less
# Demerit of each radian between the arrow and the body, or where the rim of a disc is nearest
_ASTRAY, _AT_RIM = 1.2, 5.0
_ROOMY = 11.0  # millimetres from a pivot to the nearest rim that leave room for an arrow within
_COARSE = 0.7  # radians of an arrow that count as straight when its way is looked at
# Millimetres between an arrow and the arc of an angle within it, and the demerit of less
_APART, _MERGED = 3.0, 4.0
# Millimetres between two arrows at one pivot along their arcs, and the demerit of each that lacks;
# half as much where their radii differ by so many millimetres, else they cannot be told apart
_BETWEEN, _FOLLOWING, _NESTED, _COVERED = 6.0, 0.6, 2.5, 100.0
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
    twins = [twin for twin in earlier if length(twin.bow.centre - centre) < NEAR]
    foreign = [rim for rim in drawing.rims if rim.body != hint.body]
    rims = [rim.radius for rim in foreign if length(rim.at - centre) < NEAR]
    apart = [
        replace(
            arrow,
            demerit=_rate_arcs(arrow, near) + _rate_twins(arrow, twins) + _rate_rims(arrow, rims),
        )
        for arrow in arrows
    ]
    return layout.marked(apart, layout.written(close).labels)


def _rate_arcs(arrow: TurningArrow, arcs: Iterable[Bow]) -> float:
    """The demerit of an arrow, larger where it would look like a part of the arc of an angle at the
    same pivot.
    """
    bow, worse = arrow.bow, 0.0
    for arc in arcs:
        from_start = bow.start + bow.sweep / 2 - arc.start
        turned = from_start % (2 * pi) if arc.sweep > 0 else -from_start % (2 * pi)
        if turned < abs(arc.sweep) and abs(bow.radius - arc.radius) < _APART:
            worse += _MERGED
    return arrow.demerit + worse


def _rate_twins(arrow: TurningArrow, twins: Iterable[TurningArrow]) -> float:
    """The demerit of an arrow that follows or covers another one at the same pivot, so that the two
    read as one: they stand opposite one another, else one well outside the other.
    """
    worse = 0.0
    for twin in twins:
        one, other = arrow.bow, twin.bow
        radius = (one.radius + other.radius) / 2
        turned = one.start + one.sweep / 2 - other.start - other.sweep / 2
        shafts = (abs(one.sweep) + abs(other.sweep)) / 2
        gap = radius * (abs(shorter_way(turned)) - shafts)
        apart = abs(one.radius - other.radius) / _NESTED
        worse += _FOLLOWING * max(0.0, 1 - apart / 2) * max(0.0, _BETWEEN - max(gap, 0.0))
        worse += _COVERED * (gap < 0 and apart < 1)
    return worse


def _rate_rims(arrow: TurningArrow, foreign: Iterable[float]) -> float:
    """The demerit of an arrow near the rims of another body about the same pivot, which would seem
    to turn.
    """
    return sum(max(0.0, _FOREIGN - abs(arrow.bow.radius - radius)) for radius in foreign)


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


@dataclass(frozen=True)
class TurningArrow:
    """A curved arrow along an arc."""

    bow: Bow
    hint: Turning
    demerit: float
    shared: bool = False

    def path(self) -> tuple[Segment, ...]:
        """The arc, in few pieces: there are many arrows to choose from."""
        return chords(self.bow, _COARSE)

    def wish(self) -> Wish:
        """Along the arc."""
        return list_spots_along_arc(self.hint.symbol, self.bow)

    def primitives(self) -> tuple[Primitive, ...]:
        """The arc and its arrowhead."""
        return draw_curved_arrow(self.bow, HEADS[self.hint.level])


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
