"""Laws of what worked solutions print, for every shipped template: read from the page alone."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest

from kinegrade.language import Language
from kinegrade.problem.template.library.library import find_template_names
from kinegrade.worked.document import Block
from tests.worked.chains import chains
from tests.worked.draws import drawn, kept
from tests.worked.telling import displayed

ROUNDED = re.compile(r"\\approx -?(\d+(?:\.\d+)?)(\^\\circ)?")


def every_page(name: str) -> Iterator[tuple[Block, ...]]:
    return (kept(name, place) for place in range(len(drawn(name))))


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_a_rounded_number_has_four_digits_and_an_angle_two_decimals_or_few_more(name: str) -> None:
    """More where what follows loses digits: the law of figures in `reader` needs them."""
    for blocks in every_page(name):
        for line in displayed(blocks):
            for digits, degrees in ROUNDED.findall(line):
                if degrees:
                    assert len(digits.partition(".")[2]) <= 5
                else:
                    assert len(digits.replace(".", "").lstrip("0")) <= 7


IDLE = re.compile(r"\\cos\(-[\\a-z]|\(-\\?[a-z]+\)\^\{2\}|\\left\|\d")


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_no_sign_stands_where_it_changes_nothing(name: str) -> None:
    """cos(-theta), (-l)^2, the absolute value of a positive number."""
    for blocks in every_page(name):
        assert [line for line in displayed(blocks) if IDLE.search(line)] == []


@pytest.mark.parametrize(
    ("name", "symbol"), [("rod-ground-and-incline", "OB"), ("tangent-cam-with-roller", "OC")]
)
def test_a_length_that_is_asked_is_found_once(name: str, symbol: str) -> None:
    assert [line.startswith(f"{symbol} &=") for line in displayed(kept(name))].count(True) == 1


@pytest.mark.sampled(24, first=1)
@pytest.mark.parametrize("language", ["zh", "de"])
@pytest.mark.parametrize("name", find_template_names())
def test_languages_differ_in_words_alone(name: str, language: Language) -> None:
    other = kept(name, language=language)
    assert [type(block) for block in other] == [type(block) for block in kept(name)]
    assert _without_words(other) == _without_words(kept(name))


def _without_words(blocks: tuple[Block, ...]) -> list[list[str]]:
    """The equations without their texts, with decimal points."""
    return [[_drop_words(side) for side in (left, *parts)] for left, parts in chains(blocks)]


def _drop_words(latex: str) -> str:
    without_aside = re.sub(r"\\quad(?=\(|\\text).*", "", latex)
    return re.sub(r"\\text\{[^}]*\}", "", without_aside).replace("{,}", ".")
