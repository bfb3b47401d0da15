"""Each flaw of the symbols of straight arrows is found where there is one; printed figures have
none.
"""

from __future__ import annotations

import pytest

from tests.figures.arrow_flaws import (
    find_arrow_flaws,
    find_arrows,
    find_arrows_on_dimensions,
)
from tests.figures.printed import read_printed
from tests.figures.sheet import deal
from tests.figures.test_flaws import draw, write

# To the right: a velocity, and two millimetres below it an acceleration, longer than that
VELOCITY = (
    '<path d="M4 10L12.4 10" stroke-width="0.4"/>'
    '<path d="M14 10L12 9.45L12 10.55Z" fill="#000" stroke="none"/>'
)
ACCELERATION = (
    '<path d="M4 12L16.4 12" stroke-width="0.4"/>'
    '<path d="M18 12L16 11.45L16 12.55Z" fill="#000" stroke="none"/>'
    '<path d="M16.4 12L14.4 11.45L14.4 12.55Z" fill="#000" stroke="none"/>'
)


def find(*letters: str) -> list[str]:
    return find_arrow_flaws(draw(VELOCITY, ACCELERATION, *letters))


def test_an_arrow_has_as_many_heads_as_are_drawn() -> None:
    arrows = list(find_arrows(draw(VELOCITY, ACCELERATION)))
    assert [(arrow.heads, round(arrow.line.length)) for arrow in arrows] == [(1, 10), (2, 14)]


@pytest.mark.parametrize(
    ("placed", "flaw"),
    [
        (write("v", 8, 15.5), "v is nearer to another arrow than to its own"),
        (write("a", 8, 9), "a is nearer to another arrow than to its own"),
        (write("v", 20, 12.5), "v is nearer to another arrow than to its own"),
    ],
)
def test_a_symbol_at_the_wrong_arrow_is_found(placed: str, flaw: str) -> None:
    assert flaw in find(placed)


def test_a_symbol_past_the_tip_of_another_arrow_is_found() -> None:
    assert find(write("a", 17, 10.7)) == ["a stands past the tip of another arrow"]
    assert find(write("a", 17, 11.4)) == []


def test_symbols_on_the_outer_sides_of_two_arrows_have_no_flaw() -> None:
    assert find(write("v", 8, 9), write("a", 16, 15.5)) == []


def test_a_symbol_beyond_a_bar_from_its_arrow_is_found() -> None:
    bar = '<path d="M2 8L20 8" stroke-width="0.8"/>'
    cut_off = ["v is cut off from its own arrow by a bar"]
    assert find_arrow_flaws(draw(VELOCITY, bar, write("v", 8, 6.5))) == cut_off
    assert find_arrow_flaws(draw(VELOCITY, bar, write("v", 8, 13))) == []


def test_an_arrow_along_the_line_of_a_dimension_is_found() -> None:
    dimension = (
        '<path d="M3 10L22 10M3 2L22 2M21 10L21 2" stroke-width="0.18"/>'
        '<path d="M21 10L20.45 8L21.55 8Z" fill="#000" stroke="none"/>'
        '<path d="M21 2L20.45 4L21.55 4Z" fill="#000" stroke="none"/>'
    )
    lies_on = ["an arrow to (14.0, 10.0) lies on the line of a dimension"]
    assert find_arrows_on_dimensions(draw(VELOCITY, dimension)) == lies_on
    assert find_arrows_on_dimensions(draw(ACCELERATION, dimension)) == []


@pytest.mark.parametrize("seed", ["v71a", "v71b", "r1", "r2"])
def test_a_dimension_begins_on_the_side_away_from_the_arrow(seed: str) -> None:
    printed = read_printed(deal("bar-through-swivelling-sleeve", seed))
    assert find_arrows_on_dimensions(printed.picture) == []


@pytest.mark.sampled(2, by="template")
@pytest.mark.parametrize(
    "template",
    [
        "bar-through-swivelling-sleeve",
        "rod-ground-and-incline",
        "rocker-driven-by-two-slider-link",
        "slider-driven-gear-on-rack",
        "slotted-bar-between-two-rods",
        "two-rods-driven-ends",
        "two-wheels-on-cylinder",
    ],
)
def test_in_figures_each_symbol_is_that_of_its_own_arrow(template: str) -> None:
    for seed in ("r1", "r2", "r3"):
        assert find_arrow_flaws(read_printed(deal(template, seed)).picture) == []
