"""An arrowhead of a dimension on something else is found, and none where it stands free."""

from __future__ import annotations

import pytest

from tests.figures.dimension_flaws import find_dimension_flaws
from tests.figures.printed import read_printed
from tests.figures.sheet import deal
from tests.figures.test_flaws import draw

DIMENSION = (
    '<path d="M10 5L10 11M30 5L30 11M10 10L30 10" stroke-width="0.18"/>'
    '<path d="M10 10L12 9.45L12 10.55Z" fill="#000" stroke="none"/>'
    '<path d="M30 10L28 9.45L28 10.55Z" fill="#000" stroke="none"/>'
)


def find(*elements: str) -> list[str]:
    return [flaw.split(" at ")[0] for flaw in find_dimension_flaws(draw(*elements, DIMENSION))]


@pytest.mark.parametrize("x", [11.5, 28.5])
def test_an_axis_through_an_arrowhead_is_found(x: float) -> None:
    axis = f'<path d="M{x} 2L{x} 18" stroke-width="0.18"/>'
    assert find(axis) == ["an arrowhead of a dimension lies on something"]


def test_a_dimension_that_others_cross_between_its_heads_has_no_flaw() -> None:
    assert find() == []
    assert find('<path d="M20 2L20 18" stroke-width="0.18"/>') == []


@pytest.mark.parametrize(
    ("template", "seed"),
    [
        ("eccentric-cam-offset-follower", "w2"),
        ("pose-cam-tappet", "n2"),
        ("pose-cam-tappet", "y3"),
        ("slotted-bar-between-two-rods", "p2"),
        ("pin-in-disc-slot-and-rod", "x91a"),
        ("pin-in-disc-slot-and-rod", "x91b"),
    ],
)
def test_arrowheads_stand_off_axes_arcs_and_arrows(template: str, seed: str) -> None:
    assert find_dimension_flaws(read_printed(deal(template, seed)).picture) == []
