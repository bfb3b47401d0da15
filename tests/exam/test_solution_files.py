"""Worked solutions and other kinds of files through the command line."""

from __future__ import annotations

import json
import re
import zipfile
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from pypdf import PdfReader

from kinegrade.problem.solution import Solution
from kinegrade.worked.document import WorkedSolution
from kinegrade.worked.solution import write_worked_solution
from tests.printed_text import read_text
from tests.small_class import (
    STUDENTS,
    contents,
    generate,
    kinegrade,
    write_class,
    write_short_class,
)


def text_of(pdf: Path) -> str:
    return "".join(read_text(pdf).split())


@pytest.fixture(scope="module")
def solved_class(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = write_class(tmp_path_factory.mktemp("solved"))
    result = generate(folder, "EXAM", "--solutions", "--method", "pole", "--also", "html")
    assert result.exit_code == 0, result.stderr
    return folder / "EXAM"


def test_every_student_has_worked_solutions_with_the_own_key(solved_class: Path) -> None:
    students = json.loads((solved_class / "exam.json").read_text("utf-8"))["students"]
    keys = [
        json.loads(line) for line in (solved_class / "key.jsonl").read_text("utf-8").splitlines()
    ]
    for student, key in zip(students, keys, strict=True):
        text = text_of(solved_class / "solutions" / Path(student["file"]).name)
        assert student["paper"] in text
        rate = key["questions"][2]["asks"]["omega_AB"]["value"]
        assert f"{abs(rate):.4g}" in text
        assert "velocitypole" in text


def test_the_booklet_holds_all_of_them_each_on_sheets_of_its_own(solved_class: Path) -> None:
    single = [
        len(PdfReader(file).pages) for file in sorted((solved_class / "solutions").glob("*.pdf"))
    ]
    assert len(single) == len(STUDENTS)
    assert len(PdfReader(solved_class / "solutions.pdf").pages) == sum(
        count + count % 2 for count in single
    )


def test_those_of_a_version_are_worked_out_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    worked: list[object] = []

    def count(solution: Solution, *others: Any) -> WorkedSolution:
        worked.append(solution)
        return write_worked_solution(solution, *others)

    monkeypatch.setattr("kinegrade.exam.printing.solution_pages.write_worked_solution", count)
    folder = write_class(tmp_path)
    bank = folder / "bank.toml"
    bank.write_text(f"versions = 2\n{bank.read_text(encoding='utf-8')}", encoding="utf-8")
    assert generate(folder, "EXAM", "--solutions", "--jobs", "1").exit_code == 0
    assert len(list((folder / "EXAM" / "solutions").glob("*.pdf"))) == len(STUDENTS)
    assert len(worked) == 2 * 3


def test_papers_for_the_browser_lie_beside_the_papers(solved_class: Path) -> None:
    names = {file.stem for file in (solved_class / "papers").glob("*.pdf")}
    assert {file.stem for file in (solved_class / "papers").glob("*.html")} == names
    page = (solved_class / "papers" / "007.html").read_text("utf-8")
    assert "<math" in page
    assert "<script" not in page


def test_the_notice_says_who_may_see_solutions(solved_class: Path) -> None:
    assert "solutions/" in (solved_class / "INSTRUCTOR-ONLY.txt").read_text("utf-8")


def test_without_solutions_there_are_none(small_class: Path) -> None:
    assert [name for name in contents(small_class / "EXAM") if name.startswith("solutions")] == []
    refused = generate(small_class, "OTHER", "--no-solutions")
    assert (refused.exit_code, (small_class / "OTHER").exists()) == (2, False)
    assert "No such option '--no-solutions'" in refused.stderr


def test_a_paper_for_word_is_a_word_file(tmp_path: Path) -> None:
    folder = write_class(tmp_path)
    (folder / "roster.csv").write_text("student,name\n007,王伟\n", encoding="utf-8")
    assert generate(folder, "EXAM", "--also", "docx").exit_code == 0
    with zipfile.ZipFile(folder / "EXAM" / "papers" / "007.docx") as package:
        assert "王伟" in package.read("word/document.xml").decode()


@pytest.mark.left(beside="test_every_student_has_worked_solutions_with_the_own_key")
@pytest.mark.needs_tex
def test_latex_typesets_papers_key_and_solutions_and_keeps_its_sources(tmp_path: Path) -> None:
    folder = write_short_class(tmp_path)
    (folder / "roster.csv").write_text("student,name\n007,Ann\n", encoding="utf-8")
    assert generate(folder, "EXAM", "--engine", "latex", "--solutions").exit_code == 0
    exam = folder / "EXAM"
    code = json.loads((exam / "exam.json").read_text("utf-8"))["students"][0]["paper"]
    for place in ("papers", "solutions"):
        assert code in text_of(exam / place / "007.pdf")
        assert (exam / "tex" / place / "007.tex").exists()
    assert code in text_of(exam / "key.pdf")


def test_solve_typesets_the_worked_solution(tmp_path: Path) -> None:
    page = tmp_path / "solution.pdf"
    result = kinegrade(
        "solve", "slider-crank", "--set", "phi=37", "-o", page, "--method", "projection"
    )
    assert result.exit_code == 0
    assert "projectiontheorem" in text_of(page)
    assert kinegrade("solve", "slider-crank", "-o", page).exit_code == 2


# How values are rounded, not with how many digits the sides of a check agree
RULE = re.compile(r"(?<!agreeto)(?<!前)(\d)(?:significant|位有效数字|geltende)")


def test_the_questions_of_a_paper_say_how_values_are_rounded_where_that_changes(
    solved_class: Path,
) -> None:
    files = sorted((solved_class / "solutions").glob("*.pdf"))
    assert files
    for file in files:
        digits = RULE.findall(text_of(file))
        assert digits, file.name
        assert [before for before, after in pairwise(digits) if before == after] == [], file.name
