"""What is given on tactile sheets: lengths, angles, radii, motions and axes, each in many ways."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from itertools import product
from math import pi

from kinegrade.figure.joints.symbol import Rim
from kinegrade.figure.marks.imposed import find_imposed_sense
from kinegrade.figure.marks.lengths.measured_direction import find_measured_direction
from kinegrade.figure.marks.straight.arrow_places import Site
from kinegrade.figure.marks.sweep import find_sweep
from kinegrade.figure.marks.turning.pivots import find_turning_centre
from kinegrade.figure.placing.mark import direction
from kinegrade.figure.plane import angle_of, length, polar, unit
from kinegrade.figure.scene import Bow, Outline, Primitive, Strokes
from kinegrade.figure.symbols.arrows import HEADS
from kinegrade.figure.tactile.letters import alone, list_along_arc, list_beside
from kinegrade.figure.tactile.parts import Skeleton
from kinegrade.figure.tactile.piece import Way
from kinegrade.figure.tactile.sizes import CLEAR, HALF_HEAD, HEAD, MARK, PIN
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import TURN, Angle, Length, Moving, Turning

_OFFSETS = (14.0, -14.0, 20.0, -20.0, 28.0, -28.0, 38.0, -38.0, 50.0, -50.0)
_INSIDE = 2 * HEAD + CLEAR + 4.0  # length of a dimension line that has its heads between its ends
_OUTSIDE, _OVER = 14.0, 3.0  # of a dimension line beyond its ends; of an extension line
_ARCS = (22.0, 30.0, 40.0, 17.0, 52.0, 66.0)  # radii of the arcs of angles
_TURNING_ARCS, _SWEEP = (16.0, 22.0, 30.0, 38.0), 1.5  # radii and radians of curved arrows
_ARROW = 24.0  # length of a straight arrow
_ASIDE = (0.0, 10.0, -10.0, 16.0, -16.0, 24.0, -24.0)
_CORNERS = (9.0, 12.0)  # sides of the mark of a right angle
_AXIS = 26.0
_APART = HEAD + CLEAR + 0.6  # from the tip of one head of an arrow to the next


def list_length_ways(at: Mapping[str, Vector], given: Length, cells: str) -> Iterator[Way]:
    """Dimension lines on either side, nearer ones first."""
    start, end = at[given.start], at[given.end]
    along = unit(find_measured_direction(given.along, start, end))
    across = along.turned()
    levels = [point.dot(across) for point in (start, end)]
    for offset in _OFFSETS:
        level = (max(levels) if offset > 0 else min(levels)) + offset
        feet = [point + across * (level - point.dot(across)) for point in (start, end)]
        if (feet[1] - feet[0]).dot(along) < 0:
            feet.reverse()
        lines = (*_extend((start, end), feet), *draw_dimension(feet[0], feet[1]))
        yield Way(lines, alone(list_beside(cells, feet[0], feet[1], HALF_HEAD)))


def _extend(points: tuple[Vector, Vector], feet: list[Vector]) -> Iterator[Primitive]:
    """From clear of each point to a little beyond the dimension line."""
    for foot in feet:
        point = min(points, key=lambda each: length(foot - each))
        toward = unit(foot - point)
        first = point + toward * (PIN + CLEAR + MARK.width / 2 + 0.1)
        yield Strokes(((first, foot + toward * _OVER),), MARK)


def draw_dimension(start: Vector, end: Vector) -> tuple[Primitive, ...]:
    """A line with a head at each end; of a short one the heads stand outside."""
    along = unit(end - start)
    if length(end - start) >= _INSIDE:
        heads = (draw_head(end, along), draw_head(start, -along))
        return (Strokes(((start, end),), MARK), *heads)
    heads = (draw_head(start, along), draw_head(end, -along))
    tails = ((start - along * _OUTSIDE, start), (end, end + along * _OUTSIDE))
    return (*(Strokes((tail,), MARK) for tail in tails), *heads)


def draw_head(tip: Vector, toward: Vector) -> Outline:
    """A filled arrowhead."""
    back, across = tip - toward * HEAD, toward.turned() * HALF_HEAD
    return Outline((tip, back + across, back - across), None, "black")


def list_angle_ways(at: Mapping[str, Vector], given: Angle, cells: str) -> Iterator[Way]:
    """Arcs between the two legs."""
    vertex = at[given.at]
    legs = [unit(direction(at, vertex, name)) for name in (given.start, given.end)]
    first = angle_of(legs[0])
    sweep = find_sweep(given, angle_of(legs[1]) - first)
    for radius in _ARCS:
        bow = Bow(vertex, radius, first, sweep, MARK)
        lines = [Strokes(((vertex, vertex + leg * (radius + 6.0)),), MARK) for leg in legs]
        heads = _draw_heads(bow, 1) if given.signed else ()
        yield Way((bow, *lines, *heads), alone(list_along_arc(cells, bow, MARK.width / 2)))


def _draw_heads(bow: Bow, count: int) -> tuple[Primitive, ...]:
    """So many heads at the end of an arc, one behind the other."""
    sense = 1.0 if bow.sweep > 0 else -1.0
    heads = []
    for number in range(count):
        turn = bow.start + bow.sweep - sense * number * _APART / bow.radius
        lead = turn - sense * HEAD / 2 / bow.radius  # a chord of the arc, not its tangent
        heads.append(draw_head(bow.centre + polar(turn, bow.radius), polar(lead + sense * pi / 2)))
    return tuple(heads)


def list_radius_ways(rim: Rim, cells: str) -> Iterator[Way]:
    """Arrows from the centre to the rim."""
    arc = rim.find_arc()
    turns = [number * pi / 8 + 0.3 for number in range(16)]
    if arc:
        turns = [arc[0] + share * arc[1] for share in (0.1, 0.9, 0.25, 0.75)]
    if rim.kind == "cam":
        turns = [angle_of(rim.touch - rim.at)]
    for turn in turns:
        tip = rim.at + polar(turn, rim.radius)
        lines = (Strokes(((rim.at, tip),), MARK), draw_head(tip, polar(turn)))
        yield Way(lines, alone(list_beside(cells, rim.at, tip, HALF_HEAD)))


def list_turning_ways(skeleton: Skeleton, given: Turning, cells: str) -> Iterator[Way]:
    """Curved arrows about the pivot of a body; an acceleration has two heads."""
    mechanism = skeleton.anatomy.mechanism
    centre = find_turning_centre(mechanism, given, skeleton.drawing)
    turn = TURN[given.sense or find_imposed_sense(mechanism, given)]
    for radius, number in product(_TURNING_ARCS, range(12)):
        sweep = max(_SWEEP, 26.0 / radius) * turn
        bow = Bow(centre, radius, number * pi / 6, sweep, MARK)
        lines = (bow, *_draw_heads(bow, HEADS[given.level]))
        yield Way(lines, alone(list_along_arc(cells, bow, HALF_HEAD)))


def list_moving_ways(skeleton: Skeleton, given: Moving, cells: str) -> Iterator[Way]:
    """Straight arrows ahead of a point or beside it; an acceleration has two heads."""
    mechanism = skeleton.anatomy.mechanism
    toward = Site(mechanism).find_direction(given)
    for aside in _ASIDE:
        ahead = PIN + CLEAR + MARK.width if aside == 0 else 0.0
        start = mechanism.points[given.point] + toward * ahead + toward.turned() * aside
        lines = draw_arrow(start, start + toward * _ARROW, HEADS[given.level])
        yield Way(lines, alone(list_beside(cells, start, start + toward * _ARROW, HALF_HEAD)))


def draw_arrow(start: Vector, end: Vector, heads: int) -> tuple[Primitive, ...]:
    """A straight arrow."""
    toward = unit(end - start)
    tips = [end - toward * (number * _APART) for number in range(heads)]
    return (Strokes(((start, end),), MARK), *(draw_head(tip, toward) for tip in tips))


def list_right_angle_ways(at: Mapping[str, Vector], points: tuple[str, str, str]) -> Iterator[Way]:
    """Squares at the second of three points."""
    vertex = at[points[1]]
    legs = [unit(direction(at, vertex, name)) for name in (points[0], points[2])]
    for side in _CORNERS:
        first, last = (vertex + leg * side for leg in legs)
        corner = first + legs[1] * side
        yield Way((Outline((first, corner, last), MARK, closed=False),))


def list_axes_ways(
    origins: Iterable[tuple[Vector, Vector]], cells: tuple[str, str]
) -> Iterator[Way]:
    """A pair of axes at each of the places, given by the origin and the direction of x."""
    for origin, along in origins:
        tips = [origin + toward * _AXIS for toward in (along, along.turned())]
        lines = tuple(part for tip in tips for part in draw_arrow(origin, tip, 1))
        spots = [
            list_beside(each, origin, tip, HALF_HEAD) for each, tip in zip(cells, tips, strict=True)
        ]
        yield Way(lines, tuple(product(*spots)))
