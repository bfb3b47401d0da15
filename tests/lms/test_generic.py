"""The plain sheet: four columns in the exam's language, with a byte-order mark so that spreadsheets
show its names.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.errors import TableError
from kinegrade.language import Language
from kinegrade.lms.grades.dialect import ExportOptions
from kinegrade.lms.grades.systems.generic import GENERIC
from tests.golden_files import Hold
from tests.lms.marked_folder import filled, fresh, write_exam, write_marks
from tests.small_class import kinegrade

CHINESE = ExportOptions(language=Language("zh"))


def test_the_golden_file(tmp_path: Path, hold: Hold) -> None:
    text = fresh(tmp_path, GENERIC, CHINESE).text
    hold("lms/generic.csv", text)
    assert text.startswith("\ufeff学号,姓名,成绩,评语\n0012345,王伟,8.25,")


def header(folder: Path, *options: str | Path) -> str:
    """The header that `kinegrade export` writes."""
    out = folder / "out.csv"
    marks = write_marks(folder / "MARKS")
    result = kinegrade("export", marks, "--to", "generic", "-o", out, "--force", *options)
    assert result.exit_code == 0, result.stderr
    return out.read_text(encoding="utf-8-sig").splitlines()[0]


def test_the_headers_of_an_english_exam_are_english(tmp_path: Path) -> None:
    exam = write_exam(tmp_path / "EXAM")
    english, chinese = "Student ID,Name,Grade,Comment", "学号,姓名,成绩,评语"
    assert header(tmp_path) == english
    assert header(tmp_path, "--exam", exam) == english
    assert header(tmp_path, "--exam", exam, "--lang", "zh") == chinese
    assert header(tmp_path, "--lang", "zh") == chinese
    write_exam(exam, language="zh")
    assert header(tmp_path, "--exam", exam) == chinese
    assert header(tmp_path, "--exam", exam, "--lang", "en") == english


def test_a_language_is_refused_where_it_would_do_nothing(tmp_path: Path) -> None:
    marks = write_marks(tmp_path / "MARKS")
    out = tmp_path / "out.csv"
    result = kinegrade("export", marks, "--to", "moodle", "-o", out, "--lang", "en")
    assert (result.exit_code, out.exists()) == (2, False)
    assert "--lang: only the generic sheet has headers that can be translated" in result.stderr


def test_by_question_and_email(tmp_path: Path) -> None:
    text = fresh(
        tmp_path,
        GENERIC,
        ExportOptions(by=("email",), per_question=True, language=Language("zh")),
    ).text
    assert text.splitlines()[:2] == [
        "\ufeff邮箱,姓名,成绩 q1,成绩 q2",
        "w1@example.invalid,王伟,7,1.25",
    ]


def test_what_cannot_be_had_is_refused(tmp_path: Path) -> None:
    with pytest.raises(
        TableError,
        match="the generic sheet does not identify students by login .* choose one of: id, email",
    ):
        fresh(tmp_path, GENERIC, ExportOptions(by=("login",)))
    with pytest.raises(
        TableError, match="--by: id, email - expected one key for a new file - choose one"
    ):
        fresh(tmp_path, GENERIC, ExportOptions(by=("id", "email")))
    with pytest.raises(
        TableError, match="--feedback: the generic sheet takes none with --per-question"
    ):
        fresh(tmp_path, GENERIC, ExportOptions(feedback=True, per_question=True))
    with pytest.raises(
        TableError, match="--into: the generic sheet has no file to be filled in - exp"
    ):
        filled(tmp_path, GENERIC, "学号,成绩\n0012345,\n")
