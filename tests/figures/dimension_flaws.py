"""What is wrong with the dimensions of a printed picture: an arrowhead on something else."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations
from math import hypot

from shapely import LineString, Point, Polygon
from shapely.geometry.base import BaseGeometry

from tests.figures.svg_shapes import Picture

ON_LINE = 0.1  # millimetres between a dimension line and its arrowheads
OWN = 0.3  # millimetres beside a dimension line and its extension lines that are its own
AT_TIP = 0.5  # millimetres about a tip, where the next dimension of a chain begins
COMMON = 0.03  # square millimetres of an arrowhead that something else may cover


@dataclass(frozen=True)
class Dimension:
    """A dimension line and its two arrowheads."""

    line: LineString
    heads: tuple[Polygon, Polygon]


def find_dimension_flaws(picture: Picture) -> list[str]:
    """What is wrong with dimensions, in words."""
    return [
        f"an arrowhead of a dimension lies on something at ({x:.1f}, {y:.1f})"
        for dimension in find_dimensions(picture)
        for x, y in _find_heads_on_ink(dimension, picture)
    ]


def _find_heads_on_ink(dimension: Dimension, picture: Picture) -> Iterator[tuple[float, float]]:
    foreign = [
        each
        for each in picture.ink
        if not _runs_along(each, dimension.line)
        and not any(each.symmetric_difference(head).area < COMMON for head in dimension.heads)
    ]
    for head in dimension.heads:
        tip, _ = find_ends(head)
        seen = head.buffer(0.1).difference(tip.buffer(AT_TIP))
        if any(seen.intersection(each).area > COMMON for each in foreign):
            yield head.centroid.coords[0]


def _runs_along(shape: BaseGeometry, line: LineString) -> bool:
    """Whether a shape is, or has, the line itself."""
    return bool(line.intersection(shape.buffer(OWN)).length > line.length / 2)


def find_dimensions(picture: Picture) -> Iterator[Dimension]:
    """Thin lines with an arrowhead towards either end."""
    for line in picture.lines:
        heads = [head for head in picture.heads if _lies_on(head, line)]
        for one, other in combinations(heads, 2):
            if _point_apart(one, other):
                yield Dimension(line, (one, other))


def find_extension_lines(picture: Picture) -> Iterator[LineString]:
    """Thin lines across the end of a dimension line, at the tip of its arrowhead."""
    for dimension in find_dimensions(picture):
        tips = [find_ends(head)[0] for head in dimension.heads]
        for line in picture.lines:
            meets = any(line.distance(tip) < ON_LINE for tip in tips)
            if meets and not _runs_along(line, dimension.line):
                yield line


def _lies_on(head: Polygon, line: LineString) -> bool:
    tip, neck = find_ends(head)
    return line.distance(tip) < ON_LINE and line.distance(neck) < ON_LINE


def _point_apart(one: Polygon, other: Polygon) -> bool:
    (tip, neck), (far_tip, far_neck) = find_ends(one), find_ends(other)
    across = (tip.x - neck.x) * (far_tip.x - far_neck.x)
    return across + (tip.y - neck.y) * (far_tip.y - far_neck.y) < 0


def find_ends(head: Polygon) -> tuple[Point, Point]:
    """The tip of an arrowhead, and the middle of its back."""
    corners = list(head.exterior.coords)[:3]
    turns = [corners[turn:] + corners[:turn] for turn in range(3)]
    tip, one, other = min(turns, key=lambda turn: hypot(*_subtract(turn[1], turn[2])))
    return Point(tip), Point((one[0] + other[0]) / 2, (one[1] + other[1]) / 2)


def _subtract(one: tuple[float, ...], other: tuple[float, ...]) -> tuple[float, float]:
    return one[0] - other[0], one[1] - other[1]
