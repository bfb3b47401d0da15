"""Both languages say everything, with the same places for numbers."""

from __future__ import annotations

from dataclasses import asdict

from kinegrade.exam.words import CHINESE, ENGLISH


def test_no_word_is_missing_and_places_agree() -> None:
    english, chinese = asdict(ENGLISH), asdict(CHINESE)
    assert all(english.values())
    assert all(chinese.values())
    assert {name: text.count("{}") for name, text in english.items()} == {
        name: text.count("{}") for name, text in chinese.items()
    }
