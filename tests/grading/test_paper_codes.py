"""The code on a paper stands for the student's id wherever answers are typed."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.files.csv_writing import write_csv_text
from tests.small_class import generate, kinegrade, write_class


@pytest.fixture(scope="module")
def exam(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An exam of the small class."""
    folder = write_class(tmp_path_factory.mktemp("coded"))
    assert generate(folder).exit_code == 0
    return folder / "EXAM"


def mark(exam: Path, folder: Path, column: str, keys: list[str]) -> dict[str, str]:
    """Marks a sheet with a right first answer in each row; the totals of those who have any."""
    head = open_exam(exam).head
    rows = []
    for key in keys:
        student = next(each for each in head.students if key in (each.student, each.paper))
        asked = open_exam(exam).keys.line_of(student.student).questions[0].asks["v_B"]
        rows.append([key.lower().replace("-", " ") if key == student.paper else key, asked.decimal])
    text = write_csv_text([column, head.columns[0]], rows)
    (folder / "answers.csv").write_text(text, encoding="utf-8")
    result = kinegrade("grade", exam, folder / "answers.csv", "-o", folder / "MARKS")
    assert "not as in the exam" not in result.stderr
    with (folder / "MARKS" / "grades.csv").open(encoding="utf-8-sig", newline="") as lines:
        totals = {row["student"]: row["total"] for row in csv.DictReader(lines)}
    return {student: total for student, total in totals.items() if float(total or 0)}


def test_codes_and_ids_may_stand_in_one_column(exam: Path, tmp_path: Path) -> None:
    code = open_exam(exam).head.candidates["0012"].paper
    assert mark(exam, tmp_path, "student", ["007", code]) == {"007": "3", "0012": "3"}


def type_row(exam: Path, folder: Path, student: str, code: str) -> tuple[str, str]:
    """Marks a row that has both, with one answer; what is said, and whose answers it has."""
    row = [student, code, "1"]
    text = write_csv_text(["student", "paper", open_exam(exam).head.columns[0]], [row])
    (folder / "answers.csv").write_text(text, encoding="utf-8")
    result = kinegrade("grade", exam, folder / "answers.csv", "-o", folder / "MARKS")
    with (folder / "MARKS" / "marks.csv").open(encoding="utf-8-sig", newline="") as lines:
        (owner,) = {row["student"] for row in csv.DictReader(lines) if row["response"]}
    return result.stderr, owner


def test_a_code_that_contradicts_the_id_is_said(exam: Path, tmp_path: Path) -> None:
    code = open_exam(exam).head.candidates["0012"].paper
    said, owner = type_row(exam, tmp_path, "007", code)
    assert owner == "007"
    assert 'the paper with this code is that of "0012"' in said
    assert f'"007", by the id; if the code is right: kinegrade exchange EXAM {code} 007' in said


def test_a_code_beside_the_id_that_no_paper_has_is_said(exam: Path, tmp_path: Path) -> None:
    said, owner = type_row(exam, tmp_path, "007", "XXXX-XXXX")
    assert owner == "007"
    assert "no paper of the exam has this code" in said


@pytest.mark.parametrize("column", ["paper", "Code", "试卷编号"])
def test_a_sheet_may_have_codes_alone(exam: Path, tmp_path: Path, column: str) -> None:
    code = open_exam(exam).head.candidates["a/b"].paper
    assert mark(exam, tmp_path, column, [code]) == {"a/b": "3"}


def test_a_row_without_an_id_is_marked_by_the_code_which_is_said(
    exam: Path, tmp_path: Path
) -> None:
    code = open_exam(exam).head.candidates["0012"].paper
    said, owner = type_row(exam, tmp_path, " ", code)
    assert owner == "0012"
    what = "answers.csv:2: paper: no student id and no e-mail address"
    assert f'{what} - marked as the paper of "0012", by its code' in said


def test_a_row_without_an_id_and_with_two_codes_is_not_marked(exam: Path, tmp_path: Path) -> None:
    head = open_exam(exam).head
    codes = [head.candidates[each].paper for each in ("007", "0012")]
    text = write_csv_text(["student", "paper", "code", head.columns[0]], [["", *codes, "1"]])
    (tmp_path / "answers.csv").write_text(text, encoding="utf-8")
    result = kinegrade("grade", exam, tmp_path / "answers.csv", "-o", tmp_path / "MARKS")
    assert "answers.csv:2: no student id and no e-mail address - not graded" in result.stderr
