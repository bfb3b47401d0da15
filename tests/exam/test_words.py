"""Both languages say everything, with the same places for numbers."""

from __future__ import annotations

from dataclasses import asdict

import pytest

from kinegrade.exam.words import (
    CHINESE,
    CHINESE_GALLERY,
    ENGLISH,
    ENGLISH_GALLERY,
    GalleryWords,
    Words,
)


@pytest.mark.parametrize("languages", [(ENGLISH, CHINESE), (ENGLISH_GALLERY, CHINESE_GALLERY)])
def test_no_word_is_missing_and_places_agree(languages: tuple[Words | GalleryWords, ...]) -> None:
    english, chinese = map(asdict, languages)
    assert all(english.values())
    assert all(chinese.values())
    assert {name: text.count("{}") for name, text in english.items()} == {
        name: text.count("{}") for name, text in chinese.items()
    }
