"""What a question counts downwards has one sign from its first table to its box."""

from __future__ import annotations

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
    assert not any("asked for" in text for text in proses(blocks))


@pytest.mark.parametrize(
    ("name", "symbol"),
    [
        ("belt-driven-bicycle", "n_{A}"),
        ("pin-in-two-rings", r"a_{\mathrm{r},1}^{\mathrm{t}}"),
        ("rod-ground-and-incline", "a_{B,s}"),
        ("square-on-two-fixed-points", r"v_{\mathrm{r},B}"),
    ],
)
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
