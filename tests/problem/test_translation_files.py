"""Translations in files beside a template, a shared mechanism or a bank."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from kinegrade.errors import BankError, TemplateError
from kinegrade.exam.bank.bank import read_blueprint
from kinegrade.language import ENGLISH, Language
from kinegrade.problem.template.library.library import list_names, load_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.texts import (
    find_language_faults,
    find_languages,
    find_unstated_texts,
    note_other_scripts,
)
from kinegrade.proof.checking import check
from kinegrade.proof.reporting import write_findings
from tests.problem.crank import crank_text
from tests.problem.test_languages import ONLY_ENGLISH
from tests.problem.test_shared_mechanism import MECHANISM, OWN
from tests.problem.turning_crank import CRANK
from tests.said import said
from tests.small_class import kinegrade

CHINESE = Language("zh")
BESIDE = """
title = "曲柄"
statement = "曲柄 {{ r }} 以 {{ omega }} 转动，$A$ 高于 $O$ {{ h.value }}。"

[parameters]
r = "曲柄的长度"
h = "A 的高度"
omega = "角速度"

[asks]
v_x = "沿 x 轴"
v_y = { means = "沿 y 轴" }
"""
SIGN = ('sign = "+x"', 'sign = { en = "positive to the right" }')
TEXT = (
    "[parameters]",
    '[[text.size]]\nif = "h < 1"\nen = "low"\n\n[[text.size]]\nen = "high"\n\n[parameters]',
)
USED = ("above $O$.", "above $O$, {{ size }}.")


def write(folder: Path, translation: str, *changes: tuple[str, str]) -> Path:
    """The crank in English, with a file of Chinese texts beside it."""
    file = folder / "crank.toml"
    file.write_text(crank_text(*ONLY_ENGLISH, *changes), encoding="utf-8")
    (folder / "crank.zh.toml").write_text(translation, encoding="utf-8")
    return file


def faults(file: Path) -> list[str]:
    with pytest.raises(TemplateError) as caught:
        load_template(str(file))
    return list(caught.value.problems)


def test_a_translation_beside_says_the_same_as_one_inside(tmp_path: Path) -> None:
    found = load_template(str(write(tmp_path, BESIDE)))
    inside = tmp_path / "inside" / "crank.toml"
    inside.parent.mkdir()
    inside.write_text(crank_text(), encoding="utf-8")
    same = load_template(str(inside))
    assert (found.about, found.words) == (same.about, same.words)
    assert (found.parameters, found.asks) == (same.parameters, same.asks)
    assert found.file.translations == {CHINESE: BESIDE}
    assert list_names(tmp_path) == ["crank"]
    shown = kinegrade("show", tmp_path / "crank.toml", "--lang", "zh")
    assert (shown.exit_code, shown.stdout.startswith("crank: 曲柄\n")) == (0, True)


def test_wordings_and_signs_of_the_author_are_translated_too(tmp_path: Path) -> None:
    more = BESIDE.replace('v_x = "沿 x 轴"', 'v_x = { means = "沿 x 轴", sign = "向右为正" }')
    more = more.replace("$A$ 高于", "$A$ {{ size }} 高于") + '\n[text]\nsize = ["低", "高"]\n'
    template = load_template(str(write(tmp_path, more, SIGN, TEXT, USED)))
    assert find_languages(template) == (ENGLISH, CHINESE)
    low, high = template.words.texts["size"]
    assert (low.text.in_language(CHINESE), high.text.in_language(CHINESE)) == ("低", "高")
    assert kinegrade("show", tmp_path / "crank.toml", "--lang", "zh").exit_code == 0


def test_every_fault_of_a_translation_has_its_file_and_line(tmp_path: Path) -> None:
    wrong = """
titel = "曲柄"
statement = "曲柄 {{ r }} 以 {{ omga }}"
[parameters]
r = 3
k = "没有"
h = { en = "A 的高度" }
[asks]
v_x = { means = "沿 x 轴", sign = "向右为正" }
v_y = " "
[text]
size = ["低"]
"""
    missing = "no such text in the file that is translated"
    assert faults(write(tmp_path, wrong, TEXT, USED)) == [
        'crank.zh.toml:3: statement: {{ omga }}: no such parameter - did you mean "omega"? '
        "(known here: h, omega, r, size)",
        f'crank.zh.toml:2: titel: {missing} - did you mean "title"?',
        'crank.zh.toml:5: parameters.r: 3 - expected a text in quotation marks, "..."',
        f"crank.zh.toml:6: parameters.k: {missing} - did you mean "
        '"parameters.r", "parameters.h" or "parameters.omega"?',
        f"crank.zh.toml:7: parameters.h.en: {missing} - did you mean "
        '"parameters.h", "parameters.r" or "parameters.omega"?',
        f"crank.zh.toml:9: asks.v_x.sign: {missing} - did you mean "
        '"asks.v_x", "asks.v_x.means" or "asks.v_y.means"?',
        'crank.zh.toml:10: asks.v_y: " " - expected a text in quotation marks, "..."',
    ]


def test_a_language_that_stands_inside_is_not_given_again(tmp_path: Path) -> None:
    file = write(tmp_path, BESIDE, ('title = { en = "A crank" }', 'title = { zh = "柄" }'))
    assert faults(file) == [
        'crank.zh.toml:2: title: the text in "zh" stands in that file already - '
        "leave one of the two out"
    ]
    file = write(tmp_path, BESIDE, ('title = { en = "A crank" }', 'title = "OA"'))
    assert faults(file) == [
        "crank.zh.toml:2: title: one text for all languages stands there - "
        'write it as { en = "..." } there, or leave it out here'
    ]


def test_a_translation_into_an_unknown_language_and_one_that_is_no_toml_are_refused(
    tmp_path: Path,
) -> None:
    file = write(tmp_path, "title = ")
    assert faults(file) == [
        "crank.zh.toml: Invalid value (at end of document) - expected a template in TOML - fix it"
    ]
    (tmp_path / "crank.zh.toml").rename(tmp_path / "crank.xx.toml")
    assert faults(file) == [
        f'{tmp_path}/crank.xx.toml: unknown: "xx" - expected a language with a catalogue - '
        "known here: de, en, zh"
    ]


def test_a_shared_mechanism_has_translations_beside_it(tmp_path: Path) -> None:
    folder = tmp_path / "mechanisms"
    folder.mkdir()
    english = MECHANISM.replace(', zh = "曲柄的长度"', "")
    assert english != MECHANISM
    (tmp_path / "crank.toml").write_text(OWN, encoding="utf-8")
    (folder / "arm.toml").write_text(english, encoding="utf-8")
    beside = folder / "arm.zh.toml"
    beside.write_text('[parameters]\nr = "曲柄的长度"\n', encoding="utf-8")
    template = load_template(str(tmp_path / "crank.toml"))
    assert template.parameters["r"].means.in_language(CHINESE) == "曲柄的长度"
    beside.write_text('title = "曲柄"\n[parameters]\nr = ""\n', encoding="utf-8")
    assert faults(tmp_path / "crank.toml") == [
        "mechanisms/arm.zh.toml:1: title: no such text in the file that is translated - "
        "known here: bodies.OA, parameters.h, parameters.r",
        'mechanisms/arm.zh.toml:3: parameters.r: "" - expected a text in quotation marks, "..."',
    ]


ONCE = CRANK.replace('{ en = "Crank", zh = "曲柄" }', '"Kurbel"')


def test_a_file_may_say_in_which_language_it_has_its_texts() -> None:
    text = ONCE.replace("family", 'language = "de"\nfamily', 1)
    template = read_template("crank", text)
    assert template.about.title.languages == ("de",)
    assert said(next(write_findings(check(template, 2)))) == "complete in: no language"
    plain = re.sub(r'\{ en = ("[^"]*"), zh = "[^"]*" \}', r"\1", text)
    whole = read_template("crank", plain)
    assert find_languages(whole) == ("de",)
    assert len(find_language_faults([whole], Language("en"))) == 1
    assert said(next(write_findings(check(whole, 2)))) == "complete in: de"


def test_a_language_that_there_is_not_is_refused() -> None:
    text = ONCE.replace("family", 'language = "dee"\nfamily', 1)
    with pytest.raises(TemplateError, match="language") as refusal:
        read_template("crank", text)
    assert refusal.value.problems == (
        'crank.toml:2: language: unknown: "dee" - expected a language with a catalogue - did you '
        'mean "de"? (known here: de, en, zh)',
    )


def test_texts_written_once_among_others_by_language_are_named() -> None:
    template = read_template("crank", ONCE)
    assert find_unstated_texts(template) == ("title",)
    assert said(next(write_findings(check(template, 2)))).startswith(
        "written once, while other texts are by language: title - papers in each language print "
        "them as they stand"
    )
    (note,) = note_other_scripts(template, Language("en"))
    assert said(note).startswith(
        "crank: these texts (title) are written once, in no stated language"
    )
    assert list(note_other_scripts(read_template("crank", CRANK), Language("en"))) == []


def test_a_bank_is_told_where_its_language_is_said(tmp_path: Path) -> None:
    bank = tmp_path / "bank.toml"
    bank.write_text(
        'title = "T"\ncourse = "C"\nlanguage = "de"\n[[questions]]\ntemplate = "slider-crank"\n',
        encoding="utf-8",
    )
    with pytest.raises(BankError) as refusal:
        read_blueprint(bank)
    assert refusal.value.problems == (
        f"{bank}:3: language: unknown key - a bank has none: say --lang de where papers are printed",
    )


def write_once(text: str) -> str:
    """The texts of a template written once, in the language that the file states."""
    return 'language = "en"\n' + re.sub(r'\{ en = ("[^"]*") \}', r"\1", text)


def test_texts_in_the_language_that_a_file_states_may_be_translated_beside(tmp_path: Path) -> None:
    file = write(tmp_path, BESIDE)
    before = load_template(str(file))
    once = write_once(file.read_text(encoding="utf-8"))
    assert "{ en = " not in once
    file.write_text(once, encoding="utf-8")
    found = load_template(str(file))
    assert find_languages(found) == find_languages(before) == (ENGLISH, CHINESE)
    assert found.words == before.words
    assert found.asks["v_x"].means == before.asks["v_x"].means


def test_a_text_in_the_stated_language_is_not_given_twice(tmp_path: Path) -> None:
    file = write(tmp_path, "")
    file.write_text(write_once(file.read_text(encoding="utf-8")), encoding="utf-8")
    (tmp_path / "crank.zh.toml").rename(tmp_path / "crank.en.toml")
    (tmp_path / "crank.en.toml").write_text('title = "Another"\n', encoding="utf-8")
    [fault] = faults(file)
    assert 'the text in "en" stands in that file already' in fault
