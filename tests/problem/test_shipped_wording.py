"""How the shipped statements and asks are worded: faults that readers found once, by their kind."""

from __future__ import annotations

import re

import pytest

from kinegrade.language import ENGLISH, Language
from kinegrade.language.prose.plain import write_prose
from kinegrade.problem.statement import list_written_texts, write_specimens
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.signs import write_sign

CHINESE = Language("zh")
MAGNITUDE = {ENGLISH: "magnitude", CHINESE: "大小", Language("de"): "Betrag"}


@pytest.mark.parametrize("name", find_template_names())
def test_no_blank_stands_beside_chinese_punctuation(name: str) -> None:
    for _, text in write_specimens(load_template(name), CHINESE):
        for paragraph in text.split("\n\n"):
            printed = write_prose(paragraph, name)
            assert re.findall(r".[，。；：、）] |[ \n][，。；：、（].", printed) == []


@pytest.mark.parametrize("name", find_template_names())
def test_an_ask_and_its_sign_say_once_that_it_is_a_magnitude(name: str) -> None:
    template = load_template(name)
    for language, word in MAGNITUDE.items():
        for ask in template.asks.values():
            if ask.means.has(language):
                said = f"{ask.means.in_language(language)}, {write_sign(ask.sign, language)}"
                assert said.count(word) <= 1, said


@pytest.mark.parametrize("name", find_template_names())
def test_what_a_letter_names_has_no_article_in_an_ask(name: str) -> None:
    template = load_template(name)
    for ask in template.asks.values():
        means = ask.means.in_language(ENGLISH)
        assert re.findall(r"(?:of|from) the (?:point|slider|block|pin) \$", means) == []


@pytest.mark.parametrize("name", find_template_names())
def test_an_angle_or_a_distance_that_is_given_has_the_indefinite_article(name: str) -> None:
    for _, text in list_written_texts(load_template(name), ENGLISH):
        assert re.findall(r"(?:makes|at) the (?:angle|distance|height|depth)\s+\{\{", text) == []


@pytest.mark.parametrize("name", find_template_names())
def test_the_name_of_an_angle_leaves_it_to_its_row_that_full_turns_do_not_matter(name: str) -> None:
    for ask in load_template(name).asks.values():
        assert "full turns" not in ask.means.in_language(ENGLISH)
        assert "整" not in ask.means.in_language(CHINESE)
