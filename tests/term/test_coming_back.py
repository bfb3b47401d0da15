"""What comes back after the exam, and marks by hand: rows 13 and 16 of the term, played with six
students.
"""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.files.csv_writing import write_csv
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


def test_row_13_answers_come_back_in_files_of_any_kind_and_are_put_together(
    small: Midterm,
) -> None:
    given, head = right(small.exam), open_exam(small.exam).head
    first, second, *others = given
    wide = small.folder / "wide.csv"
    rows = [[student, *given[student]] for student in reversed(others)]
    write_csv(wide, ["student", *head.columns], rows)
    long = small.folder / "long.csv"
    lines = [
        [head.candidates[student].paper.lower(), name, answer]
        for student in (first, second)
        for name, answer in zip(("1a", "q2.v_y"), given[student], strict=True)
    ]
    write_csv(long, ["paper", "ask", "answer"], sorted(lines, key=lambda line: line[1]))
    marks = small.folder / "MARKS"
    done = kinegrade("grade", small.exam, wide, long, "-o", marks)
    assert done.exit_code == 0, done.stderr
    assert {points for points, _ in totals(small).values()} == {"7"}
    write_csv(wide, ["student", *head.columns], [*rows, [first, "9.9", given[first][1]]])
    again = kinegrade("grade", small.exam, wide, long, "-o", marks, "--force")
    assert again.exit_code == 1
    assert f'has "{given[first][0]}" here and "9.9" in wide.csv:6' in again.stderr


def test_row_13_what_two_assistants_typed_is_compared(small: Midterm) -> None:
    given, columns = right(small.exam), open_exam(small.exam).head.columns
    anna, ben = small.folder / "anna.csv", small.folder / "ben.csv"
    rows = [[student, *answers] for student, answers in given.items()]
    write_csv(anna, ["student", *columns], rows)
    commas = [
        [student, *(each.replace(".", ",") for each in answers)] for student, *answers in rows
    ]
    write_csv(ben, ["student", *columns[::-1]], [[each[0], *each[:0:-1]] for each in commas[::-1]])
    merged = small.folder / "merged.csv"
    same = kinegrade("compare-entries", anna, ben, small.exam, "-o", merged)
    assert same.exit_code == 0, same.stdout + same.stderr
    assert [list(row.values()) for row in table(merged)] == rows
    commas[2][1] = "7"
    write_csv(ben, ["student", *columns], commas[:-1])
    other = kinegrade("compare-entries", anna, ben, small.exam, "-o", merged, "--force")
    assert other.exit_code == 1
    listed = [line.split() for line in other.stdout.splitlines()[1:-1]]
    assert listed == [
        [rows[2][0], columns[0], rows[2][1], "4", "7", "4"],
        [rows[-1][0], "*", str(STUDENTS + 1), "–"],
    ]
    assert "merged.csv: not written" in other.stderr


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
