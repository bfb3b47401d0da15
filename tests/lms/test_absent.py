"""Absent is not zero: whoever grades.csv calls absent gets no grade in any system, and no zero in
the spreadsheet.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import pytest
from openpyxl import load_workbook

from kinegrade.files.csv_writing import write_csv
from kinegrade.lms.grades.systems import SYSTEMS
from kinegrade.marks_folder.layout import KEPT
from tests.lms.marked_folder import STUDENTS, write_exam, write_marks
from tests.small_class import kinegrade

ABSENT = "0012347"
FRESH = [name for name in SYSTEMS if name not in ("blackboard", "edx")]


def with_status(marks: Path, statuses: Mapping[str, str]) -> Path:
    """Adds the column status to grades.csv; marked where nothing else is said."""
    head, *rows = (marks / "grades.csv").read_text(encoding="utf-8").splitlines()
    told = [f"{row},{statuses.get(row.partition(',')[0], 'marked')}" for row in rows]
    (marks / "grades.csv").write_text("\n".join([f"{head},status", *told, ""]), encoding="utf-8")
    return marks


def exported(folder: Path, system: str, *options: str) -> str:
    exam, out = write_exam(folder / "EXAM"), folder / "out.csv"
    arguments = "--to", system, "--exam", exam, "-o", out, "--force"
    result = kinegrade("export", folder / "MARKS", *arguments, *options)
    assert result.exit_code == 0, result.stderr
    return out.read_text(encoding="utf-8")


@pytest.mark.parametrize("system", FRESH)
def test_who_is_absent_gets_no_grade_and_who_is_marked_gets_even_a_zero(
    tmp_path: Path, system: str
) -> None:
    marks = with_status(write_marks(tmp_path / "MARKS"), {ABSENT: "absent"})
    assert ABSENT not in exported(tmp_path, system)
    assert ABSENT in exported(tmp_path, system, "--ungraded")
    text = (marks / "grades.csv").read_text(encoding="utf-8")
    (marks / "grades.csv").write_text(text.replace("absent", "marked"), encoding="utf-8")
    assert ABSENT in exported(tmp_path, system)


def test_the_status_is_no_question(tmp_path: Path) -> None:
    with_status(write_marks(tmp_path / "MARKS"), {ABSENT: "absent"})
    header = exported(tmp_path, "moodle", "--per-question").splitlines()[0]
    assert header == "ID number,Full name,Grade q1,Grade q2"


def test_a_folder_of_an_earlier_version_tells_absence_by_blank_answers(tmp_path: Path) -> None:
    write_marks(tmp_path / "MARKS")
    text = exported(tmp_path, "moodle")
    assert ABSENT not in text
    assert [student for student in STUDENTS if student != ABSENT and student not in text] == []


def test_an_earlier_total_that_is_kept_is_exported_though_its_student_was_absent_now(
    tmp_path: Path,
) -> None:
    marks = with_status(write_marks(tmp_path / "MARKS"), {ABSENT: "absent"})
    text = (marks / "grades.csv").read_text(encoding="utf-8")
    (marks / "grades.csv").write_text(
        text.replace(",0,0,0,10,0,", ",0,0,5,10,50,"), encoding="utf-8"
    )
    write_csv(marks / "kept.csv", KEPT.columns, [(ABSENT, "x", "5", "10", "0", "10", "5", "x")])
    assert f"{ABSENT},'=HYPERLINK(1),5," in exported(tmp_path, "moodle")
    rows = grades_sheet(tmp_path)
    assert rows[ABSENT] == ["=HYPERLINK(1)", None, None, 5, 10, 50, "absent"]


def grades_sheet(folder: Path) -> dict[object, list[object]]:
    """The rows of the sheet grades, without the id, by student."""
    out = folder / "out.xlsx"
    result = kinegrade("export", folder / "MARKS", "--to", "xlsx", "-o", out)
    assert result.exit_code == 0, result.stderr
    rows = ([cell.value for cell in row] for row in load_workbook(out)["grades"])
    return {row[0]: row[1:] for row in rows}


def test_the_spreadsheet_has_no_zeros_for_the_absent_that_an_average_would_count(
    tmp_path: Path,
) -> None:
    with_status(write_marks(tmp_path / "MARKS"), {ABSENT: "absent"})
    rows = grades_sheet(tmp_path)
    assert rows["student"][-1] == "status"
    assert rows[ABSENT][1:] == [None, None, None, 10, None, "absent"]
    assert rows["0012346"][1:] == [4, 0, 4, 10, 40, "marked"]
