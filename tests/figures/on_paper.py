"""Where the points of a mechanism are on paper, and how large its parts are there."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from itertools import combinations

from shapely import Point

from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.problem.template.hints import FigureHints
from tests.figures.svg_shapes import Picture

SAME = 1e-6  # millimetres within which two points are one


def measure_parts(mechanism: Mechanism, hints: FigureHints, scale: float) -> dict[str, float]:
    """In millimetres the distances between points of a body, of named points and the radii of
    circles, by their names; nothing of a length that is zero here.
    """
    at = {name: Point(*point) for name, point in mechanism.points.items()}
    named = {frozenset((each.start, each.end)) for each in hints.lengths}
    pairs = {frozenset(pair) for body in mechanism.bodies for pair in combinations(body.points, 2)}
    found = {"".join(sorted(pair)): _measure(at, pair) * scale for pair in named | pairs}
    for joint in mechanism.joints:
        for circle in joint.list_circles():
            found[f"the circle about {circle.centre}"] = circle.radius * scale
    return {name: size for name, size in found.items() if size > SAME}


def find_points_on_paper(
    picture: Picture, mechanism: Mechanism, scale: float
) -> Mapping[str, Point]:
    """The marked points on paper by their letters, as they are printed.

    Where the figure stands on its paper is found by laying the mechanism over the small circles of
    its pins: the shift at which most of them fit. Nothing where the figure has no pin.
    """
    at = {name: (x * scale, -y * scale) for name, (x, y) in mechanism.points.items()}
    shifts = Counter(
        (round(pin.x - x, 1), round(pin.y - y, 1)) for pin in picture.pins for x, y in at.values()
    )
    if not shifts:
        return {}
    (across, down), _ = shifts.most_common(1)[0]
    moved = {name: Point(x + across, y + down) for name, (x, y) in at.items()}
    return {name: point for name, point in moved.items() if _is_marked(point, picture)}


def _measure(at: Mapping[str, Point], pair: frozenset[str]) -> float:
    one, other = (at[name] for name in pair)
    return one.distance(other)


def _is_marked(point: Point, picture: Picture) -> bool:
    """Whether something is drawn at a point: a pin, a dot, or lines that meet there."""
    return any(shape.distance(point) < 0.3 for shape in (*picture.pins, *picture.ink))
