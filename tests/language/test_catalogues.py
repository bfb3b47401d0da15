"""The catalogues are complete: every entry in every language, with the same places, named by code."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

import kinegrade
from benchmarks.modules import read_package
from kinegrade.language import ENGLISH, Language
from kinegrade.language.known import known_languages
from tests.language.catalogue_faults import (
    find_catalogue_faults,
    find_code_faults,
    read_messages,
)
from tests.language.update import update_language
from tests.package_files import GROUP, package_files

pytestmark = GROUP
CATALOGUES = Path(kinegrade.__file__).parent / "language" / "catalogues"
HELP = "help."  # its entries are named by the commands and options: tests/language/test_terminal.py


@pytest.mark.parametrize("language", sorted(set(known_languages()) - {ENGLISH}))
def test_every_entry_is_translated_with_its_places_numbers_and_forms(language: Language) -> None:
    assert list(find_catalogue_faults(CATALOGUES / language, CATALOGUES / ENGLISH)) == []


def test_code_names_entries_that_there_are_gives_their_parts_and_leaves_none_unused() -> None:
    found = find_code_faults(package_files(), CATALOGUES / ENGLISH)
    assert [fault for fault in found if not fault.startswith(HELP)] == []


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    """The catalogues, to be changed."""
    return Path(shutil.copytree(CATALOGUES, tmp_path / "catalogues"))


def faults(copy: Path, language: str) -> list[str]:
    return list(find_catalogue_faults(copy / language, copy / ENGLISH))


def edit(file: Path, old: str, new: str) -> None:
    text = file.read_text(encoding="utf-8")
    assert old in text
    file.write_text(text.replace(old, new, 1), encoding="utf-8")


def test_a_catalogue_brought_up_to_english_says_the_same(copy: Path) -> None:
    update_language("zh", copy)
    assert read_strings(copy / "zh") == read_strings(CATALOGUES / "zh")
    assert faults(copy, "zh") == []


def read_strings(folder: Path) -> dict[str, object]:
    return {key: message.string for key, message in read_messages(folder).items()}


def test_a_new_catalogue_has_every_entry_and_none_of_them_is_accepted_untranslated(
    copy: Path,
) -> None:
    update_language("fr", copy)
    keys = read_messages(copy / ENGLISH).keys()
    assert faults(copy, "fr") == [f"fr: {key}: not translated" for key in sorted(keys)]


def test_what_is_half_translated_is_named(copy: Path) -> None:
    grammar, chinese = copy / "zh" / "grammar.po", copy / "zh"
    edit(grammar, "应为<expected>", "应为")
    edit(grammar, "<first>和<last>", "<first:dative>和<last>")
    edit(grammar, 'msgid "<first> or <last>"', 'msgid "<first>, or <last>"')
    edit(grammar, '无"', '"')
    edit(grammar, 'msgctxt "comma"', '#, fuzzy\nmsgctxt "comma"')
    edit(grammar, 'msgctxt "known"', 'msgctxt "knwon"')
    (chinese / "help.po").unlink()
    assert faults(copy, "zh") == [
        "zh/help.po: missing",
        "zh: grammar.known: missing",
        "zh: grammar.knwon: not in English",
        "zh: grammar.and: asks for the form dative, the language has nominative",
        "zh: grammar.comma: is marked fuzzy",
        "zh: grammar.expected: has the places [], in English ['expected']",
        "zh: grammar.no-names: not translated",
        "zh: grammar.or: translates another English text",
    ]


def test_an_update_keeps_what_is_translated_and_marks_what_has_changed(copy: Path) -> None:
    english = copy / ENGLISH / "grammar.po"
    edit(english, 'msgid "none"', 'msgid "nothing"')
    edit(english, 'msgctxt "comma"', 'msgctxt "new-comma"')
    update_language("zh", copy)
    assert faults(copy, "zh") == [
        "zh: grammar.new-comma: not translated",
        "zh: grammar.no-names: is marked fuzzy",
    ]


def test_code_that_names_no_entry_or_gives_other_parts_is_found(tmp_path: Path) -> None:
    (tmp_path / "code.py").write_text(
        'Message("grammar.nothing")\n'
        'Message("grammar.expected", what="x")\n'
        'words.text(f"grammar.{joint}", first="a", last="b")\n',
        encoding="utf-8",
    )
    found = list(find_code_faults(read_package(tmp_path), CATALOGUES / ENGLISH))
    assert found[:2] == [
        "code.py:1: no entry grammar.nothing",
        "code.py:2: grammar.expected takes ['expected'], not ['what']",
    ]
    assert "language.forms: no code names it" in found
