"""The sentences of shipped templates stand in both languages, and no two say the same."""

from __future__ import annotations

import re

import pytest

from kinegrade.language import ENGLISH, Language
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.texts import list_lines, list_prose

CHINESE = re.compile(r"[\u4e00-\u9fff]")


@pytest.mark.parametrize("name", find_template_names())
def test_every_sentence_of_a_template_is_there_in_both_languages(name: str) -> None:
    template = load_template(name)
    for _, text in (*list_lines(template), *list_prose(template)):
        english, chinese = text.in_language(ENGLISH), text.in_language(Language("zh"))
        assert english.strip()
        assert CHINESE.search(chinese), chinese
        assert not CHINESE.search(english), english


@pytest.mark.parametrize("name", find_template_names())
def test_no_two_sentences_of_a_template_say_the_same(name: str) -> None:
    template = load_template(name)
    for language in ("en", "zh"):
        for parts in (template.parameters, template.asks):
            sentences = [part.means.in_language(language) for part in parts.values()]  # type: ignore[attr-defined]
            assert len(set(sentences)) == len(sentences)
