"""The answer sheets of an exam: blank, safe in a spreadsheet, with names."""

from __future__ import annotations

import codecs
from pathlib import Path

from openpyxl import load_workbook

from tests.small_class import COLUMNS, STUDENTS, table


def test_the_answer_sheet_is_blank_and_runs_nothing(exam: Path) -> None:
    rows = table(exam / "answers.csv")
    assert [row["student"] for row in rows] == list(STUDENTS)
    assert [row["name"] for row in rows] == ["王伟", "O'Neil, Zoë", "'=HYPERLINK(1)", "Ann"]
    assert list(rows[0]) == ["student", "name", *COLUMNS]
    assert [
        (name, value) for row in rows for name, value in row.items() if "." in name and value != ""
    ] == []


def test_ids_keep_their_zeros_in_a_spreadsheet(exam: Path) -> None:
    sheet = load_workbook(exam / "answers.xlsx").active
    rows = [[cell.value for cell in row] for row in sheet.iter_rows()]
    own, asks = rows[1][:3], [str(name).partition(" ")[0] for name in rows[1][3:]]
    assert own == ["student", "name", "paper"]
    assert asks == list(table(exam / "answers.csv")[0])[2:]
    assert [row[0] for row in rows[2:]] == list(STUDENTS)
    assert rows[4][1] == "=HYPERLINK(1)"
    cells = [cell for row in sheet.iter_rows(min_row=2) for cell in row]
    assert {cell.data_type for cell in cells if cell.value} == {"s"}
    assert {cell.number_format for cell in cells} == {"@"}


def test_a_spreadsheet_shows_the_names_of_the_answer_sheet(exam: Path) -> None:
    assert (exam / "answers.csv").read_bytes().startswith(codecs.BOM_UTF8)
