"""What is wrong with a tactile sheet, read from its SVG alone: nothing here knows the program that
draws it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations
from xml.etree import ElementTree

from shapely import Point, STRtree, unary_union
from shapely.geometry.base import BaseGeometry

from tests.figures.svg_shapes import SVG, read_shape

LEAST, THINNEST, MARGIN = 3.0, 1.0, 10.0  # millimetres
BRAILLE = 0.75  # radius of its dots
ROUGH = 0.05  # by which a polyline may leave its curve
CELL_DOT = 2.5  # from dot to dot within a cell
SIDES = {(210.0, 297.0), (297.0, 210.0)}


def find_tactile_flaws(text: str) -> Iterator[str]:
    """What keeps fingers from reading a sheet."""
    root = ElementTree.fromstring(text)
    _, _, width, height = map(float, root.attrib["viewBox"].split())
    if (width, height) not in SIDES:
        yield f"a page of {width} x {height} mm"
    drawing = root.find(f"{SVG}g")
    assert drawing is not None
    lines: list[BaseGeometry] = []
    dots: list[Point] = []
    for element in drawing:
        path, area = read_shape(element)
        stroke = element.attrib.get("stroke") != "none"
        if not stroke and abs(float(element.attrib.get("r", 0)) - BRAILLE) < 0.01:
            dots.append(area.centroid)
            continue
        if stroke and float(element.attrib["stroke-width"]) < THINNEST:
            yield f"a line of {element.attrib['stroke-width']} mm"
        pen = float(element.attrib["stroke-width"]) / 2 if stroke else 0.0
        ink = [path.buffer(pen)] if pen else []
        ink += [area] if element.attrib.get("fill") == "#000" else []
        lines.append(unary_union(ink))
    yield from _find_close_lines(lines)
    yield from _find_close_dots(lines, dots)
    everything = unary_union([*lines, *(dot.buffer(BRAILLE) for dot in dots)])
    left, bottom, right, top = everything.bounds
    if min(left, bottom, width - right, height - top) < MARGIN:
        yield "ink at the edge of the page"


def _find_close_lines(lines: Sequence[BaseGeometry]) -> Iterator[str]:
    """Lines that neither meet nor keep apart."""
    for one, other in combinations(lines, 2):
        gap = one.distance(other)
        if ROUGH < gap < LEAST - ROUGH:
            yield f"lines {gap:.2f} mm apart at {one.centroid.coords[0]}"


def _find_close_dots(lines: Sequence[BaseGeometry], dots: Sequence[Point]) -> Iterator[str]:
    """Dots of Braille beside a line, or nearer to each other than in a cell."""
    for dot in dots:
        gap = min((dot.distance(line) for line in lines), default=LEAST + 1) - BRAILLE
        if gap < LEAST - ROUGH:
            yield f"Braille {gap:.2f} mm from a line at {dot.coords[0]}"
    tree = STRtree(list(dots))
    for place, dot in enumerate(dots):
        near = [each for each in tree.query(dot.buffer(CELL_DOT - 0.1)) if each != place]
        if any(dot.distance(dots[each]) < CELL_DOT - 0.1 for each in near):
            yield f"two dots of Braille on each other at {dot.coords[0]}"


def count_braille_dots(text: str) -> int:
    """How many dots of Braille a sheet has."""
    drawing = ElementTree.fromstring(text).find(f"{SVG}g")
    assert drawing is not None
    return sum(element.attrib.get("r") == "0.75" for element in drawing)
