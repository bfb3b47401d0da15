"""A question that a hand marked as a whole counts in the class report as it does in grades.csv."""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.marks_folder.folder import open_marks
from kinegrade.reports.classes.tally import tally
from tests.small_class import generate, kinegrade, table, write_class


def test_shares_of_questions_are_those_of_the_grades(tmp_path: Path) -> None:
    """Groups and versions were compared by the machine's points beside means with those by hand."""
    folder = write_class(tmp_path)
    assert generate(folder, "EXAM", "--no-papers").exit_code == 0
    students = [row["student"] for row in table(folder / "roster.csv")]
    answers = folder / "answers.csv"
    answers.write_text(
        "student,q1.v_B\n" + "".join(f"{each},1\n" for each in students), encoding="utf-8"
    )
    hand = folder / "hand.csv"
    hand.write_text(f"student,question,points\n{students[0]},q1,3\n", encoding="utf-8")
    marks = folder / "MARKS"
    done = kinegrade("grade", folder / "EXAM", answers, "-o", marks, "--manual", hand)
    assert done.exit_code in (0, 1), done.stderr
    counts = tally(open_marks(marks), open_exam(folder / "EXAM"))
    got = {row["student"]: float(row["q1"]) for row in table(marks / "grades.csv")}
    full = counts.out_of[[column.startswith("q1.") for column in counts.columns]].sum()
    expected = [got[each.student] / full for each in counts.answered]
    assert counts.share("q1").tolist() == pytest.approx(expected)
    assert max(expected) == pytest.approx(3 / full)
