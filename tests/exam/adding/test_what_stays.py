"""What people have typed or put into an exam folder stays when the exam grows, and marks are good."""

from __future__ import annotations

import json
import re
from pathlib import Path

from openpyxl import load_workbook

from tests.exam.adding.growing_class import CLASS, LATE, added, generate, refused
from tests.small_class import contents, kinegrade, table


def test_answers_that_were_typed_stay_and_all_are_marked(folder: Path) -> None:
    sheet = folder / "EXAM" / "answers.csv"
    text = sheet.read_text(encoding="utf-8-sig").replace(",", ";")
    sheet.write_text(re.sub("^s0;.*", 's0;Ann;0,5;"1;2";;', text, flags=re.M), encoding="utf-8")
    assert kinegrade("grade", folder / "EXAM", sheet, "-o", folder / "MARKS").exit_code in (0, 1)
    added(folder)
    rows = table(sheet)
    assert [row["student"] for row in rows] == [*CLASS, *LATE]
    assert list(rows[0].values())[2:4] == ["0,5", "1;2"]
    typed = list(rows[3].values())[2:]
    assert typed == [""] * len(typed)
    after = folder / "AFTER"
    assert kinegrade("grade", folder / "EXAM", sheet, "-o", after).exit_code in (0, 1)
    grades = {name: table(folder / name / "grades.csv") for name in ("MARKS", "AFTER")}
    assert grades["AFTER"][:3] == grades["MARKS"]
    assert {row["student"] for row in grades["AFTER"]} == {*CLASS, *LATE}


def test_marks_made_before_are_still_good(folder: Path) -> None:
    exam, marks = folder / "EXAM", folder / "MARKS"
    assert kinegrade("grade", exam, exam / "answers.csv", "-o", marks).exit_code in (0, 1)
    added(folder)
    report = kinegrade("report", exam, marks, "-o", folder / "report.html")
    assert report.exit_code == 0, report.stderr
    feedback = kinegrade("feedback", exam, marks, "-o", folder / "FEEDBACK", "--format", "md")
    assert feedback.exit_code in (0, 1), feedback.stderr
    assert "3 sheets" in feedback.stderr


def test_a_row_that_was_typed_for_a_late_student_is_not_written_twice(folder: Path) -> None:
    sheet = folder / "EXAM" / "answers.csv"
    sheet.write_text(sheet.read_text(encoding="utf-8") + "late1,Li,7\n", encoding="utf-8")
    added(folder)
    assert [row["student"] for row in table(sheet)] == [*CLASS, *LATE]
    assert table(sheet)[3]["q1.v_B"] == "7"


def test_a_sheet_that_was_moved_away_is_written_anew(folder: Path) -> None:
    (folder / "EXAM" / "answers.csv").unlink()
    added(folder)
    assert [row["student"] for row in table(folder / "EXAM" / "answers.csv")] == [*CLASS, *LATE]


def test_a_sheet_without_ids_is_refused(folder: Path) -> None:
    (folder / "EXAM" / "answers.csv").write_text("who,q1.v_B\ns0,1\n", encoding="utf-8")
    (line,) = refused(folder)
    assert line.startswith('EXAM/answers.csv: no column "student" - expected the answer sheet')


def test_answers_typed_into_the_workbook_stay(folder: Path) -> None:
    book = folder / "EXAM" / "answers.xlsx"
    filled = load_workbook(book)
    filled.active["D3"] = "1.5"
    filled.save(book)
    typed = book.read_bytes()
    result = added(folder)
    said = "answers.xlsx stays as it was typed; type the answers of "
    assert f'{said}"late1", "=2" into a new row' in result.stderr
    assert book.read_bytes() == typed
    again = generate(folder, "--force", "--accept-changes")
    assert "holds answers.xlsx, edited or added" in again.stderr


def test_what_people_put_into_the_folder_stays_and_is_known_as_theirs(folder: Path) -> None:
    template = folder / "EXAM" / "papers" / "s0.docx"
    template.write_bytes(b"a paper that a person wrote for Word")
    (folder / "EXAM" / "papers" / "notes.txt").write_text("mine", encoding="utf-8")
    before = contents(folder / "EXAM" / "papers")
    added(folder)
    after = contents(folder / "EXAM" / "papers")
    assert {name: after[name] for name in before} == before
    assert {"late1.docx", "%3D2.docx"} <= after.keys()
    head = json.loads((folder / "EXAM" / "exam.json").read_text(encoding="utf-8"))
    assert "papers/s0.docx" not in head["editable"]
