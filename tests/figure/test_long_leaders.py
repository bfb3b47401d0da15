"""The symbol of a length stands at its bar or dimension line rather than at the end of a leader
that is long, or squeezed between the marks of others.
"""

from __future__ import annotations

import pytest
from shapely import LineString, Point, box

from kinegrade.figure.scene import FIRM, THIN, Bow, Scene, Strokes
from tests.figure.test_arrows_along_rods import draw

AT_END = 1.0  # millimetres between the end of a leader and its symbol
SHORT = 7.0  # millimetres of a leader
TEMPLATES = ("parallelogram-with-sliding-rod", "crank-bar-through-sleeve-with-arm")
SYMBOLS = {
    "parallelogram-with-sliding-rod": "r_{EF}",
    "crank-bar-through-sleeve-with-arm": "l_{OA}",
}


@pytest.mark.parametrize("template", TEMPLATES)
@pytest.mark.parametrize("seed", ["v71a", "33a1", "s1", "s5"])
def test_a_leader_is_short_and_off_the_arrows(template: str, seed: str) -> None:
    scene = draw(template, seed)
    arrows = list_turning_arrows(scene)
    for leader in list_leaders(scene, SYMBOLS[template]):
        assert leader.length < SHORT
        assert all(leader.distance(arrow) > AT_END for arrow in arrows)


def test_an_arrow_crosses_no_dimension_line_that_is_drawn_before_it() -> None:
    scene = draw("parallelogram-with-sliding-rod", "v71a")
    thin = list_thin_lines(scene)
    for arrow in list_turning_arrows(scene):
        assert all(arrow.distance(line) > 0.5 for line in thin)


def list_thin_lines(scene: Scene) -> list[LineString]:
    """The thin straight lines of a figure."""
    thin = [part for part in scene.primitives if isinstance(part, Strokes) and part.pen == THIN]
    return [LineString(line) for part in thin for line in part.lines]


def list_turning_arrows(scene: Scene) -> list[LineString]:
    """The arcs with heads."""
    bows = [part for part in scene.primitives if isinstance(part, Bow) and part.pen == FIRM]
    return [LineString(bow.path()) for bow in bows if bow.radius > 3.0]


def list_leaders(scene: Scene, symbol: str) -> list[LineString]:
    """The thin lines that end at a symbol."""
    [label] = [each for each in scene.labels if each.symbol == symbol]
    (x, y), wide, high = label.centre, label.width / 2, label.height / 2
    around = box(x - wide, y - high, x + wide, y + high)
    return [
        line
        for line in list_thin_lines(scene)
        if min(around.distance(Point(end)) for end in line.coords) < AT_END
    ]
