"""Workbooks: numbers as they were typed, oddities told, hostile files refused in one line."""

from __future__ import annotations

import os
import subprocess
import sys
import zipfile
from collections.abc import Sequence
from datetime import date, datetime, time
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from openpyxl import Workbook, load_workbook

from kinegrade.errors import TableError
from kinegrade.files.workbooks import cells
from kinegrade.files.workbooks import inspection as workbook_inspection
from kinegrade.files.workbooks.inspection import is_workbook
from kinegrade.files.workbooks.spreadsheet import read_workbook
from tests.files.written_workbooks import SHEET, book, told, with_cells, with_part
from tests.said import said


def test_cells_come_out_as_they_were_typed(tmp_path: Path) -> None:
    path = book(
        tmp_path / "a.xlsx",
        [None, None],
        ["student", " q1.v_B ", None, "x"],
        [],
        [12345, 0.5, None, "1,5"],
        ["007", -1e-7, "三", True],
        [0.1 + 0.2, 5.0, " ", 1e20],
    )
    table = read_workbook(path)
    assert table.header == ("student", " q1.v_B ", "", "x")
    assert [(row.line, row.cells) for row in table.rows] == [
        (4, ("12345", "0.5", "", "1,5")),
        (5, ("007", "-1e-07", "三", "TRUE")),
        (6, ("0.3", "5", " ", "1e+20")),
    ]
    assert (table.file, table.encoding) == ("a.xlsx", "XLSX")


@given(st.decimals(-(10**9), 10**9, places=6))
def test_a_decimal_of_fifteen_digits_comes_back(number: object) -> None:
    cell = type("Cell", (), {"value": float(str(number)), "number_format": "General"})
    assert float(cells.read_cell(cell).text) == float(str(number))
    assert "e" not in cells.read_cell(cell).text or abs(float(str(number))) < 1e-4


def test_the_seventeen_digits_a_spreadsheet_keeps_are_those_typed(tmp_path: Path) -> None:
    path = with_cells(
        tmp_path / "a.xlsx",
        "<row><c><v>1.1000000000000001</v></c></row><row><c><v>2E-3</v></c></row>",
    )
    assert [row.cells for row in read_workbook(path).rows] == [("1.1",), ("0.002",)]


def test_ids_that_are_shown_with_zeros_keep_them(tmp_path: Path) -> None:
    written = Workbook()
    written.active.append(["student"])
    written.active.append([12345])
    written.active["A2"].number_format = "0000000"
    written.save(tmp_path / "a.xlsx")
    assert read_workbook(tmp_path / "a.xlsx").rows[0].cells == ("0012345",)


def test_dates_long_numbers_and_formulas_are_told(tmp_path: Path) -> None:
    path = book(
        tmp_path / "a.xlsx",
        ["student", "b"],
        [2.02100123456789e18, datetime(2026, 2, 1)],
        [date(2026, 3, 4), time(1, 2)],
        ["=1+1", "x"],
    )
    assert told(read_workbook(path)) == [
        (
            2,
            "student",
            "2.02100123456789e+18",
            "the cell is a number of more than 15 digits, of which spreadsheets lose the last",
        ),
        (
            2,
            "b",
            "2026-02-01 00:00:00",
            "the cell is a date or a time for the spreadsheet, whatever was typed",
        ),
        (
            3,
            "student",
            "2026-03-04",
            "the cell is a date or a time for the spreadsheet, whatever was typed",
        ),
        (
            3,
            "b",
            "01:02:00",
            "the cell is a date or a time for the spreadsheet, whatever was typed",
        ),
        (
            4,
            "student",
            "",
            "the cell holds the formula =1+1 without its value; open the file in the spreadsheet"
            " program and save it",
        ),
    ]


def test_a_formula_without_a_value_behind_the_last_filled_cell_is_told(tmp_path: Path) -> None:
    path = book(tmp_path / "a.xlsx", ["student", "a", "b"], ["7", "=1/3"], ["8", 2, 3])
    assert told(read_workbook(path)) == [
        (
            2,
            "a",
            "",
            "the cell holds the formula =1/3 without its value; open the file in the spreadsheet"
            " program and save it",
        )
    ]
    assert [said(each.done) for each in read_workbook(path).complaints] == ["read as blank"]


def test_a_formula_gives_the_value_that_was_computed(tmp_path: Path) -> None:
    path = with_cells(tmp_path / "a.xlsx", '<row r="2"><c r="A2"><f>SUM(1,2)</f><v>3</v></c></row>')
    table = read_workbook(path)
    assert table.rows[0].cells == ("3",)
    assert told(table) == [(2, "student", "3", "the cell is computed by the formula =SUM(1,2)")]


def test_an_id_wrapped_in_a_formula_is_that_id_computed_or_not(tmp_path: Path) -> None:
    table = read_workbook(book(tmp_path / "a.xlsx", ["student", "b"], ['="0012345"', 1]))
    assert (table.rows[0].cells[0], told(table)) == ("0012345", [])
    cell = '<c r="A2" t="str"><f>"0012345"</f><v>0012345</v></c>'
    table = read_workbook(with_cells(tmp_path / "b.xlsx", f'<row r="2">{cell}</row>'))
    assert (table.rows[0].cells[0], told(table)) == ("0012345", [])


def test_surplus_cells_and_other_sheets_are_told(tmp_path: Path) -> None:
    written = Workbook()
    written.active.title = "Notes"
    hidden = written.create_sheet("Hidden")
    hidden.append(["secret"])
    hidden.sheet_state = "hidden"
    for name in ("Answers", "Old", "Blank"):
        written.create_sheet(name)
    for row in (["student", "x"], ["7", "1", "y", None, "z"]):
        written["Answers"].append(row)
    written["Old"].append(["student"])
    written.save(tmp_path / "a.xlsx")
    table = read_workbook(tmp_path / "a.xlsx")
    assert [row.cells for row in table.rows] == [("7", "1", "y", "", "z")]
    assert told(table) == [
        (None, "", "Old", "the workbook has several filled sheets"),
        (2, "", "y; z", "cells stand beside the table, under no column name"),
    ]
    assert (
        said(table.complaints[0].done)
        == 'the first, "Answers", is read, not "Old"; delete it if another one is meant'
    )


def test_the_only_sheet_with_a_header_of_ours_is_read(tmp_path: Path) -> None:
    written = Workbook()
    written.active.title = "Notes"
    written.active.append(["see the second sheet"])
    sheet = written.create_sheet("Answers")
    for row in (["Midterm"], ["student", "x"], ["7", "1"]):
        sheet.append(row)
    file = tmp_path / "a.xlsx"
    written.save(file)

    def read(path: Path) -> tuple[list[str], str]:
        table = read_workbook(path, is_ours, is_ours)
        return list(table.header), said(table.complaints[0].done)

    def is_ours(cells: Sequence[str]) -> bool:
        return "student" in cells

    only = '"Answers" is read, not "Notes": only its columns are known'
    assert read(file) == (["student", "x"], only)
    written.create_sheet("Old").append(["student"])
    written.save(file)
    first = 'the first, "Notes", is read, not "Answers", "Old"; delete it if another one is meant'
    assert read(file) == (["see the second sheet"], first)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (
            b"\xd0\xcf\x11\xe0 old",
            r"a.xlsx: is an old .xls workbook, or one with a password - expected .xlsx - save",
        ),
        (
            b"PK\x03\x04 broken",
            "a.xlsx: is not a workbook, or a damaged one - expected .xlsx - save the sheet as "
            ".xlsx",
        ),
    ],
)
def test_what_is_no_workbook_is_refused(tmp_path: Path, content: bytes, message: str) -> None:
    (tmp_path / "a.xlsx").write_bytes(content)
    assert is_workbook(tmp_path / "a.xlsx")
    with pytest.raises(TableError, match=message):
        read_workbook(tmp_path / "a.xlsx")


def test_missing_and_empty_files_and_archives_are_refused(tmp_path: Path) -> None:
    assert not is_workbook(tmp_path / "none.xlsx")
    with pytest.raises(
        TableError,
        match=r"cannot be read \(No such file or directory\) - expected a workbook - check",
    ):
        read_workbook(tmp_path / "none.xlsx")
    with pytest.raises(
        TableError, match="a.xlsx: has no filled sheet - expected a line of column names - save"
    ):
        read_workbook(book(tmp_path / "a.xlsx", [None], [" "]))
    with zipfile.ZipFile(tmp_path / "form.csv.zip", "w") as archive:
        archive.writestr("form.csv", "Timestamp\n")
    with pytest.raises(
        TableError,
        match="is an archive, not a workbook - expected .xlsx or CSV - send the file in it",
    ):
        read_workbook(tmp_path / "form.csv.zip")


def test_a_workbook_that_bursts_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = book(tmp_path / "a.xlsx", ["student"])
    with zipfile.ZipFile(path, "a", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("xl/media/x.bin", bytes(2_000_000))  # a picture is not read
        archive.writestr("xl/x.xml", b" " * 1_000_000)
    read_workbook(path)
    monkeypatch.setattr(workbook_inspection, "_LARGEST", 1_000_000)
    with pytest.raises(
        TableError, match=r"unpacks to 10\d+ bytes in \d+ parts - expected less than 1000000 - send"
    ):
        read_workbook(path)


@pytest.mark.parametrize(
    "cells",
    [
        '<row r="99999999999"><c><v>1</v></c></row>',
        '<row r="2"/><row r="1048576"><c r="A1048576"><v>1</v></c></row>',
        "".join(f'<row r="{line}"><c r="XFD{line}"><v>1</v></c></row>' for line in range(2, 200)),
    ],
)
def test_a_cell_at_the_end_of_the_world_is_refused(tmp_path: Path, cells: str) -> None:
    with pytest.raises(
        TableError,
        match="sheet Sheet reaches beyond 100000 rows or 2000000 cells - expected a class",
    ):
        read_workbook(with_cells(tmp_path / "a.xlsx", cells))


@pytest.mark.parametrize(
    "cells",
    [
        "<row",
        '<row><c t="s"><v>99</v></c></row>',
        "<row><c><v>x</v></c></row>",
        '<row r="x"/>',
        f"<row><c><v>{'9' * 5000}</v></c></row>",
    ],
)
def test_a_damaged_workbook_is_refused_in_one_line(tmp_path: Path, cells: str) -> None:
    with pytest.raises(
        TableError, match=r"\Aa.xlsx: is a damaged workbook \(.+\) - expected .xlsx - save.*\Z"
    ):
        read_workbook(with_cells(tmp_path / "a.xlsx", cells))


def test_entities_are_refused_before_they_grow(tmp_path: Path) -> None:
    bomb = '<!DOCTYPE x [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;">]>'
    path = with_part(book(tmp_path / "a.xlsx", ["student"]), SHEET, lambda xml: bomb + xml)
    with pytest.raises(
        TableError, match=rf"a.xlsx: {SHEET} declares a document type - expected none"
    ):
        read_workbook(path)


def test_a_dimension_that_lies_changes_nothing(tmp_path: Path) -> None:
    path = book(tmp_path / "a.xlsx", ["student", "x"], ["7", "1"])
    with_part(path, SHEET, lambda xml: xml.replace('ref="A1:B2"', 'ref="A1:A1"'))
    assert read_workbook(path).rows[0].cells == ("7", "1")
    assert load_workbook(path).active["B2"].value == "1"


def test_only_who_reads_a_workbook_loads_what_reads_it() -> None:
    program = "import sys, kinegrade.exam.generating.generate; print('openpyxl' in sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", program],
        capture_output=True,
        text=True,
        check=True,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
    )
    assert done.stdout == "False\n"


def test_merged_cells_below_the_header_are_told_and_titles_above_it_are_not(tmp_path: Path) -> None:
    book = Workbook()
    sheet = book.active
    assert sheet is not None
    for row in (["A class", None], ["student", "q1.v_B"], ["007", "1.5"], ["008", None], ["9", 2]):
        sheet.append(row)
    sheet.merge_cells("A1:B1")
    sheet.merge_cells("B3:B4")
    book.save(tmp_path / "merged.xlsx")
    table = read_workbook(tmp_path / "merged.xlsx", lambda cells: "student" in cells)
    assert list(map(str, table.complaints)) == [
        "merged.xlsx:4: q1.v_B: the cells B3:B4 are merged into one - what it holds counts for B3 "
        "alone; part them and fill in each"
    ]


def test_an_id_merged_with_an_empty_column_is_no_complaint(tmp_path: Path) -> None:
    book = Workbook()
    sheet = book.active
    assert sheet is not None
    for row in (["student", None, "q1.v_B"], ["007", None, "1.5"], ["008", None, "2"]):
        sheet.append(row)
    for number in (1, 2, 3):
        sheet.merge_cells(f"A{number}:B{number}")
    book.save(tmp_path / "merged.xlsx")
    table = read_workbook(tmp_path / "merged.xlsx", lambda cells: "student" in cells)
    assert table.complaints == ()
    assert [(row.cell(0), row.cell(2)) for row in table.rows] == [("007", "1.5"), ("008", "2")]


def test_a_number_shown_as_per_cent_is_read_so(tmp_path: Path) -> None:
    book = Workbook()
    sheet = book.active
    assert sheet is not None
    for number, style in (("share", "@"), (0.5, "0%"), (0.125, "0.0%"), (0.07, "0%"), (2, "0%")):
        sheet.append([number])
        sheet.cell(sheet.max_row, 1).number_format = style
    book.save(tmp_path / "share.xlsx")
    rows = read_workbook(tmp_path / "share.xlsx").rows
    assert [row.cell(0) for row in rows] == ["50%", "12.5%", "7%", "200%"]


@pytest.mark.parametrize(
    ("style", "read"),
    [
        ('0.00" km"', "1.25 km"),
        (r"0.00\ \k\m", "1.25 km"),
        ('0.0" m/s";[Red]-0.0" m/s"', "1.25 m/s"),
        ('0.00"°"', "1.25 °"),
        ('"about "0.00', "1.25"),
        (r'#,##0.00\ "€"', "1.25"),
        ("0.00E+00", "1.25"),
        ('0" m"' + ";" * 255, "1.25"),
    ],
)
def test_a_unit_that_a_cell_shows_is_read_with_it(tmp_path: Path, style: str, read: str) -> None:
    """1.25 km counted as 1.25 m, without a word."""
    written = Workbook()
    written.active.append(["q1.s"])
    written.active.append([1.25])
    written.active["A2"].number_format = style
    written.save(tmp_path / "shown.xlsx")
    (row,) = read_workbook(tmp_path / "shown.xlsx").rows
    assert row.cell(0) == read
