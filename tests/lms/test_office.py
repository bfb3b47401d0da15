"""Grades filled into the workbook of an examination office: its own cells alone change, and
whatever else the workbook holds keeps its bytes.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from zipfile import ZIP_DEFLATED, ZIP_STORED, ZipFile

import pytest
from click.testing import Result
from openpyxl import Workbook, load_workbook
from openpyxl.styles import Font, PatternFill
from openpyxl.worksheet.worksheet import Worksheet

from kinegrade.files.workbooks.sheet_reading import read_sheet_xml
from tests.lms.marked_folder import write_marks
from tests.small_class import kinegrade

SHEET = "xl/worksheets/sheet2.xml"
CELL = re.compile(rb'<c r="E[4-7]"[^>]*?(?:/>|>.*?</c>)')
Edit = Callable[[Worksheet], None]


def leave(sheet: Worksheet) -> None:
    """Nothing to change."""


def write_office(path: Path, edit: Edit = leave) -> Path:
    """A list as an office sends it: a cover sheet, titles in merged cells, ids as texts or as
    numbers, a formula beside the column to be filled, styles.
    """
    book = Workbook()
    cover = book.active
    assert cover is not None
    cover.title = "Hinweise"
    cover["A1"] = "Bitte nur die Spalte Punkte ausfüllen"
    sheet = book.create_sheet("Liste")
    sheet["A1"] = "Prüfungsliste Technische Mechanik"
    sheet.merge_cells("A1:F1")
    for place, title in enumerate(("Nr.", "Matrikelnr.", "Name", "Vorname", "Punkte", "Note"), 1):
        cell = sheet.cell(3, place, title)
        cell.font = Font(bold=True)
    for row, student in enumerate(("0012345", 12346, "0012347", "0012399"), 4):
        line = (row - 3, student, "王", "伟", None, f"=IF(E{row}>=5,4,5)")
        for place, value in enumerate(line, 1):
            sheet.cell(row, place, value)
        sheet.cell(row, 5).fill = PatternFill("solid", fgColor="FFFF00")
    sheet["B9"] = "Stand: Juli"
    edit(sheet)
    book.save(path)
    return path


def fill(folder: Path, *options: str, edit: Edit = leave) -> Result:
    """`export --into` the list of that office, into filled.xlsx."""
    office = write_office(folder / "office.xlsx", edit)
    marks = write_marks(folder / "MARKS")
    files = "--into", office, "-o", folder / "filled.xlsx", "--force"
    return kinegrade("export", marks, "--to", "xlsx", *files, *options)


def points(folder: Path) -> list[object]:
    """The column that was filled."""
    sheet = load_workbook(folder / "filled.xlsx")["Liste"]
    return [sheet.cell(row, 5).value for row in range(4, 8)]


def parts(path: Path) -> dict[str, bytes]:
    """What a workbook holds, in its order."""
    with ZipFile(path) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def test_grades_stand_beside_the_ids_and_nothing_else_changes(tmp_path: Path) -> None:
    done = fill(tmp_path, "--column", "punkte")
    assert points(tmp_path) == [8.25, 4, None, None]
    before, after = parts(tmp_path / "office.xlsx"), parts(tmp_path / "filled.xlsx")
    assert list(before) == list(after)
    assert [name for name in before if before[name] != after[name]] == [SHEET]
    assert CELL.split(before[SHEET]) == CELL.split(after[SHEET])
    sheet = load_workbook(tmp_path / "filled.xlsx")["Liste"]
    assert sheet["E4"].fill.fgColor.rgb == "00FFFF00"
    assert sheet["F4"].value == "=IF(E4>=5,4,5)"
    said = done.stderr
    assert 'students are found by "Matrikelnr."; grades into "Punkte"' in said
    assert "grades of 2 students for office.xlsx" in said
    assert "its formulas show earlier results" in said
    assert '"12346" for "0012346"' in said


def test_who_is_missing_on_either_side_is_said(tmp_path: Path) -> None:
    done = fill(tmp_path, "--column", "Punkte")
    assert done.exit_code == 1
    complaints = [line for line in done.stderr.splitlines() if line.startswith("complaint")]
    no_row, other, footer = complaints
    assert 'no row for student "0012348"' in no_row
    assert 'Liste:7: no student of the marked class has Matrikelnr. "0012399"' in other
    assert '"Stand: Juli"' in footer


def test_absent_students_are_left_alone_unless_told(tmp_path: Path) -> None:
    assert "1 handed in nothing" in fill(tmp_path, "--column", "Punkte").stderr
    fill(tmp_path, "--column", "Punkte", "--ungraded")
    assert points(tmp_path) == [8.25, 4, 0, None]


def test_points_are_scaled_to_a_maximum(tmp_path: Path) -> None:
    fill(tmp_path, "--column", "Punkte", "--maximum", "100")
    assert points(tmp_path) == [82.5, 40, None, None]


def test_points_out_of_unlike_maxima_are_not_filled_in_as_they_are(tmp_path: Path) -> None:
    marks, office = write_marks(tmp_path / "MARKS"), write_office(tmp_path / "office.xlsx")
    for name, before, after in (
        ("grades.csv", "4,0,4,10,40", "4,0,4,12,33.33"),
        ("marks.csv", "0012346,q2,v_B,-,,m/s,wrong,0,3", "0012346,q2,v_B,-,,m/s,wrong,0,5"),
    ):
        text = (marks / name).read_text(encoding="utf-8")
        assert before in text
        (marks / name).write_text(text.replace(before, after), encoding="utf-8")
    files = "--into", office, "-o", tmp_path / "filled.xlsx", "--column", "Punkte"
    refused = kinegrade("export", marks, "--to", "xlsx", *files)
    assert refused.exit_code == 2
    assert "not all students could get the same points - expected one" in refused.stderr
    kinegrade("export", marks, "--to", "xlsx", *files, "--maximum", "12")
    assert points(tmp_path)[:2] == [9.9, 4]


def test_questions_have_columns_of_their_own(tmp_path: Path) -> None:
    headers = "--per-question", "--column", "q1=Punkte", "--column", "q2=Name"
    fill(tmp_path, *headers, "--overwrite")
    sheet = load_workbook(tmp_path / "filled.xlsx")["Liste"]
    assert [(sheet.cell(row, 5).value, sheet.cell(row, 3).value) for row in (4, 5)] == [
        (7, 1.25),
        (4, 0),
    ]


def test_a_question_without_a_column_is_named(tmp_path: Path) -> None:
    said = fill(tmp_path, "--per-question", "--column", "q1=Punkte").stderr
    assert "no column is named for q2 - give each its header with --column QUESTION=HEADER" in said


def test_what_a_cell_holds_already_is_replaced_only_when_told(tmp_path: Path) -> None:
    def fill_before(sheet: Worksheet) -> None:
        sheet["E4"], sheet["E5"] = "krank", 4

    done = fill(tmp_path, "--column", "Punkte", edit=fill_before)
    assert done.exit_code == 2
    assert not (tmp_path / "filled.xlsx").exists()
    (said,) = done.stderr.splitlines()
    assert 'Liste: E4: holds "krank" already; the grade is 8.25 - look at it;' in said
    assert fill(tmp_path, "--column", "Punkte", "--overwrite", edit=fill_before).exit_code == 1
    assert points(tmp_path)[:2] == [8.25, 4]


def test_formulas_and_hidden_parts_of_merged_cells_are_never_filled(tmp_path: Path) -> None:
    done = fill(tmp_path, "--column", "Note", "--overwrite")
    assert done.exit_code == 2
    assert "F4: holds a formula, which is never overwritten - fill another column" in done.stderr
    done = fill(tmp_path, "--column", "Punkte", edit=lambda sheet: sheet.merge_cells("D4:E4"))
    assert "E4: is a hidden part of merged cells" in done.stderr


@pytest.mark.parametrize(
    ("header", "edit", "said"),
    [
        ("Pukte", leave, 'headed "Pukte"; --column names the one to fill - did you mean "Punkte"?'),
        ("", leave, 'no column above the students is headed ""'),
        ("Note", lambda sheet: sheet.cell(3, 3, "Note"), "belongs to several columns (C3, F3)"),
        ("Note", lambda sheet: sheet.merge_cells("F3:G3"), "name with --column the header of one"),
    ],
)
def test_a_header_names_one_column(tmp_path: Path, header: str, edit: Edit, said: str) -> None:
    done = fill(tmp_path, "--column", header, edit=edit)
    assert done.exit_code == 2
    assert said in done.stderr


def test_a_student_on_two_rows_gets_no_grade(tmp_path: Path) -> None:
    done = fill(tmp_path, "--column", "Punkte", edit=lambda sheet: sheet.cell(7, 2, "0012345"))
    assert points(tmp_path) == [None, 4, None, None]
    assert 'student "0012345" is found on lines 4 and 7 by Matrikelnr.' in done.stderr


def write_partners(title: str) -> Edit:
    """An edit that puts the ids of partners into column A, under a title."""

    def edit(sheet: Worksheet) -> None:
        for row, value in enumerate((title, 12346, "0012345", "0012348"), 3):
            sheet.cell(row, 1, value)

    return edit


def test_a_column_called_as_ids_are_wins_over_one_of_partners(tmp_path: Path) -> None:
    done = fill(tmp_path, "--column", "Punkte", edit=write_partners("Gruppenpartner"))
    assert points(tmp_path) == [8.25, 4, None, None]
    assert 'students are found by "Matrikelnr."' in done.stderr


def test_a_stranger_below_the_header_does_not_hide_what_a_column_is_called(tmp_path: Path) -> None:
    def edit(sheet: Worksheet) -> None:
        write_partners("Gruppenpartner")(sheet)
        for row, value in enumerate(("0999999", 12346, "0012347", "0012345"), 4):
            sheet.cell(row, 2, value)

    done = fill(tmp_path, "--column", "Punkte", edit=edit)
    assert points(tmp_path) == [None, 4, None, 8.25]
    assert 'students are found by "Matrikelnr."' in done.stderr


def test_of_two_columns_called_as_ids_are_one_has_to_be_named(tmp_path: Path) -> None:
    partners = write_partners("ID")
    done = fill(tmp_path, "--column", "Punkte", edit=partners)
    assert done.exit_code == 2
    assert not (tmp_path / "filled.xlsx").exists()
    assert (
        'Liste: several columns hold ids of the class: "ID" (column A) and "Matrikelnr." (column B)'
        " - say with --id-column HEADER which of them says whose row it is"
    ) in done.stderr
    fill(tmp_path, "--column", "Punkte", "--id-column", "matrikelnr.", edit=partners)
    assert points(tmp_path) == [8.25, 4, None, None]
    fill(tmp_path, "--column", "Punkte", "--id-column", "A", edit=partners)
    assert points(tmp_path)[:2] == [4, 8.25]
    done = fill(tmp_path, "--column", "Punkte", "--id-column", "Matrikel", edit=partners)
    assert done.exit_code == 2
    assert (
        'no column with ids of the class is called "Matrikel" - did you mean "Matrikelnr."?'
    ) in done.stderr


def test_two_columns_with_the_same_ids_say_the_same(tmp_path: Path) -> None:
    def repeat(sheet: Worksheet) -> None:
        for row, value in enumerate(("ID", "0012345", 12346, "0012347", "0012399"), 3):
            sheet.cell(row, 1, value)

    fill(tmp_path, "--column", "Punkte", edit=repeat)
    assert points(tmp_path) == [8.25, 4, None, None]


def test_a_workbook_of_another_class_is_refused(tmp_path: Path) -> None:
    def rename(sheet: Worksheet) -> None:
        for row in range(4, 8):
            sheet.cell(row, 2, f"77{row}")

    done = fill(tmp_path, "--column", "Punkte", edit=rename)
    assert done.exit_code == 2
    assert "no student of the marked class stands in this workbook - expected a column" in (
        done.stderr
    )


def test_only_workbooks_are_overwritten(tmp_path: Path) -> None:
    marks = write_marks(tmp_path / "MARKS")
    done = kinegrade("export", marks, "--to", "moodle", "-o", tmp_path / "x.csv", "--overwrite")
    assert done.exit_code == 2
    assert "--overwrite: cells of a download are filled anyway" in done.stderr


def test_a_damaged_workbook_is_refused(tmp_path: Path) -> None:
    office = write_office(tmp_path / "office.xlsx")
    broken = tmp_path / "broken.xlsx"
    with ZipFile(broken, "w") as archive:
        for name, content in parts(office).items():
            archive.writestr(name, content.replace(b"</row>", b"") if name == SHEET else content)
    marks = write_marks(tmp_path / "MARKS")
    files = "--into", broken, "-o", tmp_path / "out.xlsx", "--column", "Punkte"
    done = kinegrade("export", marks, "--to", "xlsx", *files)
    assert done.exit_code == 2
    assert "broken.xlsx" in done.stderr
    assert "Traceback" not in done.stderr


def test_parts_keep_their_place_their_date_and_how_they_are_packed(tmp_path: Path) -> None:
    office, packed = write_office(tmp_path / "office.xlsx"), tmp_path / "packed.xlsx"
    with ZipFile(packed, "w") as archive:
        archive.comment = b"of the office"
        for place, (name, content) in enumerate(parts(office).items()):
            archive.writestr(name, content, ZIP_STORED if place % 2 else ZIP_DEFLATED)
        archive.writestr("xl/vbaProject.bin", bytes(range(256)))
    marks = write_marks(tmp_path / "MARKS")
    files = "--into", packed, "-o", tmp_path / "out.xlsm", "--column", "Punkte"
    kinegrade("export", marks, "--to", "xlsx", *files)
    with ZipFile(packed) as before, ZipFile(tmp_path / "out.xlsm") as after:
        assert after.comment == before.comment
        for one, other in zip(before.infolist(), after.infolist(), strict=True):
            assert one.filename == other.filename
            assert one.date_time == other.date_time
            assert one.compress_type == other.compress_type


PREFIXED = (
    b'<?xml version="1.0"?><x:worksheet xmlns:x="main"><x:cols>'
    b'<x:col min="3" max="9" style="7"/></x:cols><x:sheetData>'
    b'<x:row><x:c t="inlineStr"><x:is><x:t>0</x:t><x:rPh><x:t>no</x:t></x:rPh>'
    b"<x:r><x:t>1&gt;</x:t></x:r></x:is></x:c>"
    b"<x:c r='D1' t='s' s='2' ><x:v>0</x:v></x:c></x:row>"
    b'<x:row r="5" s="4" customFormat="1"><x:c r="A5"/><!-- <c r="B5"> --></x:row>'
    b"</x:sheetData></x:worksheet>"
)


def test_cells_are_written_in_the_manner_of_their_sheet() -> None:
    sheet = read_sheet_xml(PREFIXED, ["shared"])
    assert {place: cell.text for place, cell in sheet.cells.items()} == {
        (1, 1): "01>",
        (1, 4): "shared",
        (5, 1): "",
    }
    written = sheet.with_values({(1, 4): "2.5", (1, 3): "1", (5, 1): "3", (5, 27): "4"})
    new = b'<x:c r="C1" s="7"><x:v>1</x:v></x:c>'
    assert written == PREFIXED.replace(
        b"<x:c r='D1' t='s' s='2' ><x:v>0</x:v></x:c>",
        new + b"<x:c r='D1' s='2'><x:v>2.5</x:v></x:c>",
    ).replace(b'<x:c r="A5"/>', b'<x:c r="A5"><x:v>3</x:v></x:c>').replace(
        b" --></x:row>", b' --><x:c r="AA5" s="4"><x:v>4</x:v></x:c></x:row>'
    )
