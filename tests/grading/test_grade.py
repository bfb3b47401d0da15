"""A small class through `grade`, on real files, with every rule for what comes back."""

from __future__ import annotations

import csv
import hashlib
import os
from fractions import Fraction
from pathlib import Path

import pytest

from kinegrade.errors import ExamError, OutputError, TableError
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.grading.grade import MarkingWishes, grade
from kinegrade.grading.marks import ClassGrades
from kinegrade.lms.grades import moodle
from kinegrade.marks_folder.rows import Grade
from kinegrade.numbers.amounts import write_amount
from tests.grading.small_exam import STUDENTS, exam, paper, write_exam
from tests.said import said

HEADER = "student,name,q1.v_B,q1.omega_AB,q2.a_B\n"
ROWS = """007,王伟,"1,73",0.002,-0.125
0012,"O'Neil, Zoë",1.732 m/s,0.0021,-
S9,x,1.7 rad/s,=1+1,"-0,1375 m/s²"
12,Ann,,,
"""
RIGHT = '"1,73"'
WRONG_UNIT = '"rad/s" measures an angular velocity; a speed was expected, in "m/s"'
CALCULATION = '"=1+1" is a range or a calculation; one number was expected'


def marked(exam: Path, content: str | bytes, *, force: bool = False) -> ClassGrades:
    answers = exam.parent / "answers.csv"
    answers.write_bytes(content.encode() if isinstance(content, str) else content)
    return grade(
        open_exam(exam),
        answers,
        exam.parent / "MARKS",
        MarkingWishes(exports={"moodle.csv": moodle.export}),
        force=force,
    )


def rows(exam: Path, name: str, folder: str = "MARKS") -> list[list[str]]:
    with (exam.parent / folder / name).open(encoding="utf-8-sig", newline="") as file:
        return list(csv.reader(file))


def complaints(exam: Path) -> list[tuple[str, ...]]:
    """Line, column, content, problem of each."""
    return [tuple(row[1:5]) for row in rows(exam, "complaints.csv")[1:]]


def verdicts(exam: Path, student: str, folder: str = "MARKS") -> list[str]:
    return [row[6] for row in rows(exam, "marks.csv", folder) if row[0] == student]


def test_a_class_is_marked(exam_folder: Path) -> None:
    marks = marked(exam_folder, HEADER + ROWS)
    assert sorted(os.listdir(exam_folder.parent / "MARKS")) == [
        "complaints.csv", "grades.csv", "marks.csv", "moodle.csv", "policy.toml",
    ]  # fmt: skip
    assert rows(exam_folder, "grades.csv") == [
        ["student", "name", "q1", "q2", "total", "out_of", "percent", "status"],
        ["007", "王伟", "7", "2.5", "9.5", "9.5", "100", "marked"],
        ["0012", "O'Neil, Zoë", "4", "0", "4", "9.5", "42.11", "marked"],
        ["S9", "'=HYPERLINK(1)", "0", "2.5", "2.5", "9.5", "26.32", "marked"],
        ["12", "Ann", "0", "0", "0", "9.5", "0", "absent"],
    ]
    assert marks.grades[1] == Grade(
        "0012", "O'Neil, Zoë", (Fraction(4), Fraction(0)), Fraction(19, 2)
    )


def test_marks_have_a_row_for_each_student_and_ask(exam_folder: Path) -> None:
    marked(exam_folder, HEADER + ROWS)
    header, *found = rows(exam_folder, "marks.csv")
    assert (
        ",".join(header)
        == "student,question,ask,response,read_as,unit,verdict,points,out_of,reason,mistakes,rule"
    )
    assert len(found) == 12
    within = "key 1.73205, difference 0.00205081, allowed 0.0173205"
    assert found[0] == [
        "007",
        "q1",
        "v_B",
        "1,73",
        "1.73",
        "m/s",
        "right",
        "4",
        "4",
        within,
        "",
        "",
    ]
    assert found[4][3:9] == ["0.0021", "0.0021", "rad/s", "wrong", "0", "3"]
    assert found[5][3:] == ["-", "", "m/s^2", "blank", "0", "2.5", "", "", ""]
    assert found[6][3:9] == ["1.7 rad/s", "", "m/s", "wrong unit", "0", "4"]
    assert found[6][9] == WRONG_UNIT
    assert found[7][3:] == ["'=1+1", "", "rad/s", "unreadable", "0", "3", CALCULATION, "", ""]
    assert found[8][3:8] == ["'-0,1375 m/s²", "-0.1375", "m/s^2", "right", "2.5"]


def test_unreadable_answers_are_complaints_and_blank_ones_are_not(exam_folder: Path) -> None:
    marked(exam_folder, HEADER + ROWS)
    assert complaints(exam_folder) == [
        ("4", "q1.v_B", "1.7 rad/s", WRONG_UNIT),
        ("4", "q1.omega_AB", "'=1+1", CALCULATION),
    ]
    assert rows(exam_folder, "complaints.csv")[0] == [
        "file",
        "line",
        "column",
        "content",
        "problem",
        "done",
    ]


def test_moodle_gets_exact_ids_and_short_feedback(exam_folder: Path) -> None:
    marked(exam_folder, HEADER + ROWS)
    assert (exam_folder.parent / "MARKS" / "moodle.csv").read_text(encoding="utf-8").splitlines()[
        :3
    ] == [
        "ID number,Full name,Grade,Feedback",
        "007,王伟,9.5,1: 7/7; 2: 2.5/2.5",
        '0012,"O\'Neil, Zoë",4,1: 4/7; 2: 0/2.5',
    ]


def test_columns_may_stand_in_any_order_and_spelling(exam_folder: Path) -> None:
    sheet = "Q2．a_b; 学号 ;email;q1.OMEGA_ab;Q1.V_B\n-0,125;００７;x;0;1,73\n"
    marked(exam_folder, sheet)
    assert verdicts(exam_folder, "007") == ["right", "right", "right"]


def test_a_student_who_is_not_in_the_exam_is_kept_whole(exam_folder: Path) -> None:
    marked(exam_folder, HEADER + ROWS + "=9,Eve,1,2,3\n,Nobody,1,2,3\n0,Zero,1,2,3\n")
    assert complaints(exam_folder)[2:] == [
        ("6", "student", "'=9,Eve,1,2,3", 'no student "=9" in the exam'),
        ("7", "student", ",Nobody,1,2,3", "no student id"),
        ("8", "student", "0,Zero,1,2,3", 'no student "0" in the exam'),
    ]


def test_ids_without_zeros_or_in_another_case_keep_their_points_where_one_student_is_meant(
    exam_folder: Path,
) -> None:
    marks = marked(exam_folder, HEADER + f"7,王伟,{RIGHT},0,-0.125\ns9,x,1,1,1\n00012,x,1,1,1\n")
    assert verdicts(exam_folder, "007") == ["right"] * 3
    restored, *others = [each for each in marks.complaints if each.column == "student"]
    assert (restored.line, said(restored.problem)) == (
        None,
        '2 student ids are not as in the exam, such as "7" for "007"',
    )
    assert said(restored.done).startswith("taken for these students, as each can mean only one")
    assert [(each.line, said(each.done)) for each in others] == [
        (4, 'not graded; probably "0012" or "12": correct the id and grade again')
    ]


def test_an_id_is_not_restored_for_somebody_who_has_a_row(exam_folder: Path) -> None:
    marks = marked(exam_folder, HEADER + f"007,王伟,{RIGHT},0,-0.125\n7,x,1,1,1\n")
    assert verdicts(exam_folder, "007") == ["right"] * 3
    assert [said(each.done) for each in marks.complaints if each.line == 3] == [
        'not graded; probably "007": correct the id and grade again'
    ]


def test_two_ids_that_would_mean_one_student_are_both_refused(exam_folder: Path) -> None:
    marks = marked(exam_folder, HEADER + "7,x,1,1,1\n07,y,2,2,2\n")
    assert verdicts(exam_folder, "007") == ["blank"] * 3
    assert [each.line for each in marks.complaints if each.line] == [2, 3]


def test_the_header_once_more_is_no_student(exam_folder: Path) -> None:
    marks = marked(exam_folder, HEADER + ROWS + HEADER)
    assert not [each for each in marks.complaints if each.line == 7]


def test_a_missing_student_is_listed_with_blank_answers(exam_folder: Path) -> None:
    marked(exam_folder, HEADER + "007,王伟,1,1,1\n\n , , \n0012,x,1,1,1\nS9,x,1,1,1\n")
    assert verdicts(exam_folder, "12") == ["blank"] * 3
    assert complaints(exam_folder) == [("", "", "12", 'no row for student "12"')]


def test_of_differing_rows_the_last_counts_and_the_others_are_kept(exam_folder: Path) -> None:
    marked(exam_folder, HEADER + "007,王伟,9,9,9\n" + ROWS + "007,王伟, 1.73,0,\n")
    assert verdicts(exam_folder, "007") == ["right", "right", "blank"]
    assert [
        complaint for complaint in complaints(exam_folder) if "another row" in complaint[3]
    ] == [
        ("2", "", "007,王伟,9,9,9", "another row for this student stands on line 7"),
        ("3", "", '007,王伟,"1,73",0.002,-0.125', "another row for this student stands on line 7"),
    ]


@pytest.mark.parametrize("first", [False, True])
@pytest.mark.parametrize("blank", ["007,王伟,,,\n", "007,王伟, ,-,\n"])
def test_a_row_that_was_never_filled_in_is_no_second_attempt(
    exam_folder: Path, blank: str, first: bool
) -> None:
    filled = f"007,王伟,{RIGHT},0,-0.125\n"
    marked(exam_folder, HEADER + (blank + filled if first else filled + blank))
    assert verdicts(exam_folder, "007") == ["right"] * 3
    assert not [each for each in complaints(exam_folder) if "another row" in each[3]]


def test_a_repeated_row_with_the_same_answers_is_ignored(exam_folder: Path) -> None:
    marks = marked(
        exam_folder, HEADER + ROWS + '007,W, "1,73" ,0.002,-0.125\n'.replace(' "1,73" ', RIGHT)
    )
    assert verdicts(exam_folder, "007") == ["right"] * 3
    assert [said(complaint.done) for complaint in marks.complaints if complaint.line == 2] == [
        "ignored, the answers are the same"
    ]


def test_a_missing_column_counts_as_blank(exam_folder: Path) -> None:
    marks = marked(
        exam_folder, "student,name,q1.v_B,q1.omega_AB\n007,x,1.73,0\n0012,x,,\nS9,x,,\n12,x,,\n"
    )
    assert verdicts(exam_folder, "007") == ["right", "right", "blank"]
    assert [str(complaint) for complaint in marks.complaints] == [
        "answers.csv: q2.a_B: no such column - all its answers count as blank"
    ]


def test_an_extra_column_is_ignored_and_its_cells_are_kept(exam_folder: Path) -> None:
    header = "student,name,q1.v_B,q1.omega_AB,q2.a_B,note,q1.v_B,\n"
    everybody = "007,x,1.73,0,0,,,\n0012,x,,,,@me,,z\nS9,x,,,,,5,\n12,x,,,,,,\n"
    marked(exam_folder, header + everybody)
    assert verdicts(exam_folder, "007") == ["right", "right", "wrong"]
    assert complaints(exam_folder) == [
        ("", "note", "3: @me", "not an answer column of the exam, or its second one"),
        ("", "q1.v_B", "4: 5", "not an answer column of the exam, or its second one"),
        ("", "", "3: z", "not an answer column of the exam, or its second one"),
    ]


def test_a_header_that_names_nothing_is_told_once_with_the_name_to_write(exam_folder: Path) -> None:
    header = "student,name,q1.v_B,q1.ω_AB [rad/s],2a,Notiz\n"
    marks = marked(exam_folder, header + "007,x,1.73,0,0,n\n0012,x,1,2,3,\nS9,x,,,,\n12,x,,,,\n")
    told = {each.column: (each.content, said(each.done)) for each in marks.complaints}
    alone = "a number alone names no question, since papers can be shuffled"
    assert told == {
        "q1.ω_AB [rad/s]": ("2: 0; 3: 2", 'ignored; head it "q1.omega_AB" if that one is meant'),
        "2a": ("2: 0; 3: 3", f'ignored: {alone}; head it "q2.a_B" if that one is meant'),
        "Notiz": ("2: n", "ignored; its cells are kept here only"),
        "q1.omega_AB": ("", "all its answers count as blank"),
        "q2.a_B": ("", "all its answers count as blank"),
    }


def test_numbers_alone_are_refused_as_ambiguous(exam_folder: Path) -> None:
    said_of_numbers = (
        "no answer column: a number alone names no question, since papers can be shuffled"
        " - expected q1.v_B, "
    )
    with pytest.raises(TableError, match=said_of_numbers):
        marked(exam_folder, "student,1a,1b\n007,1.73,0\n")


def test_ragged_lines_lose_nothing(exam_folder: Path) -> None:
    marked(exam_folder, HEADER + "007,x,1.73\n0012,x,0,0,0,8,9\nS9,x,,,\n12,x,,,\n")
    assert verdicts(exam_folder, "007") == ["right", "blank", "blank"]
    assert complaints(exam_folder) == [
        ("2", "", "", "the line has 3 cells, the header 5"),
        ("3", "", "8,9", "the line has 7 cells, the header 5"),
    ]


def test_two_numbers_in_two_lines_of_a_cell_are_not_two_answers(exam_folder: Path) -> None:
    marked(exam_folder, HEADER + '007,x,"1\n73",0.002,-0.125\n0012,x,1.73,+0.002,-0.125\n')
    assert verdicts(exam_folder, "007") == ["unreadable", "right", "right"]
    assert verdicts(exam_folder, "0012") == ["right"] * 3


def test_another_encoding_is_read_and_said(exam_folder: Path) -> None:
    marks = marked(
        exam_folder, (HEADER + ROWS.replace("Zoë", "")).replace("²", "^2").encode("gb18030")
    )
    assert verdicts(exam_folder, "007") == ["right"] * 3
    assert said(marks.complaints[0].problem).startswith("not valid UTF-8 from this line on")
    assert said(marks.complaints[0].done).startswith("read as GB18030")


def test_a_comma_that_may_be_a_thousands_separator_is_shown_to_a_person(exam_folder: Path) -> None:
    marked(exam_folder, HEADER + '007,x,"1,732",,\n0012,x,,,\nS9,x,,,\n12,x,,,\n')
    problem = "read as 1.732: a comma is the decimal mark, and nothing in the file says otherwise"
    assert complaints(exam_folder) == [("2", "q1.v_B", "1,732", problem)]


def test_a_minus_before_such_a_comma_is_in_what_a_person_is_shown(exam_folder: Path) -> None:
    marked(exam_folder, HEADER + '007,x,"-2,236",,\n0012,x,,,\nS9,x,,,\n12,x,,,\n')
    problem = "read as -2.236: a comma is the decimal mark, and nothing in the file says otherwise"
    assert complaints(exam_folder) == [("2", "q1.v_B", "-2,236", problem)]


def test_a_student_s_own_answers_or_a_declaration_say_what_a_comma_is(exam_folder: Path) -> None:
    sheet = HEADER + '007,x,"1,732",0.001,\n0012,x,"1,732",0,\nS9,x,,0.001,\n12,x,,,\n'
    marked(exam_folder, sheet)
    assert [verdicts(exam_folder, student)[0] for student in ("007", "0012")] == ["wrong", "wrong"]
    declared = grade(
        open_exam(exam_folder),
        exam_folder.parent / "answers.csv",
        exam_folder.parent / "AGAIN",
        MarkingWishes(decimal="comma"),
    )
    assert [verdicts(exam_folder, student, "AGAIN")[0] for student in ("007", "0012")] == [
        "right",
        "right",
    ]
    assert declared.complaints == ()


def test_units_roots_and_senses_flow_through(tmp_path: Path) -> None:
    head, papers = exam(), [paper(student) for student in STUDENTS]
    head["questions"][0]["asks"][1]["sign"] = "counter-clockwise positive"
    for each in papers:
        each["questions"][0]["asks"]["omega_AB"].update(exact="-4", value=-4.0, decimal="-4")
    folder = write_exam(tmp_path / "EXAM", head, papers)
    rows_typed = "007,x,√3,4 rad/s clockwise,-1/8\n0012,x,173.2 cm/s,-38.2 rpm,-12.5 cm/s²\n"
    marked(
        folder,
        HEADER + rows_typed + "S9,x,1.732 m/s,4 逆时针,0 m\n12,x,6.24 km/h,0.64 Hz,-0.125 ms^-2\n",
    )
    assert [verdicts(folder, student) for student in STUDENTS] == [
        ["right", "right", "right"], ["right", "right", "right"], ["right", "wrong", "wrong unit"],
        ["right", "wrong unit", "right"],
    ]  # fmt: skip
    read_as = [row[4] for row in rows(folder, "marks.csv")[1:6]]
    assert read_as == ["1.73205080757", "-4", "-0.125", "1.732", "-4.00029464557"]


def test_a_huge_cell_is_unreadable_and_cut_in_the_report(exam_folder: Path) -> None:
    marked(exam_folder, HEADER + f"007,x,{'9' * 200_000},,\n0012,x,,,\nS9,x,,,\n12,x,,,\n")
    assert complaints(exam_folder)[0][2] == "9" * 1000 + "… (1000/200000)"
    assert rows(exam_folder, "marks.csv")[1][6] == "unreadable"


def test_a_file_without_the_needed_columns_is_refused_with_both_faults(exam_folder: Path) -> None:
    with pytest.raises(TableError) as caught:
        marked(exam_folder, "number,mark\n1,2\n")
    assert caught.value.problems == (
        'answers.csv: no column "student" - expected one with the student ids '
        "- fill in the answers.csv of the exam folder",
        "answers.csv: no answer column - expected q1.v_B, q1.omega_AB, q2.a_B ... "
        "- fill in the answers.csv of the exam folder",
    )
    assert not (exam_folder.parent / "MARKS").exists()


def test_same_input_gives_the_same_bytes_and_replaces_only_by_force(exam_folder: Path) -> None:
    def digests() -> list[str]:
        folder = exam_folder.parent / "MARKS"
        return [hashlib.sha256(path.read_bytes()).hexdigest() for path in sorted(folder.iterdir())]

    marked(exam_folder, HEADER + ROWS)
    before = digests()
    with pytest.raises(OutputError, match="MARKS: already exists - .* --force"):
        marked(exam_folder, HEADER + ROWS)
    marked(exam_folder, HEADER + ROWS, force=True)
    assert digests() == before


def test_a_faulty_exam_leaves_the_old_marks(exam_folder: Path) -> None:
    marked(exam_folder, HEADER + ROWS)
    (exam_folder / "key.jsonl").unlink()
    with pytest.raises(ExamError):
        marked(exam_folder, HEADER + ROWS, force=True)
    assert len(rows(exam_folder, "grades.csv")) == 5


@pytest.mark.parametrize(
    ("amount", "text"),
    [("0", "0"), ("10", "10"), ("2.50", "2.5"), ("1/3", "0.3333"), ("1/20000", "0.0001")],
)
def test_points_are_shown_short(amount: str, text: str) -> None:
    assert write_amount(Fraction(amount)) == text


def test_the_sheet_of_another_exam_is_refused(exam_folder: Path) -> None:
    sheet = exam_folder.parent / "other.csv"
    sheet.write_text(
        "student,name,q1.v_B,q1.v_D,q2.omega_DE,q3.x_S\n12,Ann,1,2,3,4\n", encoding="utf-8"
    )
    with pytest.raises(
        TableError, match=r"most answer columns are not asked in this exam \(q1.v_d, q2.omega_de"
    ):
        grade(open_exam(exam_folder), sheet, exam_folder.parent / "MARKS")
