"""Whose answers they are: found by id or address, told where nobody or more than one may be meant,
never guessed.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.errors import TableError
from tests.lms.response_files import cells, csv_text, responses, told, write_asks
from tests.said import all_said, said

HEADER = ("Timestamp", "Email Address", "Student ID", "[v_B]", "[omega_AB]", "[a_B]")


def form(*people: tuple[str, str]) -> str:
    return csv_text(HEADER, *(("", email, student, "1", "2", "3") for email, student in people))


@pytest.mark.parametrize(
    ("email", "student", "who"),
    [
        ("", "0012345", "0012345"),
        ("", '="0012345"', "0012345"),
        ("", "'0012345", "0012345"),
        ("", "#0012345", "0012345"),
        ("", " ００12345\u3000", "0012345"),
        ("", "=2", "=2"),
        ("", "'=2", "=2"),
        ("wei@EXAMPLE.org ", "", "0012345"),
        ("anonymous", "S9", "S9"),
        ("wei@example.org", "0012345", "0012345"),
        ("wei@example.org", "?", "0012345"),
        ("", "Zoe@Example.org", "0012346"),
    ],
)
def test_students_are_found_by_id_or_address(
    tmp_path: Path, email: str, student: str, who: str
) -> None:
    assert cells(responses(tmp_path, form((email, student))))[1] == (who, "1", "2", "3")


@pytest.mark.parametrize(
    ("email", "student", "problem", "done"),
    [
        (
            "s9@example.org",
            "",
            'no student "s9@example.org" in the exam',
            'not graded; probably "S9": correct the file and grade again',
        ),
        ("", "x", 'no student "x" in the exam', "not graded"),
        ("", "", "no student id and no e-mail address", "not graded"),
        (
            "wei@example.org",
            "S9",
            "id and e-mail address are those of different students (0012345 and S9)",
            "not graded",
        ),
    ],
)
def test_nobody_is_guessed(
    tmp_path: Path, email: str, student: str, problem: str, done: str
) -> None:
    read = responses(tmp_path, form((email, student), ("", "0012346")))
    assert [row.cells[0] for row in read.table.rows] == ["0012346"]
    assert told(read) == [(2, problem, done)]
    assert read.table.complaints[0].content == f",{email},{student},1,2,3"


def test_ids_without_zeros_or_in_another_case_are_restored_and_said_once(tmp_path: Path) -> None:
    people = (("", "12345"), ("", "s9"), ("", "0012346"), ("", "12345"))
    read = responses(tmp_path, form(*people))
    assert [row.cells[0] for row in read.table.rows] == ["0012345", "S9", "0012346", "0012345"]
    assert told(read) == []
    assert said(read.assumed[-1]) == (
        'download.csv: 2 student ids are not as in the exam, such as "12345" for "0012345" - taken '
        "for these students, as each can mean only one; keep ids as text, as in answers.xlsx"
    )


def test_a_file_without_any_student_of_the_exam_is_refused_and_not_a_class_of_absentees(
    tmp_path: Path,
) -> None:
    people = [("", f"4.1{number}E+05") for number in range(3)]
    message = (
        r'none of its 3 rows is of a student of the exam \("4.10E\+05" ...\) - expected ids '
        r'like "0012345"'
    )
    with pytest.raises(TableError, match=message):
        responses(tmp_path, form(*people))
    assert len(told(responses(tmp_path, form(*people, ("", "S9"))))) == 3


def test_ids_that_a_program_wrote_as_fractions_are_restored(tmp_path: Path) -> None:
    read = responses(tmp_path, form(("", "12345.0"), ("", "12346.0"), ("", "S9")))
    assert [row.cells[0] for row in read.table.rows] == ["0012345", "0012346", "S9"]
    assert '"12345.0" for "0012345"' in said(read.assumed[-1])


@pytest.mark.parametrize("cell", ['="0012345"', "'0012345", "#0012345", "００12345"])
def test_an_id_in_a_wrapper_or_in_wide_digits_is_said_once_too(tmp_path: Path, cell: str) -> None:
    read = responses(tmp_path, form(("", cell), ("", "S9")))
    [line] = [line for line in all_said(read.assumed) if "not as in the exam" in line]
    assert f'1 student id is not as in the exam: "{cell}" for "0012345"' in line


def test_ids_as_in_the_exam_are_not_spoken_of(tmp_path: Path) -> None:
    read = responses(tmp_path, form(("", " 0012345 "), ("wei@example.org", "?")))
    assert not [line for line in all_said(read.assumed) if "not as in the exam" in line]


def test_an_id_that_can_mean_two_students_is_refused(tmp_path: Path) -> None:
    write_asks(tmp_path, students={"007": "", "07": "", "3": ""})
    read = responses(tmp_path, form(("", "7"), ("", "3")))
    hint = 'not graded; probably "007" or "07": correct the file and grade again'
    assert told(read) == [(2, 'no student "7" in the exam', hint)]


def test_the_address_of_one_student_is_not_overruled_by_an_id_without_zeros(tmp_path: Path) -> None:
    read = responses(tmp_path, form(("zoe@example.org", "12345"), ("", "S9")))
    assert [row.cells[0] for row in read.table.rows] == ["0012346", "S9"]


def test_an_address_of_two_students_is_nobody(tmp_path: Path) -> None:
    write_asks(tmp_path, students={"1": "wei@example.org", "2": "WEI@example.org", "3": ""})
    read = responses(tmp_path, form(("wei@example.org", ""), ("", "3")))
    assert told(read) == [
        (2, 'several students of the exam have the e-mail address "wei@example.org"', "not graded")
    ]


def test_names_tell_nobody(tmp_path: Path) -> None:
    write_asks(tmp_path, students={"Ann": "", "Bob": ""})
    header = (
        "Last name",
        "First name",
        "Email",
        "Status",
        "Grade/10.00",
        "Response 1",
        "Response 2",
        "Response 3",
    )
    with pytest.raises(
        TableError,
        match="no column says whose answers these are - expected the ids or the e-mail "
        "addresses of the exam's students - download the file with them",
    ):
        responses(
            tmp_path,
            csv_text(header, ("Ann", "Bob", "x@example.org", "Finished", "3", "1", "2", "3")),
        )


def test_a_column_that_knows_more_students_goes_before_another(tmp_path: Path) -> None:
    write_asks(tmp_path, students={str(number): "" for number in range(1, 5)})
    header = (
        "Last name",
        "First name",
        "Department",
        "ID",
        "State",
        "Grade/10.00",
        "Response 1",
        "Response 2",
        "Response 3",
    )
    rows = [("x", "y", "4", str(number), "Finished", "3", "1", "2", "3") for number in (1, 2, 3)]
    assert [row.cells[0] for row in responses(tmp_path, csv_text(header, *rows)).table.rows] == [
        "1",
        "2",
        "3",
    ]


def test_rows_of_one_student_keep_their_order(tmp_path: Path) -> None:
    content = form(("", "S9"), ("", "0012345"), ("", "#S9")).replace("1,2,3", "1,2,3", 1)
    assert [(row.line, row.cells[0]) for row in responses(tmp_path, content).table.rows] == [
        (2, "S9"),
        (3, "0012345"),
        (4, "S9"),
    ]


@pytest.mark.parametrize("declared", ["cp1252", "utf-16-le", "shift_jis"])
def test_a_declared_encoding_is_believed_where_the_file_is_not_utf_8(
    tmp_path: Path, declared: str
) -> None:
    typed = "\u2013 3" if declared == "cp1252" else "３０度"
    content = form(("", "S9")).replace("1,2,3", f"{typed},2,3")
    read = responses(tmp_path, content.encode(declared), encoding=declared)
    assert cells(read)[1] == ("S9", typed, "2", "3")
    assert f"download.csv: read as {declared}" in all_said(read.assumed)
    assert told(read) == []


def test_utf_8_and_byte_order_marks_go_before_what_is_declared(tmp_path: Path) -> None:
    content = form(("", "S9")).replace("1,2,3", "３０度,2,3")
    for written in ("utf-8", "utf-8-sig", "utf-16"):
        assert (
            cells(responses(tmp_path, content.encode(written), encoding="cp1252"))[1][1] == "３０度"
        )


@pytest.mark.parametrize(
    ("content", "declared"),
    [
        (b"student,x\nS9,\xff\n", "ascii"),
        (b"student\n\xff\n", "rot13"),
        (b"student\n\xff\n", "klingon"),
    ],
)
def test_a_wrong_declaration_is_refused(tmp_path: Path, content: bytes, declared: str) -> None:
    with pytest.raises(
        TableError, match=rf"is not in the declared encoding {declared} \(.*\) - expected text"
    ):
        responses(tmp_path, content, encoding=declared)
