"""What comes back after the exam, and marks by hand: rows 13 and 16 of the term, played with six
students.
"""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.small_class import kinegrade, table
from tests.term.people import people
from tests.term.test_the_exam import Midterm, mark, right, set_exam, totals, write_answers

STUDENTS = 6


@pytest.fixture(scope="module")
def seminar(tmp_path_factory: pytest.TempPathFactory) -> Midterm:
    """The midterm of six; not to be changed."""
    return set_exam(tmp_path_factory.mktemp("seminar"), STUDENTS, 0)


@pytest.fixture
def small(seminar: Midterm, tmp_path: Path) -> Midterm:
    """The same, to be changed."""
    shutil.copytree(seminar.folder, tmp_path, dirs_exist_ok=True)
    return Midterm(tmp_path, seminar.seconds, seminar.said)


def test_row_16_a_theory_question_an_override_and_a_bonus_are_marked_by_hand(
    small: Midterm,
) -> None:
    rows = [[student, *answers] for student, answers in right(small.exam).items()]
    sheet = write_answers(small, rows)
    assert "question 3 is still to be marked by hand" in mark(small, sheet).stderr
    first, second, *_ = [each.student for each in people(STUDENTS)]
    opened = small.folder / "MARKS" / "open.csv"
    text = opened.read_text(encoding="utf-8-sig")
    opened.write_text(text.replace(",q3,5,,", ",q3,5,4,clear"), encoding="utf-8")
    special = small.folder / "special.csv"
    special.write_text(
        f"student,question,points,comment\n{first},1,2,unit missing in the working\n"
        f"{second},bonus,1,an elegant way\n",
        encoding="utf-8",
    )
    done = mark(small, sheet, "--manual", str(opened), "--manual", str(special))
    assert done.exit_code == 0, done.stderr
    assert "still to be marked" not in done.stderr
    points = {student: total for student, (total, _) in totals(small).items()}
    assert (points[first], points[second]) == ("9", "12")
    assert set(points.values()) == {"9", "12", "11"}
    assert mark(small, sheet).exit_code == 0  # again, without a word about hands
    assert {student: total for student, (total, _) in totals(small).items()} == points
    grades = small.folder / "grades.csv"
    assert (
        kinegrade("export", small.folder / "MARKS", "--to", "moodle", "-o", grades).exit_code == 0
    )
    assert {row["Grade"] for row in table(grades)} == {"9", "12", "11"}
