"""Each flaw of the symbols of rotations is found where there is one; printed figures have none."""

from __future__ import annotations

import pytest

from tests.figures.printed import read_printed
from tests.figures.sheet import deal
from tests.figures.test_flaws import draw, write
from tests.figures.turning_flaws import find_curved_arrows, find_turning_flaws

# About (20, 20) at its top, five millimetres from it, clockwise: an angular velocity
ARROW = (
    '<path d="M16.5 16.5A5 5 0 0 1 21.7 15.3" stroke-width="0.4"/>'
    '<path d="M23 16L21.6 14.7L21.2 15.7Z" fill="#000" stroke="none"/>'
)
PIN = '<circle cx="20" cy="20" r="0.8" fill="#fff" stroke-width="0.4"/>'
DISC = '<circle cx="20" cy="20" r="{}" fill="#eee" stroke-width="0.4"/>'


def find(*shapes: str) -> list[str]:
    return find_turning_flaws(draw(*shapes))


def test_a_curved_arrow_has_as_many_heads_as_are_drawn() -> None:
    assert [arrow.heads for arrow in find_curved_arrows(draw(ARROW))] == [1]


def test_a_symbol_nearer_to_the_pin_than_to_its_arrow_is_found() -> None:
    assert find(ARROW, PIN, write("n", 18, 20.5)) == ["n is nearer to a pin than to its own arrow"]
    assert find(ARROW, PIN, write("n", 19, 14)) == []


def test_a_symbol_beyond_a_rim_from_its_arrow_is_found() -> None:
    cut_off = ["ω is cut off from its own arrow by a rim"]
    assert find(DISC.format(7), ARROW, write("ω", 19, 10)) == cut_off
    assert find(DISC.format(7), ARROW, write("ω", 19, 18.6)) == []


def test_symbols_of_two_arrows_that_stand_at_one_another_are_found() -> None:
    found = find(ARROW, write("ω", 19, 13), write("α", 19, 10.8))
    assert found == ["ω stands at α"]
    assert find(ARROW, write("ω", 19, 13), write("α", 19, 6)) == []


@pytest.mark.parametrize(
    "template",
    [
        "differential-epicyclic-train",
        "hoist-with-gears",
        "oscillating-flat-faced-follower",
        "pin-in-disc-slot-and-rod",
        "two-stage-belt-drive",
    ],
)
def test_in_figures_each_symbol_stands_at_its_own_arrow(template: str) -> None:
    for seed in ("r1", "r2", "v71a"):
        assert find_turning_flaws(read_printed(deal(template, seed)).picture) == []
