"""An axis that is shifted off its origin is found, and none where both start there."""

from __future__ import annotations

import pytest
from shapely import Point

from kinegrade.problem.template.hints import BodyFrame
from tests.figures.frame_flaws import find_axes_on_edges, find_frame_flaws
from tests.figures.printed import read_printed
from tests.figures.sheet import deal
from tests.figures.test_flaws import draw, write

FRAME = BodyFrame("x_{1}", "y_{1}", "A", "A", "B")
RIGHT = '<path d="M22 15L20 14.45L20 15.55Z" fill="#000" stroke="none"/>'
UP = '<path d="M10 3L9.45 5L10.55 5Z" fill="#000" stroke="none"/>'
LETTERS = (write("x1", 25, 16), write("y1", 12, 4))


def find(*elements: str) -> list[str]:
    return find_frame_flaws(draw(*elements, *LETTERS), {"A": Point(10.0, 15.0)}, (FRAME,))


def test_axes_from_one_origin_have_no_flaw() -> None:
    assert find(RIGHT, UP) == []


def test_an_axis_beside_its_origin_is_found() -> None:
    beside = RIGHT.replace("15L", "16.6L").replace("14.45", "16.05").replace("15.55", "17.15")
    assert find(beside, UP) == ["x1 does not start at its origin"]


@pytest.mark.parametrize("seed", ["n1", "s2"])
def test_the_axes_of_a_plate_start_at_its_corners(seed: str) -> None:
    printed = read_printed(deal("triangle-pose-three-frames", seed))
    assert find_frame_flaws(printed.picture, printed.points, printed.hints.frames) == []


GROUND = '<path d="M10 15L30 15L30 5Z" fill="#e8e8e8" stroke="none"/>'
SHAFT = '<path d="M10 15L20 15" stroke-width="0.18"/>'


def test_an_axis_in_place_of_the_outline_of_a_body_is_found() -> None:
    assert find_axes_on_edges(draw(GROUND, SHAFT, RIGHT)) == [
        "an axis is the edge of a body at (10.0, 15.0)"
    ]
    outlined = GROUND.replace('stroke="none"', 'stroke-width="0.4"')
    assert find_axes_on_edges(draw(outlined, SHAFT, RIGHT)) == []
    assert find_axes_on_edges(draw(GROUND, SHAFT)) == []


@pytest.mark.parametrize("seed", ["w81a", "w81b"])
def test_a_plate_has_an_outline_of_its_own_beside_its_axes(seed: str) -> None:
    printed = read_printed(deal("triangle-pose-three-frames", seed))
    assert find_axes_on_edges(printed.picture) == []
    assert printed.find_all_flaws() == []
