"""The spreadsheet for people: ids and answers are texts, points are numbers, and nothing is a
formula.
"""

from __future__ import annotations

import io
from pathlib import Path
from zipfile import ZipFile

import pytest
from openpyxl import load_workbook

from kinegrade.errors import TableError
from kinegrade.lms.workbook import workbook
from kinegrade.marks_folder.folder import MarksFolder
from tests.lms.marked_folder import write_marks


def test_ids_names_and_answers_are_text_cells(tmp_path: Path) -> None:
    book = load_workbook(io.BytesIO(workbook(MarksFolder(write_marks(tmp_path)))))
    assert book.sheetnames == ["grades", "marks", "complaints"]
    cells = [cell for sheet in book for row in sheet for cell in row if cell.value is not None]
    assert {cell.data_type for cell in cells} == {"s", "n"}
    grades = [[cell.value for cell in row] for row in book["grades"]]
    assert grades[1] == ["0012345", "王伟", 7, 1.25, 8.25, 10, 82.5]
    assert grades[3][1] == "=HYPERLINK(1)"  # as it was typed, and a text
    typed = [row[3] for row in book["marks"]][1:]
    assert [cell.value for cell in typed[:3]] == ["1,5", "=1+1", "1,5"]
    assert {(cell.data_type, cell.number_format) for cell in typed if cell.value} == {("s", "@")}
    assert [cell.value for cell in book["complaints"][2]] == [
        "a.csv",
        7,
        "q1.v_B",
        "@x",
        "unreadable",
        "no points",
    ]


def test_the_file_does_not_say_when_it_was_made(tmp_path: Path) -> None:
    with ZipFile(io.BytesIO(workbook(MarksFolder(write_marks(tmp_path))))) as archive:
        assert {part.date_time for part in archive.infolist()} == {(1980, 1, 1, 0, 0, 0)}
        assert archive.read("docProps/core.xml").count(b">2000-01-01T00:00:00Z<") == 2


def test_what_a_spreadsheet_cannot_hold_is_shown_otherwise(tmp_path: Path) -> None:
    marks = write_marks(tmp_path)
    path = marks / "marks.csv"
    path.write_text(
        path.read_text(encoding="utf-8").replace("why", f'"a\x07b{"x" * 40_000}"', 1),
        encoding="utf-8",
    )
    cell = load_workbook(io.BytesIO(workbook(MarksFolder(marks))))["marks"]["J2"]
    assert cell.value.startswith("a·bxx")
    assert len(cell.value) == 32_767


def test_a_missing_table_is_refused(tmp_path: Path) -> None:
    (write_marks(tmp_path) / "complaints.csv").unlink()
    with pytest.raises(TableError, match="complaints.csv: cannot be read"):
        workbook(MarksFolder(tmp_path))
