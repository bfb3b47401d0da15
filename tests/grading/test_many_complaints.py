"""A large class's complaints stay readable: what holds for a whole file is said once, the terminal
shows ten of a kind.
"""

from __future__ import annotations

import csv
from pathlib import Path

import pytest

from tests.grading.small_exam import exam, paper, write_exam
from tests.small_class import kinegrade

COUNT = 40


@pytest.fixture
def large(tmp_path: Path) -> Path:
    """An exam of forty students."""
    head = exam()
    head["students"] = [
        {"student": f"{number:04}", "name": "x", "paper": "K7Q2", "email": ""}
        for number in range(COUNT)
    ]
    return write_exam(
        tmp_path / "EXAM", head, [paper(each["student"]) for each in head["students"]]
    )


def graded(
    exam: Path, cell: str, *options: str, second: str = ""
) -> tuple[list[str], list[list[str]]]:
    """What the terminal shows and the rows of complaints.csv, where everybody's first answers are
    those cells.
    """
    folder = exam.parent
    lines = ["student;q1.v_B;q1.omega_AB;q2.a_B"]
    lines += [f"{number:04};{cell};{second};" for number in range(COUNT)]
    (folder / "answers.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    done = kinegrade("grade", exam, folder / "answers.csv", "-o", folder / "MARKS", *options)
    with (folder / "MARKS" / "complaints.csv").open(encoding="utf-8-sig", newline="") as file:
        rows = list(csv.reader(file))[1:]
    assert done.exit_code == bool(rows)
    return [line for line in done.stderr.splitlines() if line.startswith("complaint")], rows


def test_a_comma_against_a_declared_point_is_said_once(large: Path) -> None:
    shown, rows = graded(large, "1,732", "--decimal", "point")
    said = "40 answers, such as 1,732 read as 1732: the decimal mark was declared to be the point"
    missed = "0 of the 40 numbers are right, and 40 would be multiplied by 0.001"
    assert {row[4] for row in rows} == {said, missed}
    assert len(shown) == len(rows) == 2
    assert f"complaint: answers.csv: {said} - judged as they were read" in shown


@pytest.mark.parametrize("declared", [("--decimal", "comma"), ()])
def test_decimal_commas_that_are_certain_are_no_complaint(
    large: Path, declared: tuple[str, ...]
) -> None:
    assert graded(large, "1,732", *declared, second="0,0") == ([], [])


def test_what_was_decided_for_the_whole_file_is_said_once(large: Path) -> None:
    _, rows = graded(large, "1,732")
    assert [row[4] for row in rows] == [
        "40 answers, such as 1,732 read as 1.732: a comma is the decimal mark, and nothing in the "
        "file says otherwise"
    ]


def test_a_lone_comma_of_somebody_who_writes_points_is_reported_for_itself(large: Path) -> None:
    with_points = "\n".join(f'{number:04},"1,732",0.5,' for number in range(2))
    answers = large.parent / "mixed.csv"
    answers.write_text(
        f'student,q1.v_B,q1.omega_AB,q2.a_B\n{with_points}\n0002,"0,5",,\n', encoding="utf-8"
    )
    kinegrade("grade", large, answers, "-o", large.parent / "M")
    said = (large.parent / "M" / "complaints.csv").read_text(encoding="utf-8-sig")
    for line in (2, 3):
        assert (
            f'mixed.csv,{line},q1.v_B,"1,732","read as 1.732: a comma is the decimal mark, as the '
            "papers say; but this student's other answers have a decimal point\",judged right"
            in said
        )


def test_the_terminal_shows_ten_of_a_kind_and_the_file_has_them_all(large: Path) -> None:
    shown, rows = graded(large, "1+1")
    assert len(rows) == COUNT
    assert len(shown) == 11
    assert shown[-1].startswith("complaint: ... and 30 more like answers.csv:2: q1.v_B: ")
    assert shown[-1].endswith(f"all are in {large.parent / 'MARKS' / 'complaints.csv'}")
