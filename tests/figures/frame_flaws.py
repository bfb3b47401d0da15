"""What is wrong with the frames of bodies in a printed picture: an axis that does not start at its
origin, one that is the edge of its body.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise

from shapely import LineString, Point, Polygon

from kinegrade.problem.template.hints import BodyFrame
from tests.figures.angle_flaws import write_as_printed
from tests.figures.svg_shapes import Letters, Picture

AT_TIP = 4.5  # millimetres from the letter of an axis to its arrowhead at most
ON_AXIS = 0.3  # millimetres from the origin to an axis at most
ON_EDGE = 0.1  # millimetres beside the edge of a body
FAR = 60.0  # millimetres of an axis at most


def find_frame_flaws(
    picture: Picture, points: Mapping[str, Point], frames: tuple[BodyFrame, ...]
) -> list[str]:
    """The axes of frames with marked origins that do not point away from these, in words."""
    flaws = []
    marked = [frame for frame in frames if frame.at in points]
    for at, symbol in ((frame.at, name) for frame in marked for name in (frame.x, frame.y)):
        letters = [each for each in picture.letters if each.text == write_as_printed(symbol)]
        if len(letters) == 1 and not _starts_at(points[at], letters[0], picture):
            flaws.append(f"{letters[0].text} does not start at its origin")
    return flaws


def find_axes_on_edges(picture: Picture) -> list[str]:
    """The thin lines with arrowheads along which a body ends that has no other outline there."""
    edges = [LineString(side) for ground in picture.grounds for side in pairwise(ground.coords)]
    axes = [line for line in picture.lines if any(map(line.intersects, picture.heads))]
    return [
        f"an axis is the edge of a body at ({axis.coords[0][0]:.1f}, {axis.coords[0][1]:.1f})"
        for axis in axes
        if any(axis.intersection(edge.buffer(ON_EDGE)).length > axis.length / 2 for edge in edges)
    ]


def _starts_at(origin: Point, letter: Letters, picture: Picture) -> bool:
    """Whether an arrowhead beside a letter points straight away from its origin."""
    near = [head for head in picture.heads if letter.box.distance(head) < AT_TIP]
    return any(_trace_back(head).distance(origin) < ON_AXIS for head in near)


def _trace_back(head: Polygon) -> LineString:
    """The line from an arrowhead backwards, along which its shaft lies."""
    corners = list(head.exterior.coords)[:3]
    tip = max(corners, key=lambda corner: sum(Point(corner).distance(Point(c)) for c in corners))
    one, other = (corner for corner in corners if corner != tip)
    x, y = (one[0] + other[0]) / 2 - tip[0], (one[1] + other[1]) / 2 - tip[1]
    share = FAR / Point(0, 0).distance(Point(x, y))
    return LineString([tip, (tip[0] + share * x, tip[1] + share * y)])
