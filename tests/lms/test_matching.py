"""Whose row is whose: by keys as the system compares them; what is only likely is told and not
done.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.errors import TableError
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.lms.grades.dialect import ExportOptions
from kinegrade.lms.grades.fill_in import fill_in
from kinegrade.lms.grades.grades import read_grades
from kinegrade.lms.grades.systems.moodle import MOODLE
from kinegrade.marks_folder.folder import MarksFolder
from tests.lms.marked_folder import changed, filled, write_exam, write_marks

GRADE = "Quiz (Real)"


def told(folder: Path, rows: str, header: str = "ID number", by: tuple[str, ...] = ()) -> list[str]:
    text = (
        f"{header},{GRADE}\n0012346,\n{rows}"
        if header == "ID number"
        else f"{header},{GRADE}\n{rows}"
    )
    result = filled(folder, MOODLE, text, ExportOptions(by=by, feedback=False))  # type: ignore[arg-type]
    return [str(each).removeprefix("download.csv").lstrip(":") for each in result.complaints]


@pytest.mark.parametrize(
    "cell",
    ["12345", "００12345", '"=""0012345"""', "'0012345", "#0012345", "0012345.0", "00012345"],
)
def test_what_is_likely_the_same_is_suggested_and_not_made(tmp_path: Path, cell: str) -> None:
    complaints = told(tmp_path, f"{cell},\n0012348,\n")
    assert set(changed(tmp_path)) == {(2, GRADE), (4, GRADE)}
    assert complaints[0].startswith(
        ' no row for student "0012345" by ID number - not exported; line 3 has ID number "'
    )
    assert complaints[0].endswith('", probably the same: correct one of the two and export again')
    assert complaints[1].startswith('3: no student of the marked class has ID number "')
    assert len(complaints) == 2


def test_ids_that_lost_their_zeros_are_told_once_and_not_taken(tmp_path: Path) -> None:
    with pytest.raises(TableError) as caught:
        told(tmp_path, "12345,\n12346,\n12347,\n12348,\n77,\n", "Username")
    assert caught.value.problems[1:] == (
        'download.csv: Username: 4 ids differ from those of the class by zeros in front alone: "12345" '
        'for "0012345", "12346" for "0012346", "12347" for "0012347" and 1 more - not exported; '
        "download the file again and leave it as it is, or correct the ids",
        'download.csv:6: no student of the marked class has Username "77" - the line was not changed',
    )


def test_case_is_no_matter_for_addresses_only(tmp_path: Path) -> None:
    assert len(told(tmp_path, "W1@EXAMPLE.invalid,\n", "Email address")) == 2  # those without a row
    assert changed(tmp_path) == {(2, GRADE): "8.25"}


def test_a_row_with_an_id_of_nobody_is_nobodys_whatever_its_address(tmp_path: Path) -> None:
    text = (
        f"ID number,Email address,{GRADE}\n0012346,,\n0012348,,\n0999,w1@example.invalid,\n"
        ",w1@example.invalid,\n"
    )
    marks, path = write_marks(tmp_path / "MARKS"), tmp_path / "download.csv"
    grades = read_grades(MarksFolder(marks), open_exam(write_exam(tmp_path / "EXAM")))
    path.write_text(text, encoding="utf-8")
    result = fill_in(MOODLE, grades, path, ExportOptions(feedback=False))
    lines = result.content.decode().splitlines()
    assert lines[3:] == ["0999,w1@example.invalid,", ",w1@example.invalid,8.25"]
    said = (
        'no student of the marked class has ID number "0999", Email address "w1@example.invalid" - '
        "the line was not changed"
    )
    assert [str(each) for each in result.complaints] == [f"download.csv:4: {said}"]


def test_a_number_in_short_form_is_nobody_certain(tmp_path: Path) -> None:
    long = {"0012345": "202100000001", "0012346": "202100000002", "0012348": "202100000003"}
    marks = write_marks(tmp_path / "MARKS", students=long)
    path = tmp_path / "download.csv"
    path.write_text(f"ID number,{GRADE}\n2.021E+11,\n202100000003,\n", encoding="utf-8")
    result = fill_in(MOODLE, read_grades(MarksFolder(marks)), path, ExportOptions())
    complaints = [str(each) for each in result.complaints]
    assert result.content.decode().splitlines()[1:] == ["2.021E+11,", "202100000003,9.6667"]
    for complaint in complaints[:2]:
        assert (
            'line 2 has ID number "2.021E+11", a number that a spreadsheet has cut: download the '
            "file again and "
            "leave it as it is"
        ) in complaint
    assert len(complaints) == 3


def test_two_rows_of_one_student_are_both_left(tmp_path: Path) -> None:
    assert told(tmp_path, "0012345,\n0012345,\n0012348,\n") == [
        '3: student "0012345" is found on lines 3 and 4 by ID number - none of these lines was '
        "changed"
    ]
    assert set(changed(tmp_path)) == {(2, GRADE), (5, GRADE)}


def test_keys_that_disagree_match_nobody(tmp_path: Path) -> None:
    with pytest.raises(TableError) as caught:
        told(tmp_path, "0012345,0012346,\n0012348,0012345,\n", "ID number,Username")
    assert caught.value.problems[1:] == (
        'download.csv:2: student "0012345" is found on lines 2 and 3 by ID number or Username - '
        "none of these lines "
        "was changed",
        'download.csv:2: is the row of several students: "0012345" and "0012346" - the line was not '
        "changed",
        'download.csv:3: is the row of several students: "0012345" and "0012348" - the line was not '
        "changed",
    )
    told(tmp_path, "0012345,0012346,\n0012348,0012345,\n", "ID number,Username", by=("id",))
    assert changed(tmp_path) == {(2, GRADE): "8.25", (3, GRADE): "9.6667"}


def test_a_name_alone_matches_nobody(tmp_path: Path) -> None:
    with pytest.raises(
        TableError,
        match="no column by which Moodle identifies students - expected one that holds the ids of the "
        "marked class",
    ):
        told(tmp_path, "王伟,\n", "Full name")


def test_nobody_at_all_is_refused_with_the_reasons(tmp_path: Path) -> None:
    with pytest.raises(TableError) as caught:
        told(tmp_path, "7,\n12345,\n", "Username")
    first, *others = caught.value.problems
    assert first.startswith(
        "download.csv: no grade can be filled in - expected rows of the students who were marked"
    )
    assert any("probably the same" in problem for problem in others), others
