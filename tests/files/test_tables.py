"""Tables as people send them: nothing in the file is lost on the way in, nothing runs on the way
out.
"""

from __future__ import annotations

import csv
import io
import tracemalloc
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.errors import TableError
from kinegrade.files.cell_text import shorten, trim
from kinegrade.files.csv_writing import neutralise, restore, write_csv, write_csv_text
from kinegrade.files.tables import Complaint, Table, parse_table, read_table
from tests.said import said

CHINESE = "student,name,q1.v_B\n007,王伟,0.5\n008,李娜,1.5\n"
# a file full of control characters is refused as not being text, and lone surrogates are no text at
# all
ANY_TEXT = st.text(
    st.characters(exclude_categories=["Cs", "Cc"], include_characters="\n\r\t"), max_size=40
)


def parsed(text: str) -> Table:
    return parse_table(text.encode(), "answers.csv")


def problems(table: Table) -> list[str]:
    return [f"{complaint.line}: {said(complaint.problem)}" for complaint in table.complaints]


@pytest.mark.parametrize(
    ("content", "encoding", "complains"),
    [
        (CHINESE.encode(), "UTF-8", False),
        (CHINESE.encode("utf-8-sig"), "UTF-8", False),
        (CHINESE.encode("utf-16"), "UTF-16-LE", False),
        (b"\xfe\xff" + CHINESE.encode("utf-16-be"), "UTF-16-BE", False),
        (CHINESE.encode("utf-32"), "UTF-32-LE", False),
        (CHINESE.encode("gb18030"), "GB18030", True),
    ],
)
def test_the_same_table_comes_out_of_every_encoding(
    content: bytes, encoding: str, complains: bool
) -> None:
    table = parse_table(content, "answers.csv")
    assert [row.cells for row in table.rows] == [("007", "王伟", "0.5"), ("008", "李娜", "1.5")]
    assert table.encoding == encoding
    assert problems(table) == (
        ["2: not valid UTF-8 from this line on (bytes cd f5 ce b0 2c 30 2e 35)"]
        if complains
        else []
    )


def test_a_western_file_is_not_taken_for_chinese() -> None:
    table = parse_table("student,name\n007,Müller\n008,Zoë\n".encode("cp1252"), "a.csv")
    assert table.encoding == "Windows-1252"
    assert [row.cell(1) for row in table.rows] == ["Müller", "Zoë"]


def test_a_chinese_file_with_many_western_names_is_read() -> None:
    names = ["Müller", "Zoë Núñez", "Łukasz Żółć", "王伟", "Große", "Björk Guðmundsdóttir"]
    text = "".join(f"{number},{name}\n" for number, name in enumerate(names))
    table = parse_table(f"student,name\n{text}".encode("gb18030"), "a.csv")
    assert table.encoding == "GB18030"
    assert [row.cell(1) for row in table.rows] == names


def test_bytes_of_no_encoding_are_written_out_and_the_rest_is_kept() -> None:
    table = parse_table(b"student,name\n007,Zo\x81\xff\n008,Ann\n", "a.csv")
    assert [row.cells for row in table.rows] == [("007", r"Zo\x81\xff"), ("008", "Ann")]
    assert said(table.complaints[0].done).startswith(
        "read as UTF-8 with the strange bytes written out"
    )


@pytest.mark.parametrize("separator", [",", ";", "\t"])
def test_the_separator_is_found_from_the_header(separator: str) -> None:
    table = parsed("student;name;q1.v_B\n007;Ann;1\n".replace(";", separator))
    assert (table.separator, table.rows[0].cells) == (separator, ("007", "Ann", "1"))


def test_decimal_commas_do_not_mislead_the_separator() -> None:
    assert parsed("student;a\n1;0,5\n2;1,5\n").rows[1].cells == ("2", "1,5")


def test_each_row_knows_the_line_it_begins_on() -> None:
    table = parsed('student,name\r\n\r\n1,"two\r\nlines"\r\n , \r\n2,x\r3,y\n')
    assert [(row.line, row.cell(0)) for row in table.rows] == [(3, "1"), (6, "2"), (7, "3")]


def test_ragged_rows_are_kept_and_reported() -> None:
    table = parsed("student,a,b\n1,x\n2,x,y,z,=w\n3,x,y,,\n")
    assert [row.cells for row in table.rows] == [
        ("1", "x"),
        ("2", "x", "y", "z", "=w"),
        ("3", "x", "y", "", ""),
    ]
    assert problems(table) == [
        "2: the line has 2 cells, the header 3",
        "3: the line has 5 cells, the header 3",
    ]
    assert table.complaints[1].content == "z,=w"
    assert table.rows[0].cell(2) == ""


def test_decimal_commas_between_commas_are_told_in_one_line_before_all_others() -> None:
    table = parsed("student,a,b\n1,0,5,1,5\n2,3,4\n3,0,5,1\n4,0,5,2,5\n")
    first, *others = table.complaints
    assert str(first) == (
        "answers.csv: 3 lines have more than the 3 cells of the header, as where decimal commas stand "
        "unquoted between commas - all behind the first of them stand in wrong columns: save the "
        "file with semicolons or tabs between the cells"
    )
    assert [each.line for each in others] == [2, 4, 5]
    few = parsed("student,a,b\n1,0,5,1,5\n2,3,4\n3,3,4\n4,0,5,2\n5,0,5,1\n6,1,2\n")
    assert [each.line for each in few.complaints] == [2, 5, 6]


@pytest.mark.parametrize(
    "stray",
    ['2,"0,5', '2,"0.5,', '"2,x'],
)
def test_a_stray_quotation_mark_does_not_swallow_the_rows_after_it(stray: str) -> None:
    table = parsed(f'student,a\n1,x\n{stray}\n3,"y"\n4,"z"\n')
    assert [row.line for row in table.rows] == [2, 3, 4, 5]
    assert [row.cells for row in table.rows][2:] == [("3", "y"), ("4", "z")]
    assert "3: a quotation mark is opened and not closed where it should be" in problems(table)


def test_many_stray_quotation_marks_cost_no_more_than_a_few_readings() -> None:
    table = parsed("student,a\n" + 'a"b,"c\n' * 5000)
    assert len(table.rows) == 5000


def test_nul_bytes_and_huge_cells_survive() -> None:
    huge = "9" * 300_000
    before = csv.field_size_limit()
    table = parsed(f"student,name,a\n1,{huge},x\0y\n2,Ann,z\n")
    assert [row.cells for row in table.rows] == [("1", huge, "x\0y"), ("2", "Ann", "z")]
    assert csv.field_size_limit() == before
    assert shorten(huge) == "9" * 1000 + "… (1000/300000)"


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "a.csv: is empty - expected a line of column names"),
        (b"\xef\xbb\xbf\n , ,\n", "a.csv: is empty"),
        (
            b"PK\x03\x04rest",
            "a.csv: is a spreadsheet or archive - expected a CSV file - save the sheet as CSV",
        ),
        (b"\x89PNG\r\n\x1a\n", "is a picture"),
        ("student,name\n".encode("utf-16-le"), "a.csv: is not text"),
    ],
)
def test_what_is_no_table_is_refused(content: bytes, message: str) -> None:
    with pytest.raises(TableError, match=message):
        parse_table(content, "a.csv")


def test_a_missing_file_is_named(tmp_path: Path) -> None:
    with pytest.raises(
        TableError, match=r"absent.csv: cannot be read \(No such file or directory\)"
    ):
        read_table(tmp_path / "absent.csv")


@given(st.binary(max_size=300))
def test_any_bytes_give_a_table_or_a_table_error(content: bytes) -> None:
    try:
        table = parse_table(b"student,name\n" + content, "a.csv")
    except TableError:
        return
    assert table.header == ("student", "name")


@given(st.lists(st.tuples(ANY_TEXT, ANY_TEXT, st.just("x")), min_size=1))
def test_what_is_written_is_read_back(rows: list[tuple[str, str, str]]) -> None:
    text = write_csv_text(("a", "b", "c"), rows)
    assert [row.cells for row in parsed(text).rows] == rows


def test_written_files_have_lf_and_keep_typed_digits(tmp_path: Path) -> None:
    write_csv(
        tmp_path / "a.csv",
        ("student", "n"),
        [("007", "1.50"), ("a\rb", 'say "hi", 王'), ("\ud800", "")],
    )
    assert (tmp_path / "a.csv").read_bytes() == (
        'student,n\n007,1.50\n"a\rb","say ""hi"", 王"\n\\ud800,\n'.encode()
    )


@pytest.mark.parametrize(
    "formula", ["=1+1", "+cmd", "-1 m/s", "@x", "\t=1", "\r=1", "'=1", "=", "--", "'-", "＝1"]
)
def test_a_formula_gets_one_apostrophe(formula: str) -> None:
    assert neutralise(formula) == f"'{formula}"


@pytest.mark.parametrize(
    "plain", ["-", "-12", "+3", "-0,5", "-.5", "-1e-5", "O'Neil", "'t Hooft", "0.5", "", "王"]
)
def test_plain_numbers_and_names_stay_as_they_are(plain: str) -> None:
    assert neutralise(plain) == plain


@given(st.one_of(ANY_TEXT, st.text("'=+-@\t\r1.,e", max_size=6)))
def test_neutralising_can_be_undone(text: str) -> None:
    assert restore(neutralise(text)) == text


@given(ANY_TEXT)
def test_trimmed_text_has_nothing_left_to_trim(text: str) -> None:
    assert trim(trim(text)) == trim(text)
    assert trim(f"\u3000\u00a0 {text}\ufeff\t") == trim(text)


def test_a_complaint_reads_as_one_line() -> None:
    complaint = Complaint("answers.csv", 7, "q1.v_B", "abc", "not a number", "no points")
    assert str(complaint) == "answers.csv:7: q1.v_B: not a number - no points"
    assert next(csv.reader(io.StringIO(write_csv_text([str(complaint)], []))))[0] == str(complaint)


@pytest.mark.parametrize("first", ["sep=;", '"sep=;"', "SEP=;", "sep=;;"])
def test_a_line_that_names_the_separator_is_passed_over(first: str) -> None:
    content = f"{first}\r\nstudent;x\r\n007;0,5\r\n".encode()
    for is_header in (None, lambda cells: "student" in cells):
        table = parse_table(content, "a.csv", None, is_header)
        assert (table.header, table.above) == (("student", "x"), ())
        assert [(row.line, row.cells) for row in table.rows] == [(3, ("007", "0,5"))]


def test_rows_are_packed_as_they_are_read() -> None:
    content = b"student,x,y,z\n" + b"".join(b'%d,"0,5",1,2\n' % row for row in range(3000))
    tracemalloc.start()
    try:
        parse_table(content, "answers.csv")
        assert tracemalloc.get_traced_memory()[1] < 24 * len(content)
    finally:
        tracemalloc.stop()
