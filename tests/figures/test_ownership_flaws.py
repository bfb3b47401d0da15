"""The letter of a length that something else could own is found, and no other."""

from __future__ import annotations

import pytest
from shapely import Point

from kinegrade.problem.template.hints import Length
from tests.figures.ownership_flaws import find_ownership_flaws
from tests.figures.printed import read_printed
from tests.figures.sheet import deal
from tests.figures.test_flaws import LINE, draw, write

POINTS = {"A": Point(2, 10), "B": Point(38, 10)}
GIVEN = (Length("l", "A", "B"),)
AXIS = '<path d="M20 9.9L20 2" stroke-width="0.18"/>'
LEADER = '<path d="M24 10L21.6 8" stroke-width="0.18"/>'
NEARER = ["l stands nearer to something else than to its own line"]


def find(*elements: str) -> list[str]:
    return find_ownership_flaws(draw(LINE, *elements), POINTS, GIVEN)


def test_a_letter_nearer_to_another_line_is_found() -> None:
    assert find(AXIS, write("l", 20.9, 8.2)) == NEARER


def test_a_letter_at_its_own_line_or_at_a_leader_or_dimension_has_no_flaw() -> None:
    assert find(AXIS, write("l", 26, 8.5)) == []
    assert find(AXIS, LEADER, write("l", 20.9, 8.2)) == []
    dimension = '<path d="M2 6.5L38 6.5" stroke-width="0.18"/>'
    assert find(dimension, write("l", 20, 8.5)) == []


def test_a_letter_below_that_of_a_rate_is_found() -> None:
    assert find(write("v", 20, 5), write("l", 20, 8.4)) == ["l stands at v, as in a fraction"]
    assert find(write("v", 26, 5), write("l", 20, 8.4)) == []


@pytest.mark.parametrize(
    ("template", "seed"),
    [
        ("elliptic-trammel-crank-driven", "k2"),
        ("extended-rod-driving-rocker", "t1"),
        ("two-wheels-on-cylinder", "k1"),
        ("two-wheels-on-cylinder", "x91b"),
    ],
)
def test_the_letter_of_a_bar_is_clearly_that_bars(template: str, seed: str) -> None:
    printed = read_printed(deal(template, seed))
    lengths = printed.hints.lengths
    assert find_ownership_flaws(printed.picture, printed.points, lengths) == []
