"""What is wrong with a printed picture: letters that touch something or each other, letters and
arrows beyond the paper, letters that two points could own, parts too small to be seen.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import combinations, permutations

from shapely import Point, STRtree
from shapely.geometry.base import BaseGeometry

from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.problem.template.hints import FigureHints
from tests.figures.on_paper import find_points_on_paper, measure_parts
from tests.figures.svg_shapes import Picture

CLEAR = 0.15  # millimetres of paper between a letter and everything else
APART = 0.3  # millimetres of paper between two labels
EDGE = 0.25  # millimetres by which the estimated ink of a letter may reach over the edge
LEAST = 4.0  # millimetres, the smallest part
BITE = 0.05  # square millimetres that two meshing teeth cover in common, of rounding
OWN = 0.1  # millimetres by which a letter is nearer to its own point than to any other


def find_flaws(picture: Picture) -> list[str]:
    """What is wrong on paper, in words; nothing as a rule."""
    letters = [*_find_touched(picture), *_find_close_labels(picture)]
    return [*letters, *_find_outside(picture), *_find_tooth_on_tooth(picture)]


def find_part_flaws(
    picture: Picture, mechanism: Mechanism, hints: FigureHints, scale: float
) -> list[str]:
    """What is wrong with the parts of a mechanism (in metres) on paper, `scale` millimetres for a
    metre.
    """
    small = [
        f"{name} is {size:.1f} mm"
        for name, size in measure_parts(mechanism, hints, scale).items()
        if size < LEAST
    ]
    points = find_points_on_paper(picture, mechanism, scale)
    return [*small, *_find_disowned(picture, points)]


def _find_touched(picture: Picture) -> Iterator[str]:
    """Letters through which something is drawn."""
    tree = STRtree(picture.ink)
    for each in picture.letters:
        if len(tree.query(each.box.buffer(CLEAR), predicate="intersects")):
            yield f"{each.text} touches a line {_write_place(each.box)}"


def _find_close_labels(picture: Picture) -> Iterator[str]:
    for one, other in combinations(picture.letters, 2):
        if one.box.distance(other.box) < APART:
            yield f"{one.text} touches {other.text} {_write_place(one.box)}"


def _find_outside(picture: Picture) -> Iterator[str]:
    paper = picture.paper.buffer(EDGE, join_style="mitre")
    if not all(paper.covers(head) for head in picture.heads):
        yield "an arrow beyond the paper"
    for each in picture.letters:
        if not paper.covers(each.box):
            yield f"{each.text} beyond the paper"


def _find_tooth_on_tooth(picture: Picture) -> Iterator[str]:
    """Gears and racks that bite into each other; one that lies within another is in another plane,
    or in a ring.
    """
    for one, other in combinations(picture.toothed, 2):
        common = one.intersection(other)
        if BITE < common.area < min(one.area, other.area) - BITE:
            yield f"tooth on tooth {_write_place(common)}"


def _find_disowned(picture: Picture, points: Mapping[str, Point]) -> Iterator[str]:
    """Letters of points that stand nearer to another marked point."""
    lettered = [each for each in picture.letters if each.text in points]
    for each, other in permutations(lettered, 2):
        own, point = points[each.text], points[other.text]
        away = each.box.distance(own) + OWN
        if point.distance(own) > OWN and each.box.distance(point) < away:
            yield f"{each.text} stands nearer to {other.text} {_write_place(each.box)}"


def _write_place(shape: BaseGeometry) -> str:
    x, y = shape.centroid.coords[0]
    return f"at ({x:.1f}, {y:.1f})"
