"""Answers and marks from before an exchange of papers."""

from __future__ import annotations

import csv
from pathlib import Path
from shutil import copytree

import pytest
from click.testing import Result

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.folder.ownership import list_moved
from tests.small_class import generate, kinegrade, write_short_class


def read_codes(folder: Path) -> dict[str, str]:
    """The codes of the papers, by student."""
    return {each.student: each.paper for each in open_exam(folder / "EXAM").head.students}


def mark(folder: Path, marks: str, rows: list[tuple[str, ...]], *options: str) -> Result:
    """Grades a sheet whose rows have one answer, after the code, or the id and the code."""
    header = ("student", "paper", "q1.v_y")[-len(rows[0]) :]
    lines = "".join(f"{','.join(row)}\n" for row in (header, *rows))
    (folder / "typed.csv").write_text(lines, encoding="utf-8")
    words = folder / "EXAM", folder / "typed.csv", "-o", folder / marks, "--force", *options
    return kinegrade("grade", *words)


def read_totals(marks: Path) -> dict[str, str]:
    """The totals by student."""
    with (marks / "grades.csv").open(encoding="utf-8-sig", newline="") as lines:
        return {row["student"]: row["total"] for row in csv.DictReader(lines)}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A class of which 007 and 0012 have exchanged papers, and BEFORE, marks by the codes from
    before, in which 007 has the points that are those of 0012.
    """
    folder = write_short_class(tmp_path_factory.mktemp("exchanged"))
    assert generate(folder).exit_code == 0
    codes = read_codes(folder)
    answer = open_exam(folder / "EXAM").keys.line_of("007").questions[0].asks["v_y"]
    assert answer.decimal is not None
    mark(folder, "BEFORE", [(codes["007"], answer.decimal), (codes["0012"], "-99")])
    assert kinegrade("exchange", folder / "EXAM", codes["0012"], "007").exit_code == 0
    return folder


def test_a_row_with_the_code_before_is_not_told_to_undo_the_exchange(folder: Path) -> None:
    now = read_codes(folder)
    said = mark(folder, "MARKS", [("007", now["0012"], "1"), ("0012", now["007"], "1")]).stderr
    for student, other in (("007", "0012"), ("0012", "007")):
        assert (
            f"typed.csv:{2 if student == '007' else 3}: paper: the paper with this code is that of "
            f'"{other}" - marked as the paper of "{student}", by the id; papers were exchanged '
            "since: where the answers were typed by the code, swap the ids and names of the two "
            "rows, else their codes\n"
        ) in said
    assert "kinegrade exchange" not in said


def test_earlier_marks_of_the_paper_before_keep_no_total_up(folder: Path) -> None:
    now = read_codes(folder)
    assert read_totals(folder / "BEFORE")["007"] == "2"
    rows = [(now["007"], "-99"), (now["0012"], "-99")]
    said = mark(folder, "MARKS", rows, "--never-lower", str(folder / "BEFORE")).stderr
    assert (
        'complaint: grades.csv: student: the earlier marks of "007", "0012" are by papers that are '
        "those of others since an exchange - nothing kept\n"
    ) in said
    assert read_totals(folder / "MARKS")["007"] == "0"


def test_an_exchange_that_was_undone_leaves_earlier_marks_as_they_are(
    folder: Path, tmp_path: Path
) -> None:
    folder = Path(copytree(folder, tmp_path / "copy"))
    head = open_exam(folder / "EXAM").head
    assert [*list_moved(head, 0)] == ["007", "0012"]
    assert [*list_moved(head, 1)] == []
    assert kinegrade("exchange", folder / "EXAM", read_codes(folder)["0012"], "007").exit_code == 0
    back = open_exam(folder / "EXAM").head
    assert [*list_moved(back, 0)] == []
    assert [*list_moved(back, 1)] == ["007", "0012"]
