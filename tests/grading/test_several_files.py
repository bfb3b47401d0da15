"""Several files of answers are one class: versions' quizzes, parts that assistants typed; nobody's
answer gets lost.
"""

from __future__ import annotations

import csv
from pathlib import Path

import pytest

from kinegrade.grading.sheets.entries import ListedEntries
from kinegrade.grading.sheets.entry import Entry, Place
from tests.small_class import kinegrade, table

FIRST = 'student,q1.v_B,q1.omega_AB\n007,"1,73",0\n0012,1.7,0\nS9,1.73,0\n12,1.73,0\n'
SECOND = "student,q2.a_B\n12,-0.125\n007,-0.125\n0012,7\nS9,-\n"
STATE = ("Finished", "1 May", "1 May", "2 mins", "5.00")
NOBODY = ("-", "-", "-", "-", "-")
MOODLE = ("Last name", "First name", "ID number", "Status", "Started", "Completed", "Duration")


def graded(exam: Path, *contents: str, status: int = 1) -> tuple[Path, list[list[str]]]:
    """The folder of marks of these files, and the rows of complaints.csv."""
    folder = exam.parent
    files = []
    for number, content in enumerate(contents, 1):
        files.append(folder / f"part{number}.csv")
        files[-1].write_text(content, encoding="utf-8")
    done = kinegrade("grade", exam, *files, "-o", folder / "MARKS", "--decimal", "comma")
    assert done.exit_code == status, done.stderr
    with (folder / "MARKS" / "complaints.csv").open(encoding="utf-8-sig", newline="") as file:
        return folder / "MARKS", list(csv.reader(file))[1:]


def totals(marks: Path) -> dict[str, str]:
    return {row["student"]: row["total"] for row in table(marks / "grades.csv")}


def test_questions_that_two_assistants_typed_are_put_together(exam_folder: Path) -> None:
    marks, complaints = graded(exam_folder, FIRST, SECOND, status=0)
    assert totals(marks) == {"007": "9.5", "0012": "3", "S9": "7", "12": "9.5"}
    assert complaints == []


def test_two_different_answers_for_one_cell_are_a_complaint_that_names_both(
    exam_folder: Path,
) -> None:
    again = "student,q1.v_B,q2.a_B\n007,1.99,-0.125\n0012,1.7,\n"
    marks, complaints = graded(exam_folder, FIRST, SECOND, again)
    assert totals(marks)["007"] == "9.5"
    assert complaints == [
        [
            "part3.csv",
            "2",
            "q1.v_B",
            "1.99",
            'student "007" has "1.99" here and "1,73" in part1.csv:2',
            "that of part1.csv counts; correct one of the files and grade again",
        ]
    ]


@pytest.mark.parametrize("order", [(0, 1), (1, 0)])
def test_who_was_typed_twice_in_one_part_keeps_the_answers_of_the_other_part(
    exam_folder: Path, order: tuple[int, int]
) -> None:
    parts = FIRST, "student,q2.a_B\n007,7\n0012,7\nS9,-\n12,-0.125\n007,-0.125\n"
    marks, complaints = graded(exam_folder, *(parts[number] for number in order))
    assert totals(marks) == {"007": "9.5", "0012": "3", "S9": "7", "12": "9.5"}
    file = f"part{order.index(1) + 1}.csv"
    said = "another row for this student stands on line 6"
    done = "line 6 counts; this row is kept here only"
    assert complaints == [[file, "2", "", "007,7", said, done]]


@pytest.mark.parametrize("order", [(0, 1), (1, 0)])
def test_of_attempts_in_one_file_and_a_row_in_another_the_first_file_counts(
    exam_folder: Path, order: tuple[int, int]
) -> None:
    parts = FIRST, "student,q1.v_B,q2.a_B\n007,1.99,7\n007,1.98,-0.125\n"
    marks, complaints = graded(exam_folder, *(parts[number] for number in order))
    assert totals(marks)["007"] == ("9.5" if order == (0, 1) else "5.5")
    repeated = f"part{order.index(1) + 1}.csv"
    said = [row for row in complaints if "007" in "".join(row)]
    assert [row[4] for row in said if row[:2] == [repeated, "2"] and not row[2]] == [
        "another row for this student stands on line 3"
    ]
    counted = [row[4:] for row in said if row[2] == "q1.v_B" and row[0] == "part2.csv"]
    there = "1,73" if order == (0, 1) else "1.98"
    place = "part1.csv:2" if order == (0, 1) else "part1.csv:3"
    for here, done in counted:
        assert here.endswith(f'here and "{there}" in {place}')
        assert done == "that of part1.csv counts; correct one of the files and grade again"
    assert len(counted) == (2 if order == (0, 1) else 1)


def test_attempts_in_two_files_are_left_to_the_policy(exam_folder: Path) -> None:
    twice = "student,q1.v_B\n007,1.99\n007,1.98\n"
    first = FIRST.replace("0012,", '007,"1,73",0\n0012,')
    marks, complaints = graded(exam_folder, first, twice)
    assert totals(marks)["007"] == "0"
    assert [row[:2] for row in complaints if "another row" in row[4]] == [
        ["part1.csv", "2"],
        ["part1.csv", "3"],
        ["part2.csv", "2"],
    ]


def test_a_row_that_was_never_filled_in_is_no_attempt_beside_another_file(
    exam_folder: Path,
) -> None:
    marks, complaints = graded(exam_folder, FIRST + "007,,\n", SECOND, status=0)
    assert (totals(marks)["007"], complaints) == ("9.5", [])


def test_a_file_that_is_given_twice_is_refused_because_another_was_meant(exam_folder: Path) -> None:
    file = exam_folder.parent / "anna.csv"
    file.write_text(FIRST, encoding="utf-8")
    again = exam_folder / ".." / "anna.csv"
    done = kinegrade("grade", exam_folder, file, again, "-o", exam_folder.parent / "MARKS")
    assert done.exit_code == 2
    assert f"{again}: is given twice - expected each file of the class once" in done.stderr


def test_complaints_are_listed_file_by_file(exam_folder: Path) -> None:
    _, complaints = graded(
        exam_folder,
        FIRST.replace("0012,1.7", "0012,?").replace("007,", "8,"),
        SECOND.replace("12,-0.125", "12,?", 1),
    )
    places = [(row[0], row[1]) for row in complaints]
    assert places == [("part1.csv", "2"), ("part1.csv", "3"), ("part2.csv", "2")]


def test_a_complaint_about_a_cell_names_the_file_in_which_it_stands(exam_folder: Path) -> None:
    _, complaints = graded(exam_folder, FIRST, SECOND.replace("0012,7", "0012,1+1"))
    assert [row[:4] for row in complaints] == [["part2.csv", "4", "q2.a_B", "1+1"]]


def test_files_of_one_name_are_told_apart_by_their_folders(
    exam_folder: Path, tmp_path: Path
) -> None:
    files = []
    for name, content in (("anna", FIRST), ("ben", FIRST.replace("0012,1.7", "0012,1.99"))):
        (tmp_path / name).mkdir()
        files.append(tmp_path / name / "answers.csv")
        files[-1].write_text(content, encoding="utf-8")
    done = kinegrade("grade", exam_folder, *files, "-o", tmp_path / "MARKS")
    assert f'"1.99" here and "1.7" in {files[0]}:3' in done.stderr


def quiz(*people: tuple[str, tuple[str, ...], tuple[str, str]]) -> str:
    """Moodle's responses: student, state, what was typed."""
    lines = [",".join([*MOODLE, "Grade/10.00", "Response 1", "Response 2"])]
    for student, state, typed in people:
        lines.append(",".join(["x", "y", student, *state, *typed]))
    return "\n".join(lines) + "\n"


RIGHT = ("part 1: 1.73; part 2: 0", "-0.125")


def test_who_sat_one_version_is_not_absent_from_the_other(exam_folder: Path) -> None:
    first = quiz(("007", STATE, RIGHT), ("0012", NOBODY, ("-", "-")), ("S9", NOBODY, ("-", "-")))
    second = quiz(("0012", STATE, RIGHT), ("007", NOBODY, ("-", "-")), ("S9", NOBODY, ("-", "-")))
    marks, complaints = graded(exam_folder, first, second)
    grades = table(marks / "grades.csv")
    assert [(row["student"], row["total"], row["status"]) for row in grades] == [
        ("007", "9.5", "marked"),
        ("0012", "9.5", "marked"),
        ("S9", "0", "absent"),
        ("12", "0", "absent"),
    ]
    assert [row[4] for row in complaints] == [
        'no row for student "12"',
        "no attempt, or one without answers",
    ]


def test_one_absentee_is_one_complaint(exam_folder: Path) -> None:
    rows = quiz(
        ("007", STATE, RIGHT),
        ("0012", STATE, RIGHT),
        ("S9", NOBODY, ("-", "-")),
        ("12", STATE, RIGHT),
    )
    marks, complaints = graded(exam_folder, rows)
    assert [(row[1], row[4]) for row in complaints] == [("4", "no attempt, or one without answers")]
    assert table(marks / "grades.csv")[2]["status"] == "absent"


def test_an_attempt_in_progress_is_said_with_what_to_do(exam_folder: Path) -> None:
    going_on = ("In progress", "1 May", "-", "-", "-")
    rows = quiz(
        ("007", STATE, RIGHT),
        ("0012", STATE, RIGHT),
        ("S9", going_on, ("-", "-")),
        ("12", STATE, RIGHT),
    )
    _, [complaint] = graded(exam_folder, rows)
    assert complaint[5].startswith("not graded: close the attempt in Moodle first")


def test_a_zero_is_an_answer_and_no_absence(exam_folder: Path) -> None:
    marks, _ = graded(exam_folder, "student,q1.v_B\n007,0\n0012,-\nS9,0\n12,\n")
    status = {row["student"]: row["status"] for row in table(marks / "grades.csv")}
    assert status == {"007": "marked", "0012": "absent", "S9": "marked", "12": "absent"}


@pytest.mark.parametrize("order", [(0, 1), (1, 0)])
def test_every_row_is_in_what_goes_out(exam_folder: Path, order: tuple[int, int]) -> None:
    parts = FIRST + "9999,1,2\n", SECOND + "8888,3\n"
    _, complaints = graded(exam_folder, *(parts[number] for number in order))
    assert sorted(row[3] for row in complaints) == ["8888,3", "9999,1,2"]


def test_who_answered_nothing_is_named_where_marks_are_told(exam_folder: Path) -> None:
    blank = exam_folder.parent / "blank.csv"
    blank.write_text("student,q1.v_B\n007,\n0012,\nS9,\n12,\n", encoding="utf-8")
    done = kinegrade("grade", exam_folder, blank, "-o", exam_folder.parent / "MARKS")
    said = "without any answer, counted as absent: 4 of 4 (007, 0012, S9, 12)"
    assert said in done.stderr.splitlines()


def test_who_all_answered_leave_nobody_to_name(exam_folder: Path) -> None:
    answers = exam_folder.parent / "all.csv"
    answers.write_text("student,q1.v_B\n007,1\n0012,1\nS9,0\n12,1\n", encoding="utf-8")
    done = kinegrade("grade", exam_folder, answers, "-o", exam_folder.parent / "MARKS")
    assert "absent" not in done.stderr


def test_what_is_told_of_a_whole_row_names_the_file_with_most_of_its_answers() -> None:
    first, second = Place("first.csv", 4), Place("second.csv", 9)
    blank, mine = Entry(4, ("", "", ""), file="first.csv"), Entry(5, ("1",), file="first.csv")
    united = blank._replace(responses=("1", "", "2"), places=(second, first, second))
    most = blank._replace(responses=("1", "3", "2"), places=(first, second, second))
    tie = blank._replace(responses=("1", "3", ""), places=(second, first, second))
    several = ListedEntries([blank, mine, united, most, tie])
    files = ["first.csv", "first.csv", "second.csv", "second.csv", "first.csv"]
    assert several.files == files
    assert several.lines.tolist() == [4, 5, 9, 9, 4]
