"""`kinegrade report` and `kinegrade feedback`, from an exam as generated to what people read."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.small_class import kinegrade


@pytest.fixture
def exam(small_class: Path, tmp_path: Path) -> Path:
    """The small class's exam, marked, with the language of its papers."""
    shutil.copytree(small_class / "EXAM", tmp_path / "EXAM")
    result = kinegrade(
        "grade", tmp_path / "EXAM", tmp_path / "EXAM" / "answers.csv", "-o", tmp_path / "MARKS"
    )
    assert result.exit_code == 0, result.stderr
    return tmp_path / "EXAM"


def test_the_report_is_one_page_in_the_language_of_the_papers(exam: Path) -> None:
    marks, page = exam.parent / "MARKS", exam.parent / "report.html"
    assert kinegrade("report", exam, marks, "-o", page).exit_code == 0
    assert '<html lang="en">' in page.read_text(encoding="utf-8")
    again = kinegrade("report", exam, marks, "-o", page)
    assert (again.exit_code, again.stderr.count("error: ")) == (2, 1)
    assert kinegrade("report", exam, marks, "-o", page, "--lang", "zh", "--force").exit_code == 0
    assert '<html lang="zh-CN">' in page.read_text(encoding="utf-8")


@pytest.mark.parametrize("form", ["pdf", "html", "md"])
def test_everybody_gets_a_sheet(exam: Path, form: str) -> None:
    folder = exam.parent / "FEEDBACK"
    result = kinegrade("feedback", exam, exam.parent / "MARKS", "-o", folder, "--format", form)
    assert (result.exit_code, result.stdout) == (0, "")
    assert "4 sheets" in result.stderr
    assert {path.suffix for path in (folder / "sheets").iterdir()} == {f".{form}"}
    assert len(list((folder / "sheets").iterdir())) == 4


def test_solutions_are_handed_out_where_the_bank_says_so(exam: Path) -> None:
    head, folder = exam / "exam.json", exam.parent / "FEEDBACK"
    head.write_text(
        head.read_text(encoding="utf-8").replace("{", '{"solutions": true,', 1), encoding="utf-8"
    )
    wanted = kinegrade("feedback", exam, exam.parent / "MARKS", "-o", folder, "--format", "md")
    assert (wanted.exit_code, "write them with kinegrade solutions EXAM" in wanted.stderr) == (
        2,
        True,
    )
    (exam / "solutions").mkdir()
    for paper in (exam / "papers").iterdir():
        shutil.copy(paper, exam / "solutions")
    assert (
        kinegrade("feedback", exam, exam.parent / "MARKS", "-o", folder, "--format", "md").exit_code
        == 0
    )
    assert len(list((folder / "sheets").glob("*-solution.pdf"))) == 4
    without = kinegrade(
        "feedback",
        exam,
        exam.parent / "MARKS",
        "-o",
        folder,
        "--format",
        "md",
        "--no-solutions",
        "--force",
    )
    assert (without.exit_code, list((folder / "sheets").glob("*-solution.pdf"))) == (0, [])


def test_what_cannot_be_done_is_told_in_one_line(exam: Path) -> None:
    marks = exam.parent / "MARKS"
    swapped = kinegrade("report", marks, exam, "-o", exam.parent / "report.html")
    assert (swapped.exit_code, swapped.stdout) == (2, "")
    assert swapped.stderr.startswith("error: ")
    assert "expected an exam folder made by kinegrade generate" in swapped.stderr
    without = kinegrade("feedback", exam, marks, "-o", exam.parent / "FEEDBACK", "--solutions")
    assert without.exit_code == 2
    assert "write them with kinegrade solutions EXAM" in without.stderr
    assert not (exam.parent / "FEEDBACK").exists()
