"""What a question counts downwards has one sign from its first table to its box."""

from __future__ import annotations

import re
from collections.abc import Iterable
from itertools import pairwise

import pytest

from kinegrade.language import Language
from kinegrade.problem.template.signs import write_sign
from kinegrade.worked.document import Prose, TermTable
from tests.worked.draws import drawn, kept, stated
from tests.worked.telling import boxed, displayed, proses

PRESS = {"l": "290", "m": "280", "beta": "-35", "v": "140"}


def test_a_guided_point_moves_positive_in_the_sense_of_the_question() -> None:
    """v_D was 196.1 mm/s upwards, then stood with a minus before the box."""
    blocks = stated("toggle-press", **PRESS)
    directions = [
        term.direction
        for block in blocks
        if isinstance(block, TermTable)
        for term in block.terms
        if term.direction in ("$+y$", "$-y$")
    ]
    assert directions == ["$-y$", "$-y$"]
    (line,) = (line for line in displayed(blocks) if line.startswith("v_{D} &="))
    assert line.endswith(r"\approx -196.06\,\unit{mm/s}\quad\text{(upwards)}")
    assert r"-196.06\,\unit{mm/s}" in boxed(blocks)
    assert [text for text in proses(blocks) if "asked for" in text] == []


@pytest.mark.parametrize(
    ("name", "place", "symbol"),
    [
        ("two-wheels-on-cylinder", 1, r"a_{B}^{\mathrm{t}}"),
        ("eccentric-cam-offset-follower", 0, r"v_{\mathrm{r}}"),
        ("eccentric-cam-offset-follower", 0, r"a_{\mathrm{r}}^{\mathrm{t}}"),
        ("pin-in-two-rings", 0, r"v_{\mathrm{r}1}"),
        ("pin-in-two-rings", 0, r"a_{\mathrm{r},1}^{\mathrm{t}}"),
        # transport, the point at A of a rocker whose rotation is given
        ("slotted-rocker-and-slider-two-drivers", 1, r"a_{\mathrm{e}}^{\mathrm{t}}"),
        ("slotted-bar-between-two-rods", 1, r"a_{B'A}^{\mathrm{t}}"),
        # from one point to another
        ("bent-rod-two-sleeves", 1, r"v_{\mathrm{r}B}"),
        ("bent-rod-two-sleeves", 1, r"a_{\mathrm{r}B}"),
        ("pole-sleeve-slider-rod", 1, "v_{D'}"),
        ("rod-ground-and-incline", 1, "a_{B,s}"),
        ("square-on-two-fixed-points", 1, r"v_{\mathrm{r},B}"),
    ],
)
def test_what_is_asked_about_a_centre_or_along_a_line_has_this_sense_throughout(
    name: str, place: int, symbol: str
) -> None:
    """a_B^t was 5.48 m/s^2, and then -a_B^t counted as asked for."""
    solution = drawn(name)[place]
    (asked,) = (ask for ask in solution.template.asks.values() if ask.symbol == symbol)
    blocks = kept(name, place)
    values = list_values(symbol, displayed(blocks))
    assert values, "a line gives it"
    exact = float(solution.answers[asked.name].value)
    assert [value for value in values if float(value) != pytest.approx(exact, rel=0.001)] == []
    assert [line for line in displayed(blocks) if line.startswith(f"-{symbol} &")] == []
    assert [text for text in proses(blocks) if "Counted as asked for" in text] == []


def list_values(symbol: str, lines: Iterable[str]) -> list[str]:
    """The decimals that the lines of a symbol end with."""
    left, found = "", []
    for line in lines:
        before, _, right = line.partition("&")
        left = before.strip() or left
        numbers = re.findall(r"(?:=|\\approx) (-?[\d.]+)\\,\\unit", right)
        if left == symbol and numbers:
            found.append(numbers[-1])
    return found


@pytest.mark.parametrize(("name", "symbol"), [("belt-driven-bicycle", "n_{A}")])
def test_what_is_counted_against_a_letter_of_the_page_has_its_sign_told(
    name: str, symbol: str
) -> None:
    """n_A was negative and counter-clockwise, beside rotations positive counter-clockwise."""
    asks = drawn(name)[0].template.asks.values()
    (ask,) = (ask for ask in asks if ask.symbol == symbol)
    for language in map(Language, ("en", "zh")):
        blocks = kept(name, language=language)
        before = next(
            first
            for first, block in pairwise(blocks)
            if any(line.startswith(f"{symbol} &=") for line in displayed((block,)))
        )
        told = write_sign(ask.sign, language)
        assert isinstance(before, Prose)
        assert told in before.text
        assert sum(told in text for text in proses(blocks)) > 1, "the idea says in which sense"
