"""A template's texts may be in any languages; what one of them lacks is named."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from msgspec.structs import replace

from kinegrade.errors import TemplateError
from kinegrade.language import ENGLISH, Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.problem.statement import list_statement_languages
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.texts import (
    find_languages,
    find_missing_texts,
    find_unfinished_translations,
    note_other_scripts,
    require_language,
)
from tests.problem.crank import crank, crank_text
from tests.small_class import kinegrade

CHINESE = Language("zh")
ONLY_ENGLISH = (
    (', zh = "曲柄" }', " }"),
    ("zh = '''曲柄 {{ r }} 以 {{ omega }} 转动，$A$ 高于 $O$ {{ h.value }}。'''", ""),
    (', zh = "曲柄的长度" }', " }"),
    (', zh = "A 的高度" }', " }"),
    (', zh = "角速度" }', " }"),
    (', zh = "沿 x 轴" }', " }"),
    (', zh = "沿 y 轴" }', " }"),
)


def test_one_language_is_enough(tmp_path: Path) -> None:
    template = crank(*ONLY_ENGLISH)
    assert find_languages(template) == (ENGLISH,)
    assert find_unfinished_translations(template) == []
    (tmp_path / "crank.toml").write_text(crank_text(*ONLY_ENGLISH), encoding="utf-8")
    report = kinegrade("check", tmp_path / "crank.toml", "--sample", "20")
    assert "complete in: en\n" in report.stdout
    assert "no text in" not in report.stdout
    shown = kinegrade("show", tmp_path / "crank.toml")
    assert (shown.exit_code, "A crank" in shown.stdout) == (0, True)


def test_texts_in_no_stated_language_are_in_none(tmp_path: Path) -> None:
    text = re.sub(r'\{ en = ("[^"]*"), zh = "[^"]*" \}', r"\1", crank_text())
    text, _, rest = text.partition("[statement]\nen = ")
    statement, _, rest = rest.partition("\nzh = ")
    text = f"statement = {statement}\n{text}{rest.partition(chr(10))[2]}"
    (tmp_path / "crank.toml").write_text(text, encoding="utf-8")
    report = kinegrade("check", tmp_path / "crank.toml", "--sample", "20")
    assert "written once, in no stated language: papers in every language print" in report.stdout
    assert "complete in" not in report.stdout
    assert list_statement_languages(read_template("crank", text)) == (ENGLISH,)


def test_a_sign_in_words_may_be_written_once_too(tmp_path: Path) -> None:
    text = crank_text(('sign = "+x"', 'sign = "positive from $O$ towards $A$"'))
    (tmp_path / "crank.toml").write_text(text, encoding="utf-8")
    shown = kinegrade("show", tmp_path / "crank.toml")
    assert shown.exit_code == 0
    assert "positive from O towards A" in shown.stdout


def test_a_plain_text_is_the_same_in_every_language() -> None:
    template = crank(('{ en = "A crank", zh = "曲柄" }', '"OA"'))
    assert template.about.title.in_language(CHINESE) == "OA"
    assert find_languages(template) == (ENGLISH, CHINESE)


@pytest.mark.parametrize(
    ("title", "language", "noted"),
    [
        ("A crank", "zh", "title"),
        ("曲柄", "en", "title"),
        ("曲柄", "de", "title"),
        ("A crank", "de", ""),
        ("曲柄 OA", "zh", ""),
        (r"$OA$ at $\\sin{{ r }}$", "zh", ""),
        ("OA", "zh", ""),
    ],
)
def test_a_plain_text_in_another_script_is_noted(title: str, language: str, noted: str) -> None:
    template = crank(('{ en = "A crank", zh = "曲柄" }', f'"{title}"'))
    words = open_catalogue(ENGLISH)
    notes = [words.write(each) for each in note_other_scripts(template, Language(language))]
    scripts = [note for note in notes if "not in the script" in note]
    assert [f"these texts ({noted}) are written once" in note for note in scripts] == [True] * bool(
        noted
    )


def test_generate_notes_an_english_template_in_a_chinese_exam(tmp_path: Path) -> None:
    (tmp_path / "crank.toml").write_text(
        crank_text(('{ en = "A crank", zh = "曲柄" }', '"A crank"')), encoding="utf-8"
    )
    bank = 'title = "T"\ncourse = "C"\n[[questions]]\ntemplate = "crank.toml"\n'
    (tmp_path / "bank.toml").write_text(bank, encoding="utf-8")
    (tmp_path / "roster.csv").write_text("student,name\n1,A\n", encoding="utf-8")
    files = [tmp_path / name for name in ("bank.toml", "roster.csv", "EXAM")]
    result = kinegrade("generate", *files[:2], "-o", files[2], "--lang", "zh", "--no-papers")
    assert result.exit_code == 0
    assert "crank: these texts (title) are written once" in result.stderr


def test_a_half_added_translation_is_a_fault_for_each_missing_text(tmp_path: Path) -> None:
    half = (ONLY_ENGLISH[0], ONLY_ENGLISH[2], ONLY_ENGLISH[5])
    assert find_missing_texts(crank(*half), CHINESE) == (
        "title",
        "parameters.r.means",
        "asks.v_x.means",
    )
    (tmp_path / "crank.toml").write_text(crank_text(*half), encoding="utf-8")
    report = kinegrade("check", tmp_path / "crank.toml", "--sample", "20")
    assert "  complete in: en\n" in report.stdout
    for place in ("title", "parameters.r.means", "asks.v_x.means"):
        fault = f'fault: {place}: no text in "zh", in which others are: write it, or remove "zh"'
        assert fault in report.stdout


def test_a_language_that_templates_lack_is_refused_with_a_line_for_each() -> None:
    rod = replace(crank(ONLY_ENGLISH[2]), name="rod")
    with pytest.raises(TemplateError) as caught:
        require_language([crank(*ONLY_ENGLISH), rod, crank(*ONLY_ENGLISH)], CHINESE)
    assert caught.value.problems == (
        'crank: no text in "zh" (title, parameters.r.means, parameters.h.means, '
        "parameters.omega.means, asks.v_x.means, asks.v_y.means and 1 more) - expected every text "
        'in "zh" - write crank.zh.toml beside it, use --lang en, or choose '
        "another: kinegrade list --lang zh shows which have it",
        'rod: no text in "zh" (parameters.r.means) - expected every text in "zh" - '
        "write rod.zh.toml beside it, use --lang en, or choose "
        "another: kinegrade list --lang zh shows which have it",
    )
    nowhere = crank(ONLY_ENGLISH[2], ('en = "height of A", ', ""))
    with pytest.raises(TemplateError, match=r"write crank\.zh\.toml beside it$"):
        require_language([nowhere], CHINESE)


def test_a_text_says_in_which_languages_it_is() -> None:
    with pytest.raises(TemplateError, match='no text in "zh" - expected one of en'):
        crank(*ONLY_ENGLISH).about.title.in_language(CHINESE)
