"""A marks folder: what is written is read again, and what somebody changed in it is refused in one
way.
"""

from __future__ import annotations

from datetime import timedelta
from fractions import Fraction
from pathlib import Path

import msgspec
import pytest

from kinegrade.errors import TableError
from kinegrade.files.tables import Complaint
from kinegrade.grade_scale.scale import Scale, Step
from kinegrade.language import ENGLISH
from kinegrade.marks_folder.folder import MarksFolder, open_marks
from kinegrade.marks_folder.grade_list import GradeList
from kinegrade.marks_folder.hand_marks import HandMark
from kinegrade.marks_folder.layout import (
    ANSWERS,
    CHANGES,
    COMPLAINTS,
    FILES,
    KEPT,
    MERGED,
)
from kinegrade.marks_folder.open_questions import OpenQuestion
from kinegrade.marks_folder.rows import Grade, KeptTotal, Submission, Subtracted
from kinegrade.marks_folder.writing import MarksWriter
from tests.grading.marked_folder import RIGHT, mark_class
from tests.small_class import kinegrade

LATER = {MERGED.name, CHANGES.name}  # not of one marking

HALF = Fraction(1, 2)
ANNA = Grade("7", "=Anna, B.", (HALF, Fraction(2)), Fraction(2))
KEPT_ANNA = KeptTotal(
    *("7", "=Anna, B.", "earlier total kept"),
    *(Fraction(3), Fraction(4), Fraction(5, 2), Fraction(4), Fraction(3)),
)
SCALE = Scale((Step("=A", Fraction(2, 3), passes=True), Step("F", Fraction(0), passes=False)), "-x")
SUBTRACTED = Subtracted(
    "7", "=Anna, B.", Submission(None, None, timedelta(hours=25), 2), HALF, HALF, Fraction(1, 8)
)
COMPLAINT = Complaint("a.csv", None, "q1.v", "=1+1", "unreadable", "no points")


def test_what_is_written_is_read_again(tmp_path: Path) -> None:
    writer, folder = MarksWriter(tmp_path, ENGLISH), MarksFolder(tmp_path)
    with writer.answers() as write:
        write(b"7,q1,v,'=1,,m/s,mistake,0.5,2,,no-pole sense-reversed,\n")
        write(b'7,q2,v,"0,5",0.5,1,right,2,2,key,,policy\n')
    writer.grades(
        ("q1", "q2"),
        GradeList.of([msgspec.structs.replace(ANNA, kept=Fraction(3), grade="=A")]),
        SCALE,
    )
    writer.subtracted([SUBTRACTED])
    writer.complaints([COMPLAINT])
    writer.kept([KEPT_ANNA])
    writer.put([("7", "q1", "v", "8")])
    writer.printed({"7": ("q2", "q1")})
    writer.open([OpenQuestion("q3", HALF, ("7",))], {"7": "=Anna, B."}, {}, "0a", codes={})
    mark = HandMark("7", "q2", "v", Fraction(2), Fraction(2), "=fine", Fraction(2))
    writer.by_hand([mark])
    writer.left_out([mark])
    writer.bonus({"q2": Fraction(2)})
    writer.corrections(12)
    writer.former_ids({"07": "7"})
    writer.exam("5c0ffee5")
    writer.policy("")
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted({*FILES} - LATER)
    (total,) = open_marks(tmp_path).totals.students
    assert (total.student, total.name, total.kept) == ("7", "=Anna, B.", KEPT_ANNA)
    assert (total.grade, open_marks(tmp_path).scale) == ("=A", SCALE)
    assert open_marks(tmp_path).subtracted == {"7": SUBTRACTED}
    assert (total.points, total.total, total.out_of) == ({"q1": HALF, "q2": 2}, 3, 2)
    assert (total.percent, total.status) == (150, "marked")
    assert [(each.column, each.typed, each.points) for each in folder.answers()] == [
        ("q1.v", "=1", HALF),
        ("q2.v", "0,5", 2),
    ]
    assert [(each.mistakes, each.by_policy) for each in folder.answers()] == [
        (("no-pole", "sense-reversed"), False),
        ((), True),
    ]
    assert folder.complaints() == (COMPLAINT,)
    assert (folder.put, folder.printed) == ({"7": {"q1.v": "8"}}, {"7": ("q2", "q1")})
    assert folder.open == (OpenQuestion("q3", HALF, ("7",)),)
    assert folder.by_hand == {"7": {"q2.v": mark}}
    assert (folder.corrections, folder.exam) == (12, "5c0ffee5")
    assert folder.former_ids == {"07": "7"}


def test_files_that_not_every_folder_has_are_not_missed(tmp_path: Path) -> None:
    folder = MarksFolder(tmp_path)
    assert (folder.kept, folder.put, folder.printed, folder.open) == ({}, {}, {}, ())


def test_all_cells_that_are_no_points_are_named_at_once(tmp_path: Path) -> None:
    _, marks = mark_class(tmp_path, {"7": RIGHT, "8": RIGHT})
    grades = marks / "grades.csv"
    text = grades.read_text(encoding="utf-8")
    grades.write_text(text.replace(",9.5,9.5,", ",nine,9.5,"), encoding="utf-8")
    with pytest.raises(TableError) as caught:
        open_marks(marks)
    assert caught.value.problems == tuple(
        f'{grades}:{line}: total is "nine" - expected a number of zero or more - grade again'
        for line in (2, 3)
    )


def test_a_kept_total_that_is_no_number_is_named(tmp_path: Path) -> None:
    row = "7,Anna,3,4,2.5,4,much,earlier total kept"
    (tmp_path / KEPT.name).write_text(f"{','.join(KEPT.columns)}\n{row}\n", encoding="utf-8")
    with pytest.raises(TableError, match=r'kept.csv:2: stands is "much" - expected a number of'):
        _ = MarksFolder(tmp_path).kept


@pytest.mark.parametrize("command", ["report", "feedback"])
def test_grades_that_a_spreadsheet_saved_with_semicolons_are_read(
    tmp_path: Path, command: str
) -> None:
    exam, marks = mark_class(tmp_path, {"7": RIGHT})
    grades = marks / "grades.csv"
    grades.write_text(grades.read_text(encoding="utf-8").replace(",", ";"), encoding="utf-8")
    form = ("--format", "md") if command == "feedback" else ()
    result = kinegrade(command, exam, marks, *form, "-o", tmp_path / "OUT")
    assert (result.exit_code, (tmp_path / "OUT").exists()) == (0, True), result.stderr


@pytest.mark.parametrize("name", [ANSWERS.name, COMPLAINTS.name])
@pytest.mark.parametrize(
    ("change", "problem"),
    [
        (lambda text: None, "cannot be read"),
        (lambda text: text.replace("column,", "col,").replace("verdict,", "v,"), "no column"),
        (lambda text: f"{text}7,q1\n", "2 cells under"),
        (lambda text: f'{text}"7"x\n', "is not a CSV file in UTF-8"),
    ],
)
def test_a_file_that_was_removed_or_edited_is_one_line(
    tmp_path: Path, name: str, change: object, problem: str
) -> None:
    exam, marks = mark_class(tmp_path, {"7": RIGHT})
    changed = change((marks / name).read_text(encoding="utf-8"))  # type: ignore[operator]
    (marks / name).unlink()
    if changed is not None:
        (marks / name).write_text(changed, encoding="utf-8")
    result = kinegrade("report", exam, marks, "-o", tmp_path / "report.html")
    assert (result.exit_code, result.stderr.count("\n")) == (2, 1)
    assert result.stderr.startswith(f"error: {marks / name}")
    assert problem in result.stderr
    assert result.stderr.endswith((" - grade again\n", " - check the name\n"))


def test_no_output_replaces_a_file_of_a_marks_folder(tmp_path: Path) -> None:
    exam, marks = mark_class(tmp_path, {"7": RIGHT})
    for name in FILES:
        (marks / name).touch()
        result = kinegrade("sharing", exam, marks, "-o", marks / name, "--force")
        assert result.exit_code == 2
        assert f"{name}: is a part of the MARKS folder MARKS, which would be lost" in result.stderr
