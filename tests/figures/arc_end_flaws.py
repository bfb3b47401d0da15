"""What is wrong at the ends of the arcs of angles in a printed picture: an arrowhead across a line
or on a black edge, so that the arc seems to end there; a line through the foot of an arc on a side.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import hypot

from shapely import LineString, Point, Polygon
from shapely.geometry.base import BaseGeometry

from tests.figures.dimension_flaws import find_ends
from tests.figures.svg_shapes import Picture

AT_END = 0.15  # millimetres between the end of an arc and the tip of its head
OWN = 0.35  # millimetres about a tip that the side takes on which the arc ends
BESIDE = 0.08  # millimetres beside a head in which paper should be seen
ON_EDGE = 0.15  # share of that which something black may take
AT_FOOT = 0.6  # millimetres from the end of an arc to a line that spoils it
THROUGH = 1.0  # millimetres that such a line has on either side
ACROSS = 0.25  # cosine of the angle between an arc and a side


def find_arc_end_flaws(picture: Picture) -> list[str]:
    """What is wrong at the ends of arcs, in words."""
    return [
        f"{flaw} at ({x:.1f}, {y:.1f})"
        for arc in picture.arcs
        for ended in (arc, arc.reverse())
        for x, y in ended.coords[:1]
        for flaw in _find_flaws_of_end(picture, ended)
    ]


def _find_flaws_of_end(picture: Picture, arc: LineString) -> Iterator[str]:
    """The flaws of the end where an arc begins."""
    end = Point(arc.coords[0])
    heads = [head for head in picture.heads if find_ends(head)[0].distance(end) < AT_END]
    if any(_crosses(line, head) for head in heads for line in picture.lines):
        yield "an arrowhead of an arc lies across a line"
    elif any(_is_on_edge(head, arc, picture) for head in heads):
        yield "an arrowhead of an arc lies on an edge"
    if any(_spoils(line, arc) for line in picture.lines):
        yield "a line runs through the end of an arc"


def _crosses(line: LineString, head: Polygon) -> bool:
    """Whether a line passes through a head, not only at its tip."""
    tip, _ = find_ends(head)
    return bool(head.difference(tip.buffer(OWN)).intersects(line))


def _is_on_edge(head: Polygon, arc: LineString, picture: Picture) -> bool:
    """Whether something black other than its own arc is beside a head, behind its tip."""
    tip, _ = find_ends(head)
    beside = head.buffer(BESIDE).difference(head).difference(tip.buffer(2 * OWN))
    others = [ink for ink in picture.ink if not _is_part(ink, head, arc)]
    return sum(beside.intersection(ink).area for ink in others) > ON_EDGE * beside.area


def _is_part(ink: BaseGeometry, head: Polygon, arc: LineString) -> bool:
    """Whether some ink is the head, or the arc."""
    is_head = ink.symmetric_difference(head).area < BESIDE**2
    return bool(is_head or ink.intersection(arc).length > arc.length / 2)


def _spoils(line: LineString, arc: LineString) -> bool:
    """Whether a line that is no side of its angle passes through the end where an arc begins."""
    (x, y), (next_x, next_y) = arc.coords[:2]
    end, along = Point(x, y), line.project(Point(x, y))
    if line.distance(end) > AT_FOOT or not THROUGH < along < line.length - THROUGH:
        return False
    (start_x, start_y), (end_x, end_y) = line.coords
    dot = (next_x - x) * (end_x - start_x) + (next_y - y) * (end_y - start_y)
    return abs(dot) > ACROSS * line.length * hypot(next_x - x, next_y - y)
