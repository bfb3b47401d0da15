"""Reading MARKS for an export: who handed in something, and what an exam folder adds."""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.errors import ExamError, TableError
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.lms.grades.grades import read_grades
from kinegrade.marks_folder.folder import MarksFolder
from tests.lms.marked_folder import write_exam, write_marks


def test_blanks_and_dashes_are_nothing_handed_in(tmp_path: Path) -> None:
    grades = read_grades(MarksFolder(write_marks(tmp_path)))
    assert [each.student for each in grades.students if not each.handed_in] == ["0012347"]
    assert grades.questions == ("q1", "q2")


def test_points_without_an_answer_count_as_handed_in(tmp_path: Path) -> None:
    marks = write_marks(tmp_path)  # a kept total, or full points for a void question
    text = (marks / "grades.csv").read_text(encoding="utf-8")
    (marks / "grades.csv").write_text(text.replace("0,0,0,10", "0,0,5,10"), encoding="utf-8")
    assert [each for each in read_grades(MarksFolder(marks)).students if not each.handed_in] == []


def test_an_exam_gives_title_and_addresses(tmp_path: Path) -> None:
    grades = read_grades(
        MarksFolder(write_marks(tmp_path)), open_exam(write_exam(tmp_path / "EXAM", " A\n title "))
    )
    assert grades.title == "A title"
    assert [each.email for each in grades.students][::3] == ["w1@example.invalid", ""]


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (None, r"exam.json: cannot be read \(No such file"),
        (
            "[",
            r"exam.json:1: broken JSON \(.*\) - expected an exam folder .* in JSON - restore the exam",
        ),
        (
            '{"format": 1, "students": [1]}',
            r"exam.json:1: students\[1\]: is broken \(Expected `object`",
        ),
        (
            '{"format": 1, "language": "fr", "students": []}',
            'exam.json:1: language: "fr" - expected one of de, en, zh, which this version of kinegrade '
            "knows - restore the exam folder",
        ),
        (
            '{"format": 1, "title": "x", "students": []}',
            "exam.json: language: missing - expected one of de, en, zh, which this version",
        ),
        (
            '{"format": 1, "language": "en", "questions": [{"question": "q1", "asks": [{"ask": "v",'
            ' "unit": "m/s", "points": 1}]}], "students": [{"student": "7", "name": "x"}]}',
            r'no student "0012345" \(4 of the marked class are not there\) - expected the exam by '
            r"which",
        ),
    ],
)
def test_a_damaged_or_another_exam_is_refused(
    tmp_path: Path, content: str | None, message: str
) -> None:
    if content is not None:
        (tmp_path / "exam.json").write_text(content, encoding="utf-8")
    with pytest.raises(ExamError, match=message):
        read_grades(MarksFolder(write_marks(tmp_path / "MARKS")), open_exam(tmp_path))


def test_a_total_that_is_no_number_is_refused(tmp_path: Path) -> None:
    marks = write_marks(tmp_path)
    text = (marks / "grades.csv").read_text(encoding="utf-8")
    (marks / "grades.csv").write_text(text.replace("8.25", "8,25x"), encoding="utf-8")
    with pytest.raises(TableError, match="grades.csv:2|grades.csv: .*the line has"):
        read_grades(MarksFolder(marks))
