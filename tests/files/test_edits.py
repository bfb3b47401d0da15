"""What people edited in a folder of marks or feedback stays beside it when it is written anew."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from kinegrade.files.placing.edits import find_edits
from tests.small_class import generate, kinegrade, write_short_class


@pytest.fixture
def marked(tmp_path: Path) -> Path:
    """A folder with an exam and its marks; nobody answered."""
    write_short_class(tmp_path)
    assert generate(tmp_path).exit_code == 0
    mark(tmp_path)
    return tmp_path


def mark(folder: Path, *options: str) -> str:
    """What `grade` says on standard output and error."""
    exam = folder / "EXAM"
    done = kinegrade("grade", exam, exam / "answers.csv", "-o", folder / "MARKS", *options)
    return f"{done.stdout}{done.stderr}"


def test_a_total_typed_into_the_marks_is_kept_and_told(marked: Path) -> None:
    grades = marked / "MARKS" / "grades.csv"
    typed = grades.read_text(encoding="utf-8-sig").replace("absent", "marked")
    grades.write_text(typed, encoding="utf-8")
    kept = marked / "MARKS.previous-1"
    said = mark(marked, "--force")
    assert (
        f"grades.csv of {marked / 'MARKS'} was edited since it was written: kept in {kept}" in said
    )
    assert (kept / "grades.csv").read_text(encoding="utf-8") == typed
    assert [each.name for each in kept.iterdir()] == ["grades.csv"]
    assert "was written" not in mark(marked, "--force")


def test_edited_feedback_is_kept_and_told(marked: Path) -> None:
    target = marked / "FEEDBACK"
    write = "feedback", marked / "EXAM", marked / "MARKS", "-o", target, "--format", "md"
    assert kinegrade(*write).exit_code == 0
    assert "was written" not in kinegrade(*write, "--force").output
    first, second, *_ = sorted((target / "sheets").glob("*.md"))
    for sheet in (first, second):
        sheet.write_text("Well done", encoding="utf-8")
    done = kinegrade(*write, "--force")
    names = f"sheets/{first.name}, sheets/{second.name}"
    kept = marked / "FEEDBACK.previous-1"
    assert f"{names} of {target} were edited since it was written: kept in {kept}" in done.output
    assert (kept / "sheets" / first.name).read_text(encoding="utf-8") == "Well done"
    assert first.read_text(encoding="utf-8") != "Well done"


def test_points_typed_where_grade_reads_them_are_not_kept_twice(marked: Path) -> None:
    written = marked / "MARKS" / "manual.csv"
    written.write_text("student,question,points,out_of,machine,comment\n", encoding="utf-8")
    assert find_edits(marked / "MARKS", marker="grades.csv", guarded=("manual.csv",)).names == ()
    assert find_edits(marked / "MARKS", marker="grades.csv").names == ("manual.csv",)


def test_a_folder_without_one_time_for_all_tells_nothing(marked: Path) -> None:
    for number, file in enumerate((marked / "MARKS").iterdir()):
        os.utime(file, ns=(10**9 + number, 10**9 + number + 1))
    assert find_edits(marked / "MARKS", marker="grades.csv").names == ()


def test_a_folder_of_others_is_not_searched(tmp_path: Path) -> None:
    for second in (1, 2):
        (tmp_path / f"{second}.txt").touch()
        os.utime(tmp_path / f"{second}.txt", (second, second))
    assert find_edits(tmp_path, marker="1.txt").names == ("2.txt",)
    assert find_edits(tmp_path, marker="grades.csv").names == ()
