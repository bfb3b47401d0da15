"""What is subtracted is said wherever marks go: grades, feedback, comparisons, systems, reports."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest

from kinegrade.marks_folder.folder import open_marks
from tests.grading.late_submissions.late_exam import IN_TIME, LATE, grade, totals
from tests.grading.marked_folder import Page
from tests.small_class import contents, kinegrade, table


def test_grades_are_of_what_is_left(exam: Path) -> None:
    policy = f'{LATE}due = "2026-11-27 18:00"\n[scale]\nkind = "german"\n'
    assert grade(exam, policy).exit_code < 2
    rows = table(exam.parent / "LATE" / "grades.csv")
    assert [(row["student"], row["total"], row["grade"]) for row in rows] == [
        ("7", "5.7", "3.3"), ("8", "4.75", "4.0"), ("9", "3.8", "5.0"), ("10", "0", ""),
    ]  # fmt: skip


@pytest.mark.parametrize("form", ["md", "html"])
def test_students_read_what_was_subtracted(exam: Path, form: str) -> None:
    grade(exam, LATE)
    sheets = exam.parent / "F"
    wishes = "-o", sheets, "--format", form
    assert kinegrade("feedback", exam, exam.parent / "LATE", *wishes).exit_code == 0
    late, in_time = (
        Page((sheets / "sheets" / f"{student}.{form}").read_text(encoding="utf-8")).text
        for student in ("9", "7")
    )
    assert "7.6 / 9.5" in late
    assert "Subtracted from the total: 1.9 (handed in 24:11 hours late: 20 %)" in late
    assert "Subtracted" not in in_time


def test_a_comparison_shows_what_is_subtracted(exam: Path) -> None:
    grade(exam, "attempts = 'last'", name="PLAIN")
    grade(exam, LATE)
    output = exam.parent / "diff.csv"
    shown = kinegrade("diff", exam.parent / "PLAIN", exam.parent / "LATE", "-o", output).stdout
    rows = [row for row in table(output) if row["what"] == "subtracted"]
    assert [(row["student"], row["before"], row["after"]) for row in rows] == [
        ("8", "", "0.95"), ("9", "", "1.9"),
    ]  # fmt: skip
    assert "subtracted" in shown


def test_a_system_is_told_what_is_missing_from_the_sum(exam: Path) -> None:
    grade(exam, LATE)
    assert "1: 7/7; 2: 2.5/2.5; -1.9" in (exam.parent / "LATE" / "moodle.csv").read_text("utf-8")
    wishes = "--to", "generic", "-o", exam.parent / "sheet.csv", "--per-question"
    done = kinegrade("export", exam.parent / "LATE", *wishes)
    assert done.exit_code == 1
    assert "points are subtracted from 2 totals, and questions do not show it" in done.stderr


def test_a_system_is_told_that_an_earlier_total_stands(exam: Path) -> None:
    grade(exam, "attempts = 'last'", name="FIRST")
    grade(exam, LATE, IN_TIME, "STANDS", "--never-lower", str(exam.parent / "FIRST"))
    moodle = (exam.parent / "STANDS" / "moodle.csv").read_text("utf-8")
    assert "1: 7/7; 2: 2.5/2.5; -1.9; an earlier total stands" in moodle
    wishes = "--to", "generic", "-o", exam.parent / "sheet.csv", "--per-question"
    done = kinegrade("export", exam.parent / "STANDS", *wishes)
    assert done.exit_code == 1
    said = 'earlier totals stand for 2 students ("8", "9"), and questions do not show it - export'
    assert said in done.stderr


def test_the_report_says_from_how_many_points_are_subtracted(exam: Path) -> None:
    grade(exam, LATE)
    page = exam.parent / "report.html"
    assert kinegrade("report", exam, exam.parent / "LATE", "-o", page).exit_code == 0
    assert "Points are subtracted from 2 totals" in page.read_text(encoding="utf-8")


def test_marking_again_gives_the_same_bytes(exam: Path) -> None:
    grade(exam, LATE)
    grade(exam, LATE, name="AGAIN")
    assert contents(exam.parent / "LATE") == contents(exam.parent / "AGAIN")


def test_a_total_that_stands_is_not_lowered_by_lateness(exam: Path) -> None:
    grade(exam, "attempts = 'last'", IN_TIME, "PLAIN")
    grade(exam, LATE, IN_TIME, "LATE", "--never-lower", str(exam.parent / "PLAIN"))
    assert totals(exam)["9"][0] == "9.5"
    wishes = "-o", exam.parent / "F", "--format", "md"
    assert kinegrade("feedback", exam, exam.parent / "LATE", *wishes).exit_code == 0
    sheet = (exam.parent / "F" / "sheets" / "9.md").read_text(encoding="utf-8")
    assert "Subtracted" not in sheet


def test_a_blank_amount_is_nothing_as_where_folders_were_put_together(exam: Path) -> None:
    grade(exam, LATE)
    path = exam.parent / "LATE" / "grades.csv"
    text = path.read_text(encoding="utf-8")
    assert ",100,marked,0\n" in text
    path.write_text(text.replace(",100,marked,0\n", ",100,marked,\n"), encoding="utf-8")
    totals = open_marks(exam.parent / "LATE").totals.by_student
    assert (totals["7"].subtracted, totals["9"].subtracted) == (0, Fraction("1.9"))


def test_a_lateness_that_was_changed_by_hand_is_refused(exam: Path) -> None:
    grade(exam, LATE)
    path = exam.parent / "LATE" / "subtracted.csv"
    path.write_text(path.read_text(encoding="utf-8").replace("24:11", "a day"), encoding="utf-8")
    wishes = "-o", exam.parent / "F", "--format", "md"
    done = kinegrade("feedback", exam, exam.parent / "LATE", *wishes)
    assert done.exit_code == 2
    assert 'late_by is "a day" - expected hours and minutes like 25:00' in done.stderr


def test_an_amount_that_was_changed_by_hand_is_refused(exam: Path) -> None:
    grade(exam, LATE)
    path = exam.parent / "LATE" / "grades.csv"
    text = path.read_text(encoding="utf-8")
    assert text.count(",1.9") == 1
    path.write_text(text.replace(",1.9", ",0.9"), encoding="utf-8")
    done = kinegrade("export", exam.parent / "LATE", "--to", "xlsx", "-o", exam.parent / "x.xlsx")
    assert done.exit_code == 2
    assert "total is 7.6, 8.6 by marks.csv" in done.stderr
