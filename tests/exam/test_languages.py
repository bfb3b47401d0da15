"""Exams of templates and banks that are in some languages: what is kept, used and refused."""

from __future__ import annotations

from pathlib import Path

from tests.problem.crank import crank_text
from tests.problem.test_languages import ONLY_ENGLISH
from tests.problem.test_translation_files import BESIDE
from tests.small_class import VANISHING, generate, kinegrade

BANK = """
title = { en = "Midterm" }
course = "Mechanics"

[[questions]]
template = "crank.toml"
draw = { h = [0], r = [1, 2, 3], omega = [2, 3, 4] }
asks = { v_x = 1 }
"""
CHINESE_BANK = 'title = "期中测验"\n'
FEW = "student,name\n007,Ann\n"


def write_english_class(folder: Path) -> Path:
    """A bank and its template in English only."""
    template = crank_text(VANISHING, *ONLY_ENGLISH)
    (folder / "crank.toml").write_text(template, encoding="utf-8")
    (folder / "bank.toml").write_text(BANK, encoding="utf-8")
    (folder / "roster.csv").write_text(FEW, encoding="utf-8")
    return folder


def write_translations(folder: Path) -> None:
    (folder / "crank.zh.toml").write_text(BESIDE, encoding="utf-8")
    (folder / "bank.zh.toml").write_text(CHINESE_BANK, encoding="utf-8")


def test_an_exam_in_a_language_that_bank_and_template_lack_is_refused(tmp_path: Path) -> None:
    result = generate(write_english_class(tmp_path), "EXAM", "--lang", "zh")
    assert result.exit_code == 2
    assert result.stderr.splitlines() == [
        'error: bank: no text in "zh" (title) - expected every text in "zh" - write a file zh.toml '
        "of its name beside it, like demo.zh.toml beside demo.toml",
        'error: crank: no text in "zh" (title, parameters.r.means, parameters.h.means, '
        "parameters.omega.means, asks.v_x.means, asks.v_y.means and 1 more) - expected every text "
        'in "zh" - write crank.zh.toml beside it, use --lang en, or choose '
        "another: kinegrade list --lang zh shows which have it",
    ]
    assert not (tmp_path / "EXAM").exists()


def test_translations_beside_are_kept_with_an_exam_and_used_from_there(tmp_path: Path) -> None:
    write_translations(write_english_class(tmp_path))
    result = generate(tmp_path, "EXAM", "--lang", "zh")
    assert result.exit_code in (0, 1), result.output
    exam = tmp_path / "EXAM"
    assert (exam / "bank.zh.toml").read_text(encoding="utf-8") == CHINESE_BANK
    assert (exam / "templates" / "crank.zh.toml").read_text(encoding="utf-8") == BESIDE
    for name in ("bank.zh.toml", "crank.zh.toml", "crank.toml", "bank.toml"):
        (tmp_path / name).unlink()
    english, chinese = tmp_path / "en.xml", tmp_path / "zh.xml"
    for output, language in ((english, "en"), (chinese, "zh")):
        made = kinegrade("quiz", exam, "--to", "moodle-xml", "--lang", language, "-o", output)
        assert made.exit_code in (0, 1), made.output
    assert "Midterm" in english.read_text(encoding="utf-8")
    assert "期中测验" in chinese.read_text(encoding="utf-8")
    assert "曲柄" in chinese.read_text(encoding="utf-8")


def test_a_quiz_and_sheets_in_a_language_that_the_exam_lacks_are_refused(tmp_path: Path) -> None:
    assert generate(write_english_class(tmp_path)).exit_code in (0, 1)
    exam, marks, output = tmp_path / "EXAM", tmp_path / "MARKS", tmp_path / "out"
    assert kinegrade("grade", exam, exam / "answers.csv", "-o", marks).exit_code in (0, 1)
    for command in (
        ("quiz", exam, "--to", "moodle-xml"),
        ("report", exam, marks),
        ("feedback", exam, marks, "--format", "md"),
    ):
        result = kinegrade(*command, "--lang", "zh", "-o", output)
        assert result.exit_code == 2
        assert 'error: crank: no text in "zh" (title, ' in result.stderr
        assert not output.exists()


def test_what_shows_a_template_in_a_language_that_it_lacks_is_refused(tmp_path: Path) -> None:
    file = write_english_class(tmp_path) / "crank.toml"
    for command in (
        ("show", file),
        ("solve", file, "--set", "h=0", "-o", tmp_path / "page.pdf"),
        ("gallery", file, "-o", tmp_path / "page.pdf"),
    ):
        result = kinegrade(*command, "--lang", "zh")
        assert result.exit_code == 2
        assert result.stderr.startswith("error: crank: ")
        assert '"zh"' in result.stderr or "“zh”" in result.stderr  # a gallery's faults stand on it


def test_late_students_get_the_texts_that_the_others_have(tmp_path: Path) -> None:
    write_translations(write_english_class(tmp_path))
    assert generate(tmp_path, "EXAM", "--lang", "zh").exit_code in (0, 1)
    (tmp_path / "crank.zh.toml").write_text(BESIDE.replace("转动", "旋转"), encoding="utf-8")
    late = tmp_path / "late.csv"
    late.write_text("student,name\n008,Bob\n", encoding="utf-8")
    files = tmp_path / "bank.toml", tmp_path / "roster.csv"
    result = kinegrade("generate", *files, "-o", tmp_path / "EXAM", "--add", late)
    assert result.exit_code == 2
    assert "templates/crank.zh.toml: differs from what was given" in result.stderr


def test_every_fault_of_a_translated_bank_has_its_file_and_line(tmp_path: Path) -> None:
    write_translations(write_english_class(tmp_path))
    wrong = 'title = 3\n\ncourse = "力学"\ndate = "2026"\n'
    (tmp_path / "bank.zh.toml").write_text(wrong, encoding="utf-8")
    result = generate(tmp_path, "EXAM", "--lang", "zh")
    file = tmp_path / "bank.zh.toml"
    assert result.stderr.splitlines() == [
        f'error: {file}:1: title: 3 - expected a text in quotation marks, "..."',
        f"error: {file}:3: course: one text for all languages stands there - write it as "
        '{ en = "..." } there, or leave it out here',
        f"error: {file}:4: date: no such text in the file that is translated - "
        "known here: course, title",
    ]
