"""Words that are read: those of every language, whatever the exam's."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from kinegrade.language import Language, entries, spellings
from kinegrade.language.message import Message
from kinegrade.language.spellings import list_spellings, match_spellings

ENTRY = """msgid ""
msgstr ""
"Content-Type: text/plain; charset=utf-8\\n"

msgctxt "second"
msgid "sec|second"
msgstr "{spellings}"
"""


@pytest.fixture
def languages(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Two languages, of which one is not shipped."""
    for language, listed in (("en", ""), ("xx", "Sekunde|s.|sec")):
        (tmp_path / language).mkdir()
        text = ENTRY.format(spellings=listed)
        (tmp_path / language / "invented.po").write_text(text, encoding="utf-8")
    monkeypatch.setattr(entries, "catalogue_folder", lambda language: tmp_path / language)
    monkeypatch.setattr(spellings, "known_languages", lambda: (Language("en"), Language("xx")))


@pytest.mark.usefixtures("languages")
def test_the_spellings_of_all_languages_are_read_the_longest_first() -> None:
    assert list_spellings(Message("invented.second")) == ("Sekunde", "second", "sec", "s.")
    pattern = match_spellings(Message("invented.second"))
    assert [bool(re.fullmatch(pattern, text)) for text in ("Sekunde", "sec", "s.", "sx")] == [
        True,
        True,
        True,
        False,
    ]


def test_units_are_read_in_every_shipped_language() -> None:
    assert {"second", "秒"} <= set(list_spellings(Message("typing.unit-s")))
