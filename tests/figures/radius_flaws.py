"""What is wrong with the arrows of radii in a printed picture: a head that fills the ring between
two circles, a tail at another wheel, whose radius it then seems to be.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import hypot

from shapely import LineString, Point, Polygon

from tests.figures.svg_shapes import Picture

AT_RIM = 0.35  # millimetres between the tip of an arrow and its rim
FILLS = 0.9  # millimetres of a ring that the head of an arrow across it leaves, at least
OFF_WHEEL = 0.8  # millimetres from the tail of an arrow to another wheel, at least
ON_AXIS = 0.15  # millimetres between the axis of an arrow and its shaft, or a centre
SAME = 0.3  # millimetres within which two centres are one


@dataclass(frozen=True)
class RadiusArrow:
    """An arrow from outside to the rim of a wheel: its tip, the end of its head, its tail."""

    wheel: Polygon
    tip: Point
    neck: Point
    tail: Point


def find_radius_flaws(picture: Picture) -> list[str]:
    """What is wrong with radii that are marked from outside, in words."""
    wheels = [Polygon(rim) for rim in picture.rims]
    return [
        f"an arrow of a radius {flaw} at ({arrow.tip.x:.1f}, {arrow.tip.y:.1f})"
        for arrow in _find_arrows(picture, wheels)
        for flaw in _find_flaws_of(arrow, wheels)
    ]


def _find_flaws_of(arrow: RadiusArrow, wheels: list[Polygon]) -> Iterator[str]:
    for wheel in wheels:
        about_one = wheel.centroid.distance(arrow.wheel.centroid) < SAME
        if about_one and wheel.area > arrow.wheel.area:
            if not wheel.buffer(-FILLS).contains(arrow.neck):
                yield "fills a ring"
        elif not about_one and wheel.distance(arrow.tail) < OFF_WHEEL:
            yield "starts at another wheel"


def _find_arrows(picture: Picture, wheels: list[Polygon]) -> Iterator[RadiusArrow]:
    for head in picture.heads:
        tip, neck = _find_ends(head)
        for wheel in wheels:
            centre = wheel.centroid
            outward = centre.distance(neck) > centre.distance(tip)
            at_rim = abs(wheel.exterior.distance(tip)) < AT_RIM
            if at_rim and outward and LineString([centre, neck]).distance(tip) < ON_AXIS:
                for line in picture.lines:
                    tail = max(map(Point, line.coords), key=tip.distance)
                    if LineString([tip, tail]).distance(neck) < ON_AXIS > line.distance(neck):
                        yield RadiusArrow(wheel, tip, neck, tail)


def _find_ends(head: Polygon) -> tuple[Point, Point]:
    """The tip of an arrowhead, and the middle of its back."""
    corners = list(head.exterior.coords)[:3]
    sides = [(hypot(b[0] - c[0], b[1] - c[1]), a, b, c) for a, b, c in _rotate(corners)]
    _, tip, one, other = min(sides)
    return Point(tip), Point((one[0] + other[0]) / 2, (one[1] + other[1]) / 2)


def _rotate(
    corners: list[tuple[float, float]],
) -> list[tuple[tuple[float, float], tuple[float, float], tuple[float, float]]]:
    a, b, c = corners
    return [(a, b, c), (b, c, a), (c, a, b)]
