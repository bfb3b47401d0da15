"""Phrases in which the field does not speak stand in no sentence of worked solutions."""

from __future__ import annotations

import re

import pytest

from benchmarks.measures import PACKAGE
from tests.language.catalogue_faults import read_messages

CATALOGUES = PACKAGE / "language" / "catalogues"


@pytest.mark.parametrize(
    ("language", "phrase"),
    [
        ("en", r"rounded in print"),  # it is what is printed that is rounded
        ("de", r"nur im Druck"),
        ("zh", r"印刷"),  # the printing press
        ("zh", r"投影到 \$<\w+>\$ 的法线"),  # a vector has no normal line
        ("zh", r"传动的轮缘"),  # the field: pitch circles in mesh, pulleys with a belt
        ("zh", r"固定圆(?![周形])"),
    ],
)
def test_no_sentence_has_a_phrase_that_the_field_does_not_use(language: str, phrase: str) -> None:
    entries = read_messages(CATALOGUES / language)
    texts = {key: entry.string or entry.id for key, entry in entries.items()}
    assert [key for key, text in texts.items() if re.search(phrase, str(text))] == []
