"""A letter that something parts from its point is found, and none where nothing does."""

from __future__ import annotations

import pytest
from shapely import Point

from tests.figures.lettered_points import find_letter_flaws
from tests.figures.printed import read_printed
from tests.figures.sheet import deal
from tests.figures.test_flaws import draw, write

PIN = '<circle cx="20" cy="8.4" r="0.85" fill="#fff" stroke-width="0.4"/>'
SUPPORT = (
    '<path d="M18 12L17 13M19 12L18 13M20 12L19 13M21 12L20 13M22 12L21 13" stroke-width="0.18"/>'
)
WHEEL = '<circle cx="20" cy="8.4" r="5" fill="#e8e8e8" stroke-width="0.4"/>'
LEADER = '<path d="M26 8.4L21.3 8.4" stroke-width="0.18"/>'


def find(*elements: str) -> list[str]:
    return find_letter_flaws(draw(*elements, PIN), {"A": Point(20.0, 8.4)})


@pytest.mark.parametrize(
    ("elements", "flaw"),
    [
        ((SUPPORT, write("A", 20, 16.5)), "A stands behind hatching"),
        ((write("A", 30, 9.4),), "A far from its point"),
        ((write("A", 31, 9.4), LEADER.replace("26", "29")), "A far from its point"),
        ((WHEEL, write("A", 26.5, 9.4)), "A stands outside the wheel of its point"),
    ],
)
def test_a_letter_that_is_parted_from_its_point_is_found(
    elements: tuple[str, ...], flaw: str
) -> None:
    assert find(*elements) == [flaw]


@pytest.mark.parametrize(
    "elements",
    [
        (SUPPORT, write("A", 20, 6.5)),
        (SUPPORT, write("A", 25, 12.5)),
        (WHEEL, write("A", 20, 6.5)),
        (WHEEL, LEADER, write("A", 28, 9.4)),
        (SUPPORT, write("B", 20, 16.5)),  # the letter of something else
    ],
)
def test_a_letter_at_its_point_or_at_a_leader_has_no_flaw(elements: tuple[str, ...]) -> None:
    assert find(*elements) == []


@pytest.mark.parametrize(
    ("template", "seed"),
    [
        ("bent-rod-two-sleeves", "t1"),
        ("bent-rod-tangent-disc", "n2"),
        ("crank-slider-in-floating-link", "p1"),
        ("epicyclic-train-by-tooth-counts", "n1"),
        ("extended-rod-driving-rocker", "p2"),
        ("pole-sleeve-slider-rod", "p1"),
        ("rod-sliding-on-driven-wheel", "y3"),
        ("two-rods-driven-ends", "y1"),
    ],
)
def test_letters_stand_before_hatching_and_within_wheels_or_have_a_leader(
    template: str, seed: str
) -> None:
    printed = read_printed(deal(template, seed))
    assert find_letter_flaws(printed.picture, printed.points) == []
