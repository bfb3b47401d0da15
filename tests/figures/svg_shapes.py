"""What a printed figure shows, read from its SVG alone: areas of ink on paper and boxes of letters.

This room proves figures without the program that draws them: what lies where is read from the
file, lines become strips as wide as their pens, and what a filled shape covers is not seen.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from math import acos, cos, pi, sin, sqrt
from xml.etree import ElementTree

from shapely import LineString, MultiLineString, Point, Polygon, box
from shapely.geometry.base import BaseGeometry

from tests.figures.letters import measure_letters

SVG = "{http://www.w3.org/2000/svg}"
STEP = pi / 36  # radians between two points of an arc that is read as a polyline
THIN = 0.185  # millimetres, the pen of leaders, dimensions and arcs of angles
TOOTHED = "0.2"  # millimetres, the pen of contours with teeth
HATCHING = 2.5  # millimetres: shorter thin lines are hatching, or the arms of crosses
PIN = 1.5  # millimetres: smaller circles are pins and dots
EYE = 2.0  # millimetres: smaller circles at a rack are eyes about its pins
NUMBER = r"-?\d*\.?\d+(?:e-?\d+)?"

Point2 = tuple[float, float]


@dataclass(frozen=True)
class Letters:
    """The letters of a label and the box of their ink."""

    text: str
    box: Polygon


@dataclass(frozen=True)
class Picture:
    """A figure on its paper, in millimetres, y downward.

    `ink` is what is seen of each shape, `heads` the black triangles of arrows, `pins` the centres of
    small circles; `arcs` are the thin arcs as lines, `lines` the thin straight ones longer than
    hatching, `toothed` what gears and racks cover, teeth and all; `hatchings` are those of one
    support or guide each, `rims` the edges of wheels, `grounds` those of filled shapes without an
    outline.
    """

    paper: Polygon
    ink: tuple[BaseGeometry, ...]
    heads: tuple[Polygon, ...]
    pins: tuple[Point, ...]
    letters: tuple[Letters, ...]
    arcs: tuple[LineString, ...] = ()
    lines: tuple[LineString, ...] = ()
    toothed: tuple[Polygon, ...] = ()
    hatchings: tuple[MultiLineString, ...] = ()
    rims: tuple[LineString, ...] = ()
    grounds: tuple[LineString, ...] = ()


def read_picture(text: str) -> Picture:
    """The picture of an SVG document. Raises ValueError for an element that is not known."""
    root = ElementTree.fromstring(text)
    _, _, width, height = map(float, root.attrib["viewBox"].split())
    drawing = root.find(f"{SVG}g")
    if drawing is None:
        raise ValueError("an SVG document without a drawing")
    size = float(drawing.attrib["font-size"])
    ink: list[BaseGeometry] = []
    heads: list[Polygon] = []
    pins: list[Point] = []
    letters: list[Letters] = []
    thin: list[LineString] = []
    toothed: list[Polygon] = []
    hatchings: list[MultiLineString] = []
    rims: list[LineString] = []
    grounds: list[LineString] = []
    for element in drawing:
        if element.tag == f"{SVG}text":
            letters.append(read_letters(element, size))
            continue
        lines, area = read_shape(element)
        pins += [area.centroid] if float(element.attrib.get("r", PIN)) < PIN else []
        rims += [area.exterior] if is_rim(element) else []
        hatchings += read_hatching(element)
        grounds += [area.exterior] if is_ground(element) else []
        thin += read_thin_lines(element)
        fill = element.attrib.get("fill")
        toothed += [area] if fill and is_toothed(element) else []
        if fill is not None:
            ink = [seen for each in ink if not (seen := cover(each, area)).is_empty]
        if fill == "#000":
            ink.append(area)
            heads += [area] if len(area.exterior.coords) == 4 else []
        if element.attrib.get("stroke") != "none":
            ink.append(lines.buffer(float(element.attrib["stroke-width"]) / 2, quad_segs=3))
    arcs = tuple(line for line in thin if len(line.coords) > 2)
    lines = tuple(line for line in thin if len(line.coords) == 2 and line.length > HATCHING)
    shapes = tuple(ink), tuple(heads), tuple(pins), tuple(letters)
    round_and_rough = tuple(toothed), tuple(hatchings), tuple(rims), tuple(grounds)
    return Picture(box(0, 0, width, height), *shapes, arcs, lines, *round_and_rough)


def is_toothed(element: ElementTree.Element) -> bool:
    """Whether an element has the pen of gears and racks; the eye of a rack is part of one."""
    pen = element.attrib.get("stroke-width") == TOOTHED
    return pen and not float(element.attrib.get("r", EYE)) < EYE


def is_rim(element: ElementTree.Element) -> bool:
    """Whether an element is a wheel: a filled circle larger than a pin, or one with teeth."""
    attributes = element.attrib
    toothed = attributes.get("stroke-width") == TOOTHED
    large = float(attributes.get("r", 0.0)) >= PIN
    return "fill" in attributes and attributes.get("stroke") != "none" and (toothed or large)


def is_ground(element: ElementTree.Element) -> bool:
    """Whether an element is a filled shape without an outline, other than an arrowhead."""
    attributes = element.attrib
    return attributes.get("stroke") == "none" and attributes.get("fill") not in (None, "#000")


def read_hatching(element: ElementTree.Element) -> list[MultiLineString]:
    """The strokes of a path that is hatching: at least three short thin lines."""
    lines = read_thin_lines(element)
    hatched = len(lines) > 2 and all(line.length < HATCHING for line in lines)
    return [MultiLineString(lines)] if hatched else []


def read_thin_lines(element: ElementTree.Element) -> list[LineString]:
    """The lines of a path that is drawn with the thinnest pen and encloses nothing."""
    attributes = element.attrib
    solid = "d" in attributes and "fill" not in attributes and "stroke-dasharray" not in attributes
    if not solid or float(attributes.get("stroke-width", 1.0)) > THIN or "Z" in attributes["d"]:
        return []
    return [LineString(line) for line in read_path(attributes["d"])]


def cover(seen: BaseGeometry, area: BaseGeometry) -> BaseGeometry:
    """What is still seen below a filled shape."""
    return seen.difference(area) if seen.intersects(area) else seen


def read_shape(element: ElementTree.Element) -> tuple[BaseGeometry, Polygon]:
    """The lines of a circle or a path, and the area that they enclose."""
    match element.tag.removeprefix(SVG):
        case "circle":
            centre = Point(float(element.attrib["cx"]), float(element.attrib["cy"]))
            area = centre.buffer(float(element.attrib["r"]), quad_segs=24)
            return area.exterior, area
        case "path":
            lines = read_path(element.attrib["d"])
            longest = max(lines, key=len)
            area = Polygon(longest) if len(longest) > 2 else Polygon()
            return MultiLineString(lines), area.buffer(0) if not area.is_valid else area
        case other:
            raise ValueError(f"an element {other} in a figure")


def read_path(data: str) -> list[list[Point2]]:
    """The polylines of a path of moves, lines, arcs and closings."""
    lines: list[list[Point2]] = []
    for command, numbers in re.findall(r"([A-Z])([^A-Z]*)", data):
        values = [float(number) for number in re.findall(NUMBER, numbers)]
        match command:
            case "M":
                lines.append([(values[0], values[1])])
            case "L":
                lines[-1].append((values[0], values[1]))
            case "A":
                radius, _, _, large, sweep, x, y = values
                if large:
                    raise ValueError("an arc of more than half a turn")
                lines[-1] += trace_arc(lines[-1][-1], (x, y), radius, sweep == 1)
            case "Z":
                lines[-1].append(lines[-1][0])
            case other:
                raise ValueError(f"a command {other} in a path")
    return [line for line in lines if len(line) > 1]


def trace_arc(start: Point2, end: Point2, radius: float, clockwise: bool) -> list[Point2]:
    """Points of a circular arc of at most half a turn after its start, its end last."""
    (x, y), (to_x, to_y) = start, end
    chord = sqrt((to_x - x) ** 2 + (to_y - y) ** 2)
    if chord < 1e-9:
        return [end]
    sense = 1 if clockwise else -1
    rise = sqrt(max(radius**2 - chord**2 / 4, 0.0)) * sense
    centre_x = (x + to_x) / 2 - rise * (to_y - y) / chord
    centre_y = (y + to_y) / 2 + rise * (to_x - x) / chord
    turn = 2 * acos(min(1.0, abs(rise) / radius))
    count = max(2, int(turn / STEP))
    found = []
    for index in range(1, count):
        angle = sense * turn * index / count
        across, down = x - centre_x, y - centre_y
        found.append(
            (
                centre_x + across * cos(angle) - down * sin(angle),
                centre_y + across * sin(angle) + down * cos(angle),
            )
        )
    return [*found, end]


def read_letters(element: ElementTree.Element, size: float) -> Letters:
    """A text and the box of its ink: its spans side by side, raised and lowered, about its x."""
    pen, baseline = 0.0, float(element.attrib["y"])
    tops, bottoms, texts = [], [], []
    for span in element:
        em = float(span.attrib.get("font-size", size))
        pen += float(span.attrib.get("dx", 0.0))
        baseline += float(span.attrib.get("dy", 0.0))
        text = span.text or ""
        width, above, below = measure_letters(text)
        pen += width * em
        tops.append(baseline - above * em)
        bottoms.append(baseline + below * em)
        texts.append(text)
    left = float(element.attrib["x"]) - pen / 2
    return Letters("".join(texts), box(left, min(tops), left + pen, max(bottoms)))
