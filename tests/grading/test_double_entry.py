"""Answers that were typed twice: what differs is told cell by cell with its lines; what is equal as a
typed value is not; nothing is written where anything differs.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from openpyxl import Workbook

import kinegrade as library
from kinegrade.errors import TableError
from tests.small_class import kinegrade

HEAD = "student,q1.v_B,q1.omega_AB,q2.a_B\n"


def compare(folder: Path, first: str, second: str, *exam: Path) -> tuple[int, list[list[str]], str]:
    """The status, the cells of the table and the summary."""
    files = folder / "a.csv", folder / "b.csv"
    for file, text in zip(files, (first, second), strict=True):
        file.write_text(text, encoding="utf-8")
    done = kinegrade("compare-entries", *files, *exam)
    *rows, summary = done.stdout.splitlines()
    return done.exit_code, [row.split() for row in rows[1:]], summary


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ('"1,5"', "1.50"),
        ("0.5", ".5"),
        ("-", ""),
        (" 2", "2"),
        ("1.5e1", "15"),
        ("1500 mm/s", "1.5"),
        ("1.7 clockwise", "1.7 clockwise"),
    ],
)
def test_what_is_equal_as_a_typed_value_is_equal(
    exam_folder: Path, tmp_path: Path, first: str, second: str
) -> None:
    texts = (f"student,q1.v_B\n007,{each}\n" for each in (first, second))
    assert compare(tmp_path, *texts, exam_folder)[:2] == (0, [])


@pytest.mark.parametrize(
    ("first", "second"), [("1.5", "1.51"), ("1.5", "-1.5"), ("?", "!"), ("1.5", ""), ("0", "-")]
)
def test_what_is_not_is_told_with_its_lines(
    exam_folder: Path, tmp_path: Path, first: str, second: str
) -> None:
    texts = (f"student,q1.v_B\n12,1\n007,{first}\n", f"student,q1.v_B\n007,{second}\n12,1\n")
    status, rows, summary = compare(tmp_path, *texts, exam_folder)
    shown = [first, "3", second, "2"] if second else [first, "3", "2"]
    assert (status, rows) == (1, [["007", "q1.v_B", *shown]])
    assert summary == "1 cell differs; 1 filled cell agrees"


@pytest.mark.parametrize("with_exam", [True, False])
def test_two_names_beside_one_id_are_told(
    exam_folder: Path, tmp_path: Path, with_exam: bool
) -> None:
    """Two people disagree whose row it is, and the answers agree."""
    files = tmp_path / "a.csv", tmp_path / "b.csv"
    head = "student,name,q1.v_B\n"
    files[0].write_text(head + '0012,"O\'Neil, Zoë",3\n007,Ada Byron,2\n', encoding="utf-8")
    files[1].write_text(head + "007,Ute Byron,2\n0012,zoe o'neil,3\n", encoding="utf-8")
    exam = (exam_folder,) if with_exam else ()
    agreed = "-o", tmp_path / "agreed.csv"
    done = kinegrade("compare-entries", *files, *exam, *agreed)
    assert done.exit_code == 1
    assert (
        'b.csv:2: name: "Ute Byron" here, and "Ada Byron" in a.csv - compared as the row of "007"; '
        "correct the file in which the id is not that of the name"
    ) in done.stderr
    assert "O'Neil" not in done.stderr
    assert "zoe" not in done.stderr
    assert not (tmp_path / "agreed.csv").exists()


def test_without_the_exam_sheets_are_compared_by_their_headers(tmp_path: Path) -> None:
    other = "student,q2.a_B,q1.v_B,q1.omega_AB\n12,3,1,2\n007,6,4.0,5\n"
    assert compare(tmp_path, f"{HEAD}007,4,5,6\n12,1,2,3\n", other)[0] == 0
    less = "student,q1.v_B\n007,4\n8,1\n"
    status, rows, summary = compare(tmp_path, f"{HEAD}007,4,5,\n", less)
    assert status == 1
    assert rows == [["007", "q1.omega_AB", "5", "2", "2"], ["8", "*", "–", "3"]]
    assert summary.startswith("1 cell differs; 1 student in one of the files only")


def test_a_file_is_not_compared_with_itself(tmp_path: Path) -> None:
    file = tmp_path / "a.csv"
    file.write_text(HEAD + "007,1,2,3\n", encoding="utf-8")
    refused = kinegrade("compare-entries", file, tmp_path / "." / "a.csv")
    assert refused.exit_code == 2
    assert refused.stderr == (
        f"error: {file}: is given twice - expected each file of the class once - leave one out, "
        "or name the file that was meant\n"
    )


def test_a_student_who_stands_twice_in_a_file_is_compared_with_himself(tmp_path: Path) -> None:
    _, rows, _ = compare(tmp_path, f"{HEAD}007,4,5,6\n007,4,9,6\n", f"{HEAD}007,4,9,6\n")
    assert rows == [["007", "q1.omega_AB", "5", "|", "9", "2", "|", "3", "9", "2"]]


def test_a_row_that_stands_twice_in_the_second_file_is_told_as_that_file_s_and_counted_once(
    tmp_path: Path,
) -> None:
    _, rows, summary = compare(tmp_path, f"{HEAD}007,1,2,\n", f"{HEAD}007,1,2,\n007,3,2,\n")
    assert rows == [["007", "q1.v_B", "1", "2", "1", "|", "3", "2", "|", "3"]]
    assert summary == "1 cell differs; 1 filled cell agrees"


def test_a_workbook_and_a_long_table_are_compared_by_the_exam(
    exam_folder: Path, tmp_path: Path
) -> None:
    workbook = Workbook()
    sheet = workbook.active
    assert sheet is not None
    for row in (["student", "q1.v_B (m/s)", "q2a"], ["007", "1.5", "2"], ["0012", "1", "-3"]):
        sheet.append(row)
    workbook.save(tmp_path / "a.xlsx")
    long = tmp_path / "long.csv"
    long.write_text("student,ask,answer\n0012,2a,-3\n007,1a,1.50\n007,q2.a_B,2\n", encoding="utf-8")
    done = kinegrade("compare-entries", tmp_path / "a.xlsx", long, exam_folder)
    assert done.exit_code == 1
    assert [line.split() for line in done.stdout.splitlines()[1:-1]] == [
        ["0012", "q1.v_B", "1", "3", "2"]
    ]
    alone = kinegrade("compare-entries", tmp_path / "a.xlsx", long)
    assert alone.exit_code == 2
    assert (
        "long.csv: names asks line by line, which only the exam explains - name EXAM as well"
        in alone.stderr
    )


def test_rows_of_nobody_are_complained_of_and_no_sheet_is_written(
    exam_folder: Path, tmp_path: Path
) -> None:
    file, again = tmp_path / "a.csv", tmp_path / "b.csv"
    for each in (file, again):
        each.write_text("student,q1.v_B\n007,1\n999,1\n", encoding="utf-8")
    merged = tmp_path / "merged.csv"
    done = kinegrade("compare-entries", file, again, exam_folder, "-o", merged)
    assert done.exit_code == 1
    assert 'a.csv:3: student: no student "999" in the exam' in done.stderr
    assert (
        f"{merged}: not written: correct what is said here in both files and compare again"
        in done.stderr
    )
    assert not merged.exists()


def test_a_sheet_without_a_student_column_is_refused(tmp_path: Path) -> None:
    for name in ("a.csv", "b.csv"):
        (tmp_path / name).write_text("q1.v_B\n1\n", encoding="utf-8")
    with pytest.raises(TableError, match='no column "student"'):
        library.compare_entries(tmp_path / "a.csv", tmp_path / "b.csv")


def test_equal_answers_in_two_files_are_no_conflict(exam_folder: Path, tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text('student,q1.v_B\n007,"1,73"\n', encoding="utf-8")
    (tmp_path / "b.csv").write_text("student,q1.v_B,q2.a_B\n007,1.730,-0.125\n", encoding="utf-8")
    marks = tmp_path / "MARKS"
    files = tmp_path / "a.csv", tmp_path / "b.csv"
    said = kinegrade("grade", exam_folder, *files, "-o", marks).stderr
    assert "here and" not in said


TIMED = "student,q1.v_B,submitted\n"


@pytest.mark.parametrize("with_exam", [True, False])
def test_times_of_handing_in_are_compared_and_carried_over(
    exam_folder: Path, tmp_path: Path, *, with_exam: bool
) -> None:
    exam = (exam_folder,) if with_exam else ()
    first = f"{TIMED}007,1.5,2026-10-20 18:10\n0012,2,\n"
    status, rows, summary = compare(
        tmp_path, first, f"{TIMED}007,1.5,2026-10-21 18:10\n0012,2,\n", *exam
    )
    assert (status, rows) == (
        1,
        [["007", "submitted", "2026-10-20", "18:10", "2", "2026-10-21", "18:10", "2"]],
    )
    assert summary == "1 cell differs; 2 filled cells agree"
    for second in (
        f"{TIMED}007,1.50,2026-10-20T18:10\n0012,2,\n",
        "student,q1.v_B\n007,1.5\n0012,2\n",
    ):
        assert compare(tmp_path, first, second, *exam)[0] == 0
        files, agreed = (tmp_path / "a.csv", tmp_path / "b.csv"), tmp_path / "agreed.csv"
        done = kinegrade("compare-entries", *files, *exam, "-o", agreed, "--force")
        assert done.exit_code == 0, done.stderr
        head, *lines = agreed.read_text(encoding="utf-8-sig").splitlines()
        assert head.endswith(",submitted")
        assert {line.split(",")[0]: line.split(",")[-1] for line in lines} == {
            "007": "2026-10-20 18:10",
            "0012": "",
        }


def test_headers_with_another_unit_are_another_content(exam_folder: Path, tmp_path: Path) -> None:
    first, second = "student,q1.v_B (mm/s)\n007,1.5\n", "student,q1.v_B (m/s)\n007,1.5\n"
    for exam in ((), (exam_folder,)):
        status, rows, _ = compare(tmp_path, first, second, *exam)
        assert (status, rows) == (1, [["007", "q1.v_B", "1.5", "mm/s", "2", "1.5", "2"]])
    agreed = tmp_path / "agreed.csv"
    assert compare(tmp_path, first, "student,q1.v_B\n007,1.5 mm/s\n")[0] == 0
    (tmp_path / "b.csv").write_text(first, encoding="utf-8")
    kinegrade("compare-entries", tmp_path / "a.csv", tmp_path / "b.csv", "-o", agreed)
    assert agreed.read_text(encoding="utf-8-sig") == first
