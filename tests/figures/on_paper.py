"""Where the points of a mechanism are on paper, and how large its parts are there."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import combinations

from shapely import Point

from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.problem.template.hints import FigureHints
from tests.figures.svg_shapes import Picture

FIT = 0.05  # millimetres within which a point is at a pin
SAME = 1e-6  # millimetres within which two points are one


def measure_parts(mechanism: Mechanism, hints: FigureHints, scale: float) -> dict[str, float]:
    """In millimetres the distances between points of a body, of named points and the radii of
    circles, by their names; nothing of a length that is zero here.
    """
    at = {name: Point(*point) for name, point in mechanism.points.items()}
    pairs = [(each.start, each.end) for each in hints.lengths]
    pairs += [pair for body in mechanism.bodies for pair in combinations(body.points, 2)]
    found = {"".join(sorted(pair)): at[pair[0]].distance(at[pair[1]]) * scale for pair in pairs}
    for joint in mechanism.joints:
        for circle in joint.list_circles():
            found[f"the circle about {circle.centre}"] = circle.radius * scale
    return {name: size for name, size in found.items() if size > SAME}


def find_points_on_paper(
    picture: Picture, mechanism: Mechanism, scale: float
) -> Mapping[str, Point]:
    """The marked points on paper by their letters, as they are printed.

    Where the figure stands on its paper is found by laying the mechanism over the small circles of
    its pins: the shift at which most of them fit, and of equal ones that at which most points are
    marked, as a pin on a through bar is no circle. Nothing where the figure has no pin.
    """
    at = {name: (x * scale, -y * scale) for name, (x, y) in mechanism.points.items()}
    if not picture.pins:
        return {}
    shifts = [(pin.x - x, pin.y - y) for pin in picture.pins for x, y in at.values()]
    fitting = [_count_fitting(shift, at, picture) for shift in shifts]
    likely = [each for each, fit in zip(shifts, fitting, strict=True) if fit == max(fitting)]
    placed = [_find_marked(shift, at, picture) for shift in dict.fromkeys(likely)]
    return max(placed, key=len)


def _find_marked(
    shift: tuple[float, float], at: Mapping[str, tuple[float, float]], picture: Picture
) -> Mapping[str, Point]:
    """The points of the shifted mechanism at which something is drawn."""
    moved = {name: Point(x + shift[0], y + shift[1]) for name, (x, y) in at.items()}
    return {name: point for name, point in moved.items() if _is_marked(point, picture)}


def _count_fitting(
    shift: tuple[float, float], at: Mapping[str, tuple[float, float]], picture: Picture
) -> int:
    """How many pins have a point of the shifted mechanism at their centre."""
    moved = [(x + shift[0], y + shift[1]) for x, y in at.values()]
    return sum(any(abs(pin.x - x) + abs(pin.y - y) < FIT for x, y in moved) for pin in picture.pins)


def _is_marked(point: Point, picture: Picture) -> bool:
    """Whether something is drawn at a point: a pin, a dot, or lines that meet there."""
    return any(shape.distance(point) < 0.3 for shape in (*picture.pins, *picture.ink))
