"""Lines above the names of the columns, as people leave them in their sheets: a title is passed
over, and a row that may be a student's is a complaint with all that it holds.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from openpyxl import Workbook

from kinegrade.exam.folder.exam_folder import open_exam
from tests.small_class import generate, kinegrade, table, write_class

TITLE = "Midterm, group A"


@pytest.fixture(scope="module")
def exam(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An exam of the small class."""
    folder = write_class(tmp_path_factory.mktemp("titled"))
    assert generate(folder).exit_code == 0
    return folder / "EXAM"


def mark(exam: Path, folder: Path, lines: list[list[str]], kind: str) -> tuple[str, dict[str, str]]:
    """What is said of a file of these lines, and what was read of each student's first answer."""
    file = folder / f"typed.{kind}"
    if kind == "xlsx":
        book = Workbook()
        for line in lines:
            book.active.append(line)
        book.save(file)
    else:
        file.write_text("".join(f"{';'.join(line)}\n" for line in lines), encoding="utf-8")
    done = kinegrade("grade", exam, file, "-o", folder / "MARKS")
    assert done.exit_code in (0, 1), done.stderr
    rows = table(folder / "MARKS" / "marks.csv")
    return done.stderr, {row["student"]: row["response"] for row in rows if row["response"]}


@pytest.mark.parametrize("kind", ["csv", "xlsx"])
def test_titles_above_the_names_of_the_columns_are_passed_over(
    exam: Path, tmp_path: Path, kind: str
) -> None:
    first = open_exam(exam).head.columns[0]
    lines = [[TITLE], [], ["student", first], ["0012", "1.5"]]
    said, read = mark(exam, tmp_path, lines, kind)
    assert read == {"0012": "1.5"}
    assert "above the line" not in said


@pytest.mark.parametrize("kind", ["csv", "xlsx"])
def test_a_row_above_the_names_of_the_columns_is_told_and_kept(
    exam: Path, tmp_path: Path, kind: str
) -> None:
    first = open_exam(exam).head.columns[0]
    lines = [["007", "2.5"], [TITLE], ["student", first], ["0012", "1.5"]]
    said, read = mark(exam, tmp_path, lines, kind)
    assert read == {"0012": "1.5"}
    assert f"typed.{kind}:1: stands above the line of column names - not graded" in said
    kept = table(tmp_path / "MARKS" / "complaints.csv")
    assert [row["content"] for row in kept if "above" in row["problem"]] == ["007,2.5"]


def test_a_file_without_names_of_columns_is_refused(exam: Path, tmp_path: Path) -> None:
    file = tmp_path / "typed.csv"
    file.write_text("007;2.5\n0012;1.5\n", encoding="utf-8")
    done = kinegrade("grade", exam, file, "-o", tmp_path / "MARKS")
    assert done.exit_code == 2
    assert "its columns (007, 2.5 ...) are those of no system known here" in done.stderr


def test_sheets_are_named_where_none_holds_answers(exam: Path, tmp_path: Path) -> None:
    book = Workbook()
    book.active.title = "Notes"
    book.active.append(["see the second sheet"])
    book.create_sheet("More").append(["nothing"])
    book.save(tmp_path / "typed.xlsx")
    done = kinegrade("grade", exam, tmp_path / "typed.xlsx", "-o", tmp_path / "MARKS")
    assert done.exit_code == 2
    assert "(see the second sheet ...) are those of no system" in done.stderr
    assert 'the first, "Notes", is read, not "More"; delete it' in done.stderr
