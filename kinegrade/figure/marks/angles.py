"""Angles: arcs of several radii, with thin lines along any side of the angle that is not drawn as a
bar.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from math import asin, inf, pi
from operator import itemgetter

from msgspec.structs import replace

from kinegrade.figure.marks.angle_arc import ALONE, AngleArc, Neighbours, add_leaders
from kinegrade.figure.marks.arcs.arc_heads import (
    is_across_line,
    is_at_pin_or_bar,
    is_ended_on,
)
from kinegrade.figure.marks.sides import Side
from kinegrade.figure.marks.sweep import SMALLEST_ANGLE, find_sweep
from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.mechanism.straight_parts import Bar, Rod, SlottedDisc
from kinegrade.figure.placing.mark import Mark
from kinegrade.figure.placing.obstacles import COST_LABEL, Obstacles, Segment
from kinegrade.figure.placing.wedge import Wedge, measure_narrow
from kinegrade.figure.plane import NEAR, angle_of, length, nearest_of, polar, unit
from kinegrade.figure.scene import THIN, Bow, Disc, Primitive, Strokes
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Angle

# Millimetres, the preferred radius first
_RADII = (7.0, 6.2, 5.5, 4.5, 8.5, 10.0, 12.0, 14.0, 17.0, 20.0, 3.2)
_SMALL, _TOO_SMALL = 4.0, 6.0  # millimetres of radius that are hardly seen, and their demerit
_WIDEST = 17.0  # millimetres that are still preferred for a narrow angle
_SHARE = 0.45  # largest radius of an arc over the distance to the next point on a side
_LETTER = 1.8  # millimetres from an arc to the middle of its letter

# Demerits of an arc beyond the end of a bar, or of a broad one, which needs a thin line to reach it
_EXTENDED, _EXTENDED_BROAD = 7.0, 7.0
# Demerit of an arc that ends on an arrow along a side, and millimetres of the side past the arrow
_HIDDEN, _SEEN = 8.0, 3.5
# Demerits of an arc that ends within so many millimetres of a point on a side
_ON_PIN, _ON_BLOCK = 16.0, 4.0
_PIN_ROOM, _BLOCK_ROOM = 1.6, 3.2
# Millimetres from a side, at the usual radius, to an axis through its vertex, with which it merges
# there, so that the arc would seem to end at that; and from a vertex to where an axis begins
_AT_AXIS, _BEGINS = 0.9, 1.2
_ON_SIDE = 0.1  # millimetres from a side to what is drawn along that
# Demerits of an arrowhead lost among other lines, and of one across a line, where its arc seems to
# end
_LOST_HEAD, _ACROSS_LINE = 12.0, 20.0
_AT_END = 5.0  # demerit of an arc at an end of which a line is likely to come
# Millimetres between an arc and a circle at two of the places along the arc by which they merge,
# the demerit of that, and the least radius of such a circle
_MERGES, _PROBES, _MERGED, _LEAST_CIRCLE = 1.0, (0.1, 0.3, 0.5, 0.7, 0.9), 16.0, 3.2
_WITHIN_DISC = 26.0  # demerit of an arc through a disc that its vertex is not in
# Demerit of an arc about the vertex of another angle, and millimetres of that which it keeps clear
_ENCLOSES, _ABOUT_VERTEX = 12.0, 2.5
_AT_SIDE = 0.05  # radians beside a side that count as between the sides
_LANE = 0.4  # millimetres on either side of a line to come that are kept clear of letters
_LED = 3  # arcs that may have a leader, those first that cover least


def mark_angles(
    at: Mapping[str, Vector],
    hint: Angle,
    legs: tuple[Side, ...],
    neighbours: Neighbours = ALONE,
) -> Iterator[list[AngleArc]]:
    """Arcs of several radii between two sides, told from their neighbours; none when the angle is
    too small to be visible.
    """
    reaches = _measure_reaches(at[hint.at], legs, at.values())
    nicest = choose_bow(at, hint, legs)
    if abs(nicest.sweep) > SMALLEST_ANGLE:
        bows = [_reach_ground(nicest, radius, legs) for radius in (nicest.radius, *_RADII)]
        yield [
            AngleArc(
                bow,
                legs,
                hint,
                _rate_demerit(bow.radius, nicest.radius, legs)
                + _rate_ends(bow.radius, reaches)
                + _rate_axes(bow, neighbours.lines)
                + _AT_END * is_ended_on(bow, neighbours.to_come)
                + _rate_head(bow, hint, neighbours)
                + _rate_merging(bow, neighbours.circles)
                + _rate_within(bow, neighbours.circles)
                + _rate_enclosing(bow, neighbours.arcs),
                neighbours,
            )
            for bow in bows
        ]


def find_neighbours(drawing: Drawing) -> Neighbours:
    """The circles with which the arc of an angle might merge, the axes of bars, and the edges of
    slots in discs, which part a letter from its arc as well.
    """
    round_ones = (part for part in drawing.primitives if isinstance(part, Disc | Bow))
    circles = tuple(part for part in round_ones if part.radius > _LEAST_CIRCLE)
    straight = (part for part in drawing.parts if isinstance(part, Bar | Rod))
    bars = tuple((part.start, part.end) for part in straight)
    slotted = (part for part in drawing.parts if isinstance(part, SlottedDisc))
    return Neighbours(circles, (*bars, *(edge for disc in slotted for edge in disc.list_edges())))


def list_led_arcs(arcs: Iterable[AngleArc], obstacles: Obstacles, dear: float) -> Iterator[Mark]:
    """The best arcs themselves, with leaders to their letters and demerits below `dear`."""
    costs = [(arc.demerit + obstacles.along(arc.path(), arc.shared), arc) for arc in arcs]
    for cost, arc in sorted(costs, key=itemgetter(0))[:_LED]:
        if cost < dear:
            yield from add_leaders(arc, cost, dear)


def _reach_ground(bow: Bow, radius: float, legs: Sequence[Side]) -> Bow:
    """The arc with that radius, prolonged to the ground that takes the place of a side."""
    turn = 1.0 if bow.sweep > 0 else -1.0
    first, last = [asin(leg.lag / radius) * turn for leg in legs]
    return Bow(bow.centre, radius, bow.start - first, bow.sweep + first + last, bow.pen)


def choose_bow(at: Mapping[str, Vector], hint: Angle, legs: tuple[Side, ...]) -> Bow:
    """The arc of the preferred radius: far enough out that its letter fits between the sides."""
    start, end = (leg.angle for leg in legs)
    sweep = find_sweep(hint, end - start)
    reaches = _measure_reaches(at[hint.at], legs, at.values())
    nicest = min(_RADII[0], max(_RADII[3], _SHARE * min(reaches, default=inf)))
    bow = Bow(at[hint.at], nicest, start, sweep, THIN)
    narrow = measure_narrow(hint.symbol, Wedge(bow, (legs[0].half, legs[1].half))) - _LETTER
    return replace(bow, radius=max(nicest, min(narrow, _WIDEST)))


def draw_least_legs(
    at: Mapping[str, Vector], hint: Angle, legs: tuple[Side, ...]
) -> tuple[Primitive, ...]:
    """Lines on either side of those that the sides of an angle need in any case; labels written
    before the angle keep clear of them.
    """
    narrow = choose_bow(at, hint, legs).radius > _RADII[0]
    radius = _WIDEST if narrow else _RADII[3]
    lines = [line for leg in legs if (line := leg.line(at[hint.at], radius))]
    aside = [unit(end - start).turned() * _LANE for start, end in lines]
    lanes = [
        (start + step * side, end + step * side)
        for (start, end), step in zip(lines, aside, strict=True)
        for side in (1, -1)
    ]
    return (Strokes(tuple(lanes), THIN),) if lanes else ()


def _rate_demerit(radius: float, nicest: float, legs: Iterable[Side]) -> float:
    """The demerit grows with the distance from the preferred radius, and more where a bar has to be
    prolonged, or an arrow would hide a side as far as the arc.
    """
    extended = [leg for leg in legs if 0 < leg.drawn < radius]
    prolonged = sum(_EXTENDED_BROAD if leg.broad else _EXTENDED for leg in extended)
    hidden = any(not leg.drawn and leg.hidden and radius < leg.hidden + _SEEN for leg in legs)
    small = radius < _SMALL
    return 0.6 * abs(radius - nicest) + prolonged + _HIDDEN * hidden + _TOO_SMALL * small


def _rate_ends(radius: float, reaches: Iterable[float]) -> float:
    """The demerit of an arc whose end lies on a pin, or on the block that may be there."""
    gap = min((abs(reach - radius) for reach in reaches), default=inf)
    return _ON_PIN if gap < _PIN_ROOM else _ON_BLOCK if gap < _BLOCK_ROOM else 0.0


def _rate_axes(bow: Bow, lines: Iterable[Segment]) -> float:
    """The demerit of an angle a side of which merges with an axis, or another thin line, through
    its vertex: so much that it has no good place.
    """
    tips = [bow.centre + polar(angle, _RADII[0]) for angle in (bow.start, bow.start + bow.sweep)]
    through = [line for line in lines if _leaves(bow.centre, *line)]
    gaps = [length(nearest_of(tip, *line) - tip) for line in through for tip in tips]
    return COST_LABEL * any(_ON_SIDE < gap < _AT_AXIS for gap in gaps)


def _leaves(at: Vector, start: Vector, end: Vector) -> bool:
    """Whether a line lies on one through a point, and begins at the edge of a pin there."""
    on_line = abs(unit(end - start).cross(at - start)) < NEAR
    return on_line and length(nearest_of(at, start, end) - at) < _BEGINS


def _rate_head(bow: Bow, hint: Angle, near: Neighbours) -> float:
    """The demerit of an arrowhead that is lost among other lines."""
    if not (hint.sense or hint.signed):
        return 0.0
    at_vertex = [line for line in near.to_come if line[0] == bow.centre]
    if is_across_line(bow, (*near.lines, *at_vertex)):
        return _ACROSS_LINE
    lost = is_at_pin_or_bar(bow, near.pins, near.bars)
    return _LOST_HEAD * lost


def _rate_merging(bow: Bow, circles: Iterable[Disc | Bow]) -> float:
    """The demerit of an arc that runs along a circle, of which it would seem to be a part."""
    places = _list_probes(bow)
    for circle in circles:
        on_it = (abs(length(at - circle.centre) - circle.radius) < _MERGES for at in places)
        if sum(on_it) > 1:
            return _MERGED
    return 0.0


def _list_probes(bow: Bow) -> list[Vector]:
    """Places along an arc."""
    return [bow.centre + polar(bow.start + bow.sweep * share, bow.radius) for share in _PROBES]


def _rate_within(bow: Bow, circles: Iterable[Disc | Bow]) -> float:
    """The demerit of an arc through a disc on none of its sides, as if it were a line of that."""
    ways = [polar(bow.start), polar(bow.start + bow.sweep)]
    for disc in circles:
        step = disc.centre - bow.centre
        aside = all(abs(step.cross(way)) > NEAR or step.dot(way) < 0 for way in ways)
        if isinstance(disc, Disc) and aside and length(step) > disc.radius:
            within = (length(at - disc.centre) < disc.radius for at in _list_probes(bow))
            if sum(within) > 1:
                return _WITHIN_DISC
    return 0.0


def _rate_enclosing(bow: Bow, arcs: Iterable[Bow]) -> float:
    """The demerit of an arc between whose sides another angle lies nearer to the vertex, or is cut
    by it, so that its letter might be that of either.
    """
    steps = [arc.centre - bow.centre for arc in arcs]
    within = any(
        NEAR < length(step) < bow.radius + _ABOUT_VERTEX and _lies_between(bow, angle_of(step))
        for step in steps
    )
    return _ENCLOSES * within


def _lies_between(bow: Bow, angle: float) -> bool:
    """Whether a direction lies between the sides of an angle, or along one."""
    turn = 1.0 if bow.sweep > 0 else -1.0
    return (turn * (angle - bow.start) + _AT_SIDE) % (2 * pi) <= abs(bow.sweep) + 2 * _AT_SIDE


def _measure_reaches(vertex: Vector, legs: Iterable[Side], points: Iterable[Vector]) -> list[float]:
    """The distances along the sides of an angle to other points, which may have marks too."""
    sides = [polar(leg.angle) for leg in legs]
    steps = [(point - vertex, side) for point in points for side in sides]
    reaches = [step.dot(toward) for step, toward in steps if abs(step.cross(toward)) < NEAR]
    return [reach for reach in reaches if reach > NEAR]
