"""What is wrong with the angles of a printed picture: an arc without its letter, a letter outside
its angle or beside the arc of another one, a leader that no reader tells from other lines, an arc
that reads as a line of a wheel or runs through hatching, an arrowhead that a pin hides.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from math import hypot

from shapely import LineString, Point, Polygon

from kinegrade.problem.template.hints import Angle
from tests.figures.support_flaws import is_of_support
from tests.figures.svg_shapes import Letters, Picture

AT_ARC = 2.3  # millimetres from a letter to its arc at most
ON_ARC = 0.15  # millimetres between the end of a leader and its arc
AT_END = 1.6  # millimetres between a letter and the end of its leader
OWN = 0.2  # millimetres by which a letter is nearer to its own arc than to that of another angle
IN_WHEEL = 0.4  # share of an arc in a wheel beside its angle from which on it reads as of that
ON_SIDE = 1.0  # millimetres between the centre of a wheel and a side of an angle that leads to it
TAKEN = 0.8  # millimetres by which another point is nearer to a letter than its own arc
AT_HEAD = 1.6  # millimetres from an arrowhead of an arc to a point that would hide it
CENTRED = 0.3  # millimetres between a vertex and the centre of its arc
GREEK = dict(
    zip(
        (["alpha", "beta", "gamma", "delta", "eta", "theta", "varphi", "phi", "psi"]),
        "αβγδηθφϕψ",
        strict=True,
    )
)


@dataclass(frozen=True)
class PrintedAngle:
    """An angle as it is printed: its letter, the arc about its vertex, and the leader that joins
    them, if there is one.
    """

    letter: Letters
    vertex: Point
    arc: LineString
    leader: LineString | None


def find_angle_flaws(
    picture: Picture, points: Mapping[str, Point], angles: tuple[Angle, ...]
) -> list[str]:
    """What is wrong with the letters of angles at marked points, in words."""
    printed = [found for angle in angles if (found := _find_printed(picture, points, angle))]
    flaws: list[str] = []
    for each in printed:
        others = [other.arc for other in printed if other is not each]
        found = [*_find_flaws_of(each, others), *_find_wheels_across(each, picture)]
        found += [*_find_taken(each, points), *_find_lost(each, picture, points)]
        flaws += [f"{each.letter.text} {flaw}" for flaw in found]
    return flaws


def write_as_printed(symbol: str) -> str:
    r"""The text of a symbol in LaTeX.

    >>> write_as_printed(r"\varphi_{1}")
    'φ1'
    """
    named = re.sub(r"\\([a-z]+)", lambda name: GREEK.get(name[1], name[1]), symbol)
    return re.sub(r"[{}_\s]|mathrm", "", named)


def _find_printed(
    picture: Picture, points: Mapping[str, Point], angle: Angle
) -> PrintedAngle | None:
    """The angle with the arc about its vertex that is nearest to its letter; None where its vertex
    is not marked, or where two angles have one letter.
    """
    vertex, text = points.get(angle.at), write_as_printed(angle.symbol)
    letters = [each for each in picture.letters if each.text == text]
    if vertex is None or len(letters) != 1:
        return None
    arcs = [arc for arc in picture.arcs if is_about(arc, vertex)]
    if not arcs:
        return None
    leaders = [(arc, line) for arc in arcs if (line := _find_leader(picture, letters[0], arc))]
    if leaders:
        return PrintedAngle(letters[0], vertex, *leaders[0])
    return PrintedAngle(letters[0], vertex, min(arcs, key=letters[0].box.distance), None)


def is_about(arc: LineString, vertex: Point) -> bool:
    """Whether an arc has its centre at a point."""
    radii = [hypot(x - vertex.x, y - vertex.y) for x, y in arc.coords]
    return max(radii) - min(radii) < CENTRED


def _find_leader(picture: Picture, letter: Letters, arc: LineString) -> LineString | None:
    for line in picture.lines:
        for start, end in ((line.coords[0], line.coords[1]), (line.coords[1], line.coords[0])):
            inner = LineString(arc.coords[2:-2]) if len(arc.coords) > 6 else arc
            if inner.distance(Point(start)) < ON_ARC and letter.box.distance(Point(end)) < AT_END:
                return line
    return None


def _find_flaws_of(angle: PrintedAngle, others: list[LineString]) -> Iterator[str]:
    """The flaws of one angle."""
    box = angle.letter.box
    if angle.leader is not None:
        if _leaves_along(angle.leader, angle.arc, angle.vertex):
            yield "has a leader that runs on from its arc"
        return
    away = box.distance(angle.arc)
    if away > AT_ARC:
        yield "stands off from its arc"
    if any(box.distance(other) < away + OWN for other in others):
        yield "stands as near to the arc of another angle"
    if not _lies_within(box.centroid, angle):
        yield "stands outside its angle"


def _find_taken(angle: PrintedAngle, points: Mapping[str, Point]) -> Iterator[str]:
    """The flaw of a letter that is nearer to another point than to its arc."""
    others = [point for point in points.values() if point.distance(angle.vertex) > CENTRED]
    away = angle.letter.box.distance(angle.arc)
    if angle.leader is None and any(angle.letter.box.distance(at) < away - TAKEN for at in others):
        yield "stands nearer to another point than to its arc"


def _find_lost(angle: PrintedAngle, picture: Picture, points: Mapping[str, Point]) -> Iterator[str]:
    """The flaws of an arc through the hatching of a support, and of an arrowhead at a point."""
    coords = angle.arc.coords
    inner = LineString(coords[2:-2]) if len(coords) > 6 else angle.arc
    if any(inner.intersects(each) for each in picture.hatchings if is_of_support(each)):
        yield "has an arc through hatching"
    ends = [Point(coords[place]) for place in (0, -1)]
    tips = [end for end in ends if any(end.distance(head) < ON_ARC for head in picture.heads)]
    others = [point for point in points.values() if point.distance(angle.vertex) > CENTRED]
    if any(tip.distance(point) < AT_HEAD for tip in tips for point in others):
        yield "has its arrowhead at another point"


def _find_wheels_across(angle: PrintedAngle, picture: Picture) -> Iterator[str]:
    """The flaw of an arc through a wheel to whose centre no side of the angle leads."""
    ends = [Point(angle.arc.coords[place]) for place in (0, -1)]
    for wheel in map(Polygon, picture.rims):
        if wheel.distance(angle.vertex) > CENTRED:
            far = 1 + wheel.centroid.distance(angle.vertex)
            rays = [_trace_ray(angle.vertex, end, far) for end in ends]
            leads = any(ray.distance(wheel.centroid) < ON_SIDE for ray in rays)
            if not leads and wheel.intersection(angle.arc).length > IN_WHEEL * angle.arc.length:
                yield "has an arc through a wheel beside its angle"


def _trace_ray(vertex: Point, through: Point, size: float) -> LineString:
    """The line of some length from a vertex through another point."""
    x, y = through.x - vertex.x, through.y - vertex.y
    far = size / max(hypot(x, y), 0.1)
    return LineString([vertex, (vertex.x + far * x, vertex.y + far * y)])


def _leaves_along(leader: LineString, arc: LineString, vertex: Point) -> bool:
    """Whether a leader begins within 35 degrees of the direction of its arc."""
    start, end = sorted(leader.coords, key=lambda place: arc.distance(Point(place)))
    along = (end[0] - start[0], end[1] - start[1])
    outward = (start[0] - vertex.x, start[1] - vertex.y)
    across = along[0] * outward[0] + along[1] * outward[1]
    return abs(across) < 0.57 * hypot(*along) * hypot(*outward)


def _lies_within(place: Point, angle: PrintedAngle) -> bool:
    """Whether the ray from the vertex through a place meets the arc."""
    far = 2 * max(map(angle.vertex.distance, map(Point, angle.arc.coords)))
    ray = _trace_ray(angle.vertex, place, far)
    return bool(ray.distance(angle.arc) < ON_ARC)
