"""Laws of what worked solutions print, for every shipped template: read from the page alone."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest

from kinegrade.language import Language
from kinegrade.problem.template.library.library import find_template_names
from kinegrade.worked.document import Block
from kinegrade.worked.formulas.numbers import count_digits
from tests.worked.chains import chains
from tests.worked.draws import drawn, kept
from tests.worked.telling import displayed, proses

ROUNDED = re.compile(r"\\approx -?(\d+(?:\.\d+)?)(\^\\circ)?")
EXACT = 3  # digits of a number that may be exact
RULE = re.compile(r"rounded, to (\d) significant digits \(any angles to (\d) decimals\)")


def every_page(name: str) -> Iterator[tuple[Block, ...]]:
    return (kept(name, place) for place in range(len(drawn(name))))


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_all_rounded_numbers_of_a_page_have_the_digits_that_it_says_they_have(name: str) -> None:
    """Four, and two decimals of angles, or of all more, where what follows would lose digits."""
    for blocks in every_page(name):
        (rule,) = {found for text in proses(blocks) for found in RULE.findall(text)}
        assert rule in [("4", "2"), ("5", "3"), ("6", "4"), ("7", "5")]
        text = " ".join((*displayed(blocks), *proses(blocks)))
        shown = ROUNDED.findall(text)
        angles = {digits: len(digits.partition(".")[2]) for digits, degrees in shown if degrees}
        others = {digits: count_digits(digits) for digits, degrees in shown if not degrees}
        assert [one for one, places in angles.items() if places != int(rule[1])] == []
        long = {one: count for one, count in others.items() if count > EXACT}
        assert [one for one, count in long.items() if count != int(rule[0])] == []


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
