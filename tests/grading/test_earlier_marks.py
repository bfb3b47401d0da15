"""A folder of marks that an earlier version wrote is read as it stands: exported, reported, handed
back, compared, and held to when the class is marked again.
"""

from __future__ import annotations

import io
from pathlib import Path

import pytest
from openpyxl import load_workbook

from tests.grading.marked_folder import Page
from tests.small_class import kinegrade, table

DATA = Path(__file__).parent.parent / "data"
EXAM, MARKS, ANSWERS = DATA / "exam-of-0.1", DATA / "marks-of-0.1", DATA / "answers-of-0.1.csv"
KEPT = "The total is that of an earlier marking"


@pytest.fixture
def output(tmp_path: Path) -> Path:
    return tmp_path / "OUT"


def run(*arguments: str | Path, status: int = 0) -> str:
    """What a command says; it has to end with that status."""
    result = kinegrade(*arguments)
    assert result.exit_code == status, result.stderr
    return result.stdout


def test_its_grades_are_exported_with_the_total_that_was_kept(output: Path) -> None:
    run("export", MARKS, "--to", "moodle", "--exam", EXAM, "-o", output)
    before = (MARKS / "moodle.csv").read_text(encoding="utf-8-sig")
    told = before.replace("1: 3/5.5; 2: 3/7", "1: 3/5.5; 2: 3/7; an earlier total stands")
    assert output.read_text(encoding="utf-8-sig") == told != before
    assert [row["Grade"] for row in table(output)] == ["12.5", "9.5"]


def test_it_is_exported_as_a_spreadsheet(output: Path) -> None:
    run("export", MARKS, "--to", "xlsx", "-o", output)
    book = load_workbook(io.BytesIO(output.read_bytes()))
    assert book.sheetnames == ["grades", "marks", "complaints"]
    assert [cell.value for cell in book["grades"]["E"]] == ["total", 12.5, 9.5]
    assert book["marks"]["D3"].value == "=1+1"
    assert book["complaints"]["B3"].value == 4


def test_its_students_get_feedback(output: Path) -> None:
    run("feedback", EXAM, MARKS, "-o", output, "--format", "md")
    sheets = {
        row["student"]: (output / row["file"]).read_text(encoding="utf-8")
        for row in table(output / "feedback.csv")
    }
    assert ("**Total: 12.5 / 12.5**" in sheets["007"], KEPT in sheets["007"]) == (True, True)
    assert ("**Total: 9.5 / 12.5**" in sheets["0012"], KEPT in sheets["0012"]) == (True, False)
    assert "1,77 (read as 1.77\u202fm/s)" in sheets["007"]
    assert r"| \=1+1 | ≈ −18.4569" in sheets["007"]
    assert "the sense is reversed" in sheets["0012"]


def test_its_class_is_reported_on(output: Path) -> None:
    run("report", EXAM, MARKS, "-o", output)
    text = Page(output.read_text(encoding="utf-8")).text
    assert 'no student "999" in the exam' in text
    assert "88.0 %" in text  # the mean of 100 and 76


def test_it_is_compared_and_searched(output: Path) -> None:
    assert run("diff", MARKS, MARKS).startswith("0 up, 0 down, 2 unchanged")
    run("sharing", EXAM, MARKS, "-o", output)
    assert len(output.read_text(encoding="utf-8").splitlines()) == 1


def test_its_totals_stand_in_a_new_marking(output: Path) -> None:
    run("grade", EXAM, ANSWERS, "--never-lower", MARKS, "-o", output, status=1)
    assert [row["total"] for row in table(output / "grades.csv")] == ["12.5", "9.5"]
    ((before, by_this_marking, stands),) = [
        (row["before"], row["by_this_marking"], row["stands"]) for row in table(output / "kept.csv")
    ]
    assert (before, by_this_marking, stands) == ("12.5", "6", "12.5")
