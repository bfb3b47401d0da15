"""Each flaw of the arrow of a radius is found where there is one, and none where there is none."""

from __future__ import annotations

import pytest

from tests.figures.printed import read_printed
from tests.figures.radius_flaws import find_radius_flaws
from tests.figures.sheet import deal
from tests.figures.test_flaws import draw

WHEEL = '<circle cx="12" cy="10" r="4" fill="#e8e8e8" stroke-width="0.4"/>'
# An arrow from outside to the right of the wheel, seven millimetres long
ARROW = (
    '<path d="M17.6 10L23 10" stroke-width="0.18"/>'
    '<path d="M16 10L18 9.45L18 10.55Z" fill="#000" stroke="none"/>'
)


def about(x: float, radius: float) -> str:
    """Another wheel on the axis of the arrow."""
    return f'<circle cx="{x}" cy="10" r="{radius}" fill="#e8e8e8" stroke-width="0.4"/>'


def find(*elements: str) -> list[str]:
    return [flaw.split(" at (")[0] for flaw in find_radius_flaws(draw(*elements, ARROW))]


@pytest.mark.parametrize(
    ("elements", "flaw"),
    [
        ((about(12, 6.2), WHEEL), "an arrow of a radius fills a ring"),
        ((WHEEL, about(29, 6)), "an arrow of a radius starts at another wheel"),
    ],
)
def test_a_flaw_of_a_radius_is_found(elements: tuple[str, ...], flaw: str) -> None:
    assert find(*elements) == [flaw]


def test_an_arrow_in_the_open_or_across_a_broad_ring_has_no_flaw() -> None:
    assert find(WHEEL) == []
    assert find(WHEEL, about(34, 6)) == []
    assert find(about(12, 8), WHEEL) == []


@pytest.mark.parametrize("seed", ["n1", "w1"])
def test_radii_of_a_stepped_pulley_are_told_from_those_of_others(seed: str) -> None:
    assert find_radius_flaws(read_printed(deal("two-stage-belt-drive", seed)).picture) == []
