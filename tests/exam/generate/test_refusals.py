"""An exam is written whole or not at all, and what stands in its way is said."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest
from pypdf import PdfReader

from tests.exam.generate.written_class import (
    FILES,
    NO_PANDOC,
    SHORT,
    refused,
    with_crank,
    with_nonsense,
)
from tests.small_class import (
    BANK,
    ROSTER,
    contents,
    generate,
    key_lines,
    kinegrade,
    write_class,
)


def test_what_was_done_is_said_on_standard_error(folder: Path) -> None:
    (folder / "roster.csv").write_text("student,name\n1,Ann\n", encoding="utf-8")
    result = generate(folder)
    assert result.exit_code == 0
    assert result.stdout == ""
    assert "q1: dealt from 16335 combinations of numbers\n" in result.stderr
    assert "1 paper; to hand them out: kinegrade papers " in result.stderr


def test_an_existing_folder_is_kept_unless_it_is_kinegrades_own(folder: Path) -> None:
    (folder / "roster.csv").write_text("student,name\n1,Ann\n", encoding="utf-8")
    assert generate(folder).exit_code == 0
    before = contents(folder / "EXAM")
    result = generate(folder, "EXAM", "--reproducible", "autumn")
    assert (result.exit_code, contents(folder / "EXAM")) == (2, before)
    (line,) = result.stderr.splitlines()
    assert "EXAM: already exists - expected a new folder - add --force to replace it" in line
    again = generate(folder, "EXAM", "--reproducible", "autumn", "--force", "--new-numbers")
    assert again.exit_code == 0
    assert contents(folder / "EXAM")["key.jsonl"] != before["key.jsonl"]
    (folder / "EXAM" / "my notes.txt").write_text("mine")
    assert "holds my notes.txt, which would be lost" in generate(folder, "EXAM", "--force").stderr
    (folder / "thesis").mkdir()
    (folder / "thesis" / "chapter.tex").write_text("mine")
    assert "was not written by kinegrade" in generate(folder, "thesis", "--force").stderr


@pytest.mark.parametrize(
    ("roster", "fault"),
    [
        ("student,name\n1,Ann\n1,Bob\n", 'student id "1" stands on lines 2 and 3'),
        ("who,name\n1,Ann\n", 'no column for "student"'),
        ("student,name\n,Ann\n", 'no student id ("Ann")'),
        ("student,name\n", "has no students"),
        ("", "is empty"),
    ],
)
def test_a_faulty_roster_is_refused(folder: Path, roster: str, fault: str) -> None:
    (folder / "roster.csv").write_text(roster, encoding="utf-8")
    (line,) = refused(folder)
    assert line.startswith("error: roster.csv:")
    assert fault in line


def test_an_unknown_template_is_refused(folder: Path) -> None:
    (folder / "bank.toml").write_text(
        BANK.replace('"slider-crank"', '"slider-crnk"'), encoding="utf-8"
    )
    (line,) = refused(folder)
    assert 'questions[1].template: no template "slider-crnk": did you mean "slider-crank"?' in line


def test_a_question_of_which_nothing_is_good_leaves_nothing(folder: Path) -> None:
    with_crank(
        folder,
        '[[questions]]\ntemplate = "slider-crank"\n'
        '[[questions]]\ntemplate = "crank.toml"\ndraw = { omega = [5000000] }\n',
    )
    (line,) = refused(folder)
    assert line.startswith("error: q2 (crank): none of the 6 combinations of values is fit for")
    assert line.endswith("- state more values in the question, as in draw = { r = [...] }")


def test_a_page_that_cannot_be_typeset_leaves_nothing(folder: Path) -> None:
    with_nonsense(folder)
    (line,) = refused(folder)
    assert "q1, statement" in line
    assert "nonsense" in line


def test_the_place_of_what_cannot_be_typeset_is_named_in_the_language_of_the_terminal(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("LC_ALL", "zh_CN.UTF-8")
    with_nonsense(folder)
    result = generate(folder, "NEW")
    assert result.exit_code == 2
    assert "q1，题干" in result.stderr


def test_a_name_that_no_font_prints_does_not_stop_an_exam(folder: Path) -> None:
    (folder / "roster.csv").write_text(ROSTER.replace("王伟", "😀 王"), encoding="utf-8")
    result = generate(folder)
    assert result.exit_code == 1
    assert (
        "complaint: 007: the name has characters that no font of its typesetter prints, they stand as code points"
        in result.stderr
    )
    assert sorted(entry.name for entry in (folder / "EXAM" / "papers").iterdir()) == sorted(FILES)


@pytest.mark.parametrize("option", ["--seed", "--reproducible"])
@pytest.mark.parametrize("text", ["", "  ", "\udcff"])
def test_a_label_and_words_must_be_some_text(folder: Path, option: str, text: str) -> None:
    result = generate(folder, "EXAM", option, text)
    assert result.exit_code == 2
    assert "expected some text, like spring-2026" in result.stderr
    assert not (folder / "EXAM").exists()


@pytest.mark.parametrize(
    ("character", "code", "shown"),
    [("😀", "U+1F600", "[U+1F600]"), ("\x07", "U+0007", "[U+0007]")],
)
def test_an_id_that_does_not_print_does_not_stop_a_class(
    folder: Path, character: str, code: str, shown: str
) -> None:
    student = f"0{character}7"
    with_crank(folder, SHORT)
    (folder / "roster.csv").write_text(f"student,name\n1,Ann\n{student},Bob B.\n", encoding="utf-8")
    (line,) = refused(folder, "--strict")
    problem = f"roster.csv:3: student: the id of Bob B. has characters that do not print ({code})"
    assert line.startswith(f"error: {problem} - on the paper they are code points")
    result = generate(folder, "EXAM", "--solutions")
    assert result.exit_code == 1
    assert f"complaint: {problem}" in result.stderr
    exam = folder / "EXAM"
    assert [line["student"] for line in key_lines(exam)] == ["1", student]
    for printed in ("papers", "solutions"):
        (paper,) = (file for file in (exam / printed).iterdir() if file.name != "1.pdf")
        text = "".join(page.extract_text() for page in PdfReader(paper).pages)
        assert f"0{shown}7" in "".join(letter for letter in text if letter.isprintable())


def test_without_complaints_strict_changes_nothing(folder: Path) -> None:
    assert generate(folder, "EXAM", "--strict").exit_code == 0


def test_ids_that_spreadsheets_run_are_refused_unless_they_are_allowed(folder: Path) -> None:
    files = folder / "bank.toml", folder / "roster.csv"
    result = kinegrade("generate", *files, "-o", folder / "EXAM")
    assert result.exit_code == 2
    (line,) = result.stderr.splitlines()
    assert line.startswith('error: roster.csv:5: student id "=2" (Ann) begins with =')
    assert not (folder / "EXAM").exists()


def test_a_missing_pandoc_is_reported_before_anything_is_drawn(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def draw(*arguments: object) -> None:
        raise AssertionError("work was done in vain")

    monkeypatch.setattr("kinegrade.exam.generating.generate.deal_exam", draw)
    for module in (None, SimpleNamespace(get_pandoc_path=lambda: "/nowhere/pandoc")):
        monkeypatch.setitem(sys.modules, "pypandoc", module)
        (line,) = refused(folder, "--also", "html", "--also", "docx")
        assert line == f"error: html, docx: {NO_PANDOC}"


@pytest.mark.skipif(sys.platform != "linux", reason="names of any bytes")
def test_a_folder_whose_name_is_no_utf8_gets_its_exam(tmp_path: Path) -> None:
    write_class(tmp_path)
    target = tmp_path / os.fsdecode(b"EXAM-\xff")
    result = kinegrade("generate", *(tmp_path / "bank.toml", tmp_path / "roster.csv"), *(
        "-o", target, "--allow-odd-ids"))  # fmt: skip
    assert result.exit_code == 0, result.stderr
    assert (target / "papers.pdf").read_bytes().startswith(b"%PDF")
