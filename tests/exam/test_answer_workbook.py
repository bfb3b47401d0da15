"""The workbook into which answers are typed: a row is found by the code of the paper or the id, units
stand in the header, what is no number is asked about; and it is read as it is, saved as CSV, too.
"""

from __future__ import annotations

import csv
import re
from pathlib import Path

import pytest
from openpyxl import load_workbook
from openpyxl.worksheet.worksheet import Worksheet

from kinegrade.exam.folder.exam_folder import open_exam
from tests.small_class import STUDENTS, asks_of, generate, kinegrade, table, write_class

MOST_CHARACTERS = 255  # that spreadsheets allow in the formula of a validation


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A class with its exam; not to be changed."""
    made = write_class(tmp_path_factory.mktemp("workbook"))
    assert generate(made).exit_code == 0
    return made


def open_sheet(exam: Path) -> Worksheet:
    """The sheet of the workbook."""
    sheet = load_workbook(exam / "answers.xlsx").active
    assert isinstance(sheet, Worksheet)
    return sheet


def test_units_stand_in_the_header_which_stays_in_sight(folder: Path) -> None:
    sheet = open_sheet(folder / "EXAM")
    header = [cell.value for cell in sheet[2]]
    assert header[:5] == ["student", "name", "paper", "q1.v_B (m/s)", "q1.a_B (m/s^2)"]
    assert sheet.freeze_panes == "D3"
    codes = [each.paper for each in open_exam(folder / "EXAM").head.students]
    assert [row[2].value for row in sheet.iter_rows(min_row=3)] == codes


def test_the_finder_looks_below_the_header_alone(folder: Path) -> None:
    sheet = open_sheet(folder / "EXAM")
    label, typed, link = sheet[1][:3]
    assert label.value == "find paper code or id:"
    assert (typed.value, typed.number_format) == (None, "@")
    formula = str(link.value)
    assert 'HYPERLINK("#D"&(2+' in formula
    areas = re.findall(r"\$([A-Z])\$([0-9]+):\$([A-Z])\$([0-9]+)", formula)
    assert {(first, row) for first, row, _, _ in areas} == {("A", "3"), ("C", "3")}
    assert formula.count("(") == formula.count(")")
    assert "*" not in formula  # with a pattern, "B" found a code that begins and ends with it
    assert (
        'MATCH(REPLACE(SUBSTITUTE(SUBSTITUTE(UPPER(TRIM($B$1)),"-","")," ",""),5,0,"-")' in formula
    )
    (area,) = sheet.conditional_formatting
    assert str(area.sqref) == "A3:I6"


def test_what_has_no_digit_is_asked_about_and_a_dash_is_not(folder: Path) -> None:
    sheet = open_sheet(folder / "EXAM")
    found = {str(each.sqref): each for each in sheet.data_validations.dataValidation}
    assert len(found) == 6
    first = found["D3:D6"]
    assert (first.errorStyle, first.promptTitle) == ("warning", "q1.v_B")
    assert first.prompt == "A number in m/s, as it is written."
    assert [each for each in found.values() if len(each.formula1) > MOST_CHARACTERS] == []
    formula = str(first.formula1)
    assert formula.startswith('OR(TRIM(D3)="-",')
    assert [digit for digit in range(10) if f'"{digit}"' not in formula] == []


def fill_in(folder: Path, path: Path) -> list[list[str]]:
    """The workbook with everybody's right answers, and a code in the finder; its cells."""
    book = load_workbook(folder / "EXAM" / "answers.xlsx")
    sheet = book.active
    assert isinstance(sheet, Worksheet)
    sheet["B1"] = "K7Q2"
    key = asks_of(folder / "EXAM")
    columns = open_exam(folder / "EXAM").head.columns
    for row in sheet.iter_rows(min_row=3):
        for cell, column in zip(row[3:], columns, strict=True):
            cell.value = str(key[str(row[0].value), column]["decimal"])
    book.save(path)
    return [["" if cell.value is None else str(cell.value) for cell in row] for row in sheet]


def test_it_is_read_as_it_is_without_a_word(folder: Path, tmp_path: Path) -> None:
    fill_in(folder, tmp_path / "filled.xlsx")
    marks = tmp_path / "MARKS"
    done = kinegrade("grade", folder / "EXAM", tmp_path / "filled.xlsx", "-o", marks)
    assert done.exit_code == 0, done.stderr
    assert done.stderr.count("\n") == 1
    assert {row["percent"] for row in table(marks / "grades.csv")} == {"100"}


@pytest.mark.parametrize("separator", [",", ";", "\t"])
def test_saved_as_csv_it_is_read_too(folder: Path, tmp_path: Path, separator: str) -> None:
    cells = fill_in(folder, tmp_path / "filled.xlsx")
    cells[0][2] = "→ 3"
    with (tmp_path / "saved.csv").open("w", encoding="utf-8", newline="") as file:
        csv.writer(file, delimiter=separator).writerows(cells)
    marks = tmp_path / "MARKS"
    done = kinegrade("grade", folder / "EXAM", tmp_path / "saved.csv", "-o", marks)
    assert done.exit_code == 0, done.stderr
    assert [row["student"] for row in table(marks / "grades.csv")] == list(STUDENTS)
    assert {row["percent"] for row in table(marks / "grades.csv")} == {"100"}


def test_a_workbook_of_another_exam_is_told_by_its_headers(folder: Path, tmp_path: Path) -> None:
    other = tmp_path / "other.csv"
    other.write_text("student,q7.x (m/s),q8.y (m),q1.v_B\n007,1,2,3\n", encoding="utf-8")
    done = kinegrade("grade", folder / "EXAM", other, "-o", tmp_path / "MARKS")
    assert done.exit_code == 2
    assert "most answer columns are not asked in this exam (q7.x, q8.y ...)" in done.stderr
