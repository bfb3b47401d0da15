"""The folder of feedback sheets: a sheet for everybody in three kinds of file, the same bytes for the same marks, nothing for marks that are not this exam's."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest

from kinegrade.errors import ExamError, OutputError, TableError
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.reports.classes.tally import tally
from kinegrade.reports.feedback.feedback import make_feedback_sheets
from kinegrade.reports.feedback.folder import FeedbackWishes, Text, write_feedback
from kinegrade.reports.paper_record import PaperRecords
from tests.grading.feedback_sheets import HOSTILE, WORDING
from tests.grading.marked_folder import RIGHT, mark_class


def test_the_folder_holds_a_sheet_for_everybody_and_a_list(tmp_path: Path) -> None:
    exam, marks = mark_class(tmp_path, {"a/b": RIGHT, "007": ()})
    folders, wishes = (open_exam(exam), MarksFolder(marks)), FeedbackWishes("md", "en")
    written = write_feedback(*folders, tmp_path / "OUT", WORDING, wishes)
    assert (written.sheets, written.notes) == (2, ())
    listed = list(csv.DictReader((tmp_path / "OUT" / "feedback.csv").open(encoding="utf-8-sig")))
    assert [row["file"] for row in listed] == ["sheets/a%2Fb.md", "sheets/007.md"]
    assert [row for row in listed if not (tmp_path / "OUT" / row["file"]).is_file()] == []
    with pytest.raises(OutputError, match="already exists - expected a new folder"):
        write_feedback(
            open_exam(exam),
            MarksFolder(marks),
            tmp_path / "OUT",
            WORDING,
            FeedbackWishes("html", "en"),
        )
    write_feedback(
        open_exam(exam),
        MarksFolder(marks),
        tmp_path / "OUT",
        WORDING,
        FeedbackWishes("html", "zh", force=True),
    )
    assert sorted(path.name for path in (tmp_path / "OUT" / "sheets").iterdir()) == [
        "007.html",
        "a%2Fb.html",
    ]


@pytest.mark.parametrize("form", ["html", "md"])
def test_worked_solutions_lie_beside_the_sheet(tmp_path: Path, form: Text) -> None:
    exam, marks = mark_class(tmp_path, {"a/b": RIGHT})
    with pytest.raises(
        ExamError,
        match=r"solutions/a%2Fb.pdf: cannot be read .* - write them with kinegrade solutions EXAM",
    ):
        write_feedback(
            open_exam(exam),
            MarksFolder(marks),
            tmp_path / "OUT",
            WORDING,
            FeedbackWishes("html", "en", solutions=True),
        )
    assert not (tmp_path / "OUT").exists()
    (exam / "solutions").mkdir()
    (exam / "solutions" / "a%2Fb.pdf").write_bytes(b"%PDF")
    write_feedback(
        open_exam(exam),
        MarksFolder(marks),
        tmp_path / "OUT",
        WORDING,
        FeedbackWishes(form, "en", solutions=True),
    )
    assert (tmp_path / "OUT" / "sheets" / "a%2Fb-solution.pdf").read_bytes() == b"%PDF"
    assert "a%252Fb-solution.pdf" in (tmp_path / "OUT" / "sheets" / f"a%2Fb.{form}").read_text(
        encoding="utf-8"
    )


def test_the_same_marks_give_the_same_bytes(tmp_path: Path) -> None:
    exam, marks = mark_class(tmp_path, {"1": HOSTILE, "2": RIGHT})
    for name in ("A", "B"):
        write_feedback(
            open_exam(exam),
            MarksFolder(marks),
            tmp_path / name,
            WORDING,
            FeedbackWishes("html", "en"),
        )
    files = [path.relative_to(tmp_path / "A") for path in (tmp_path / "A").rglob("*.*")]
    assert len(files) == 3
    assert [
        file
        for file in files
        if (tmp_path / "A" / file).read_bytes() != (tmp_path / "B" / file).read_bytes()
    ] == []


def test_marks_of_another_exam_are_refused(tmp_path: Path) -> None:
    exam, _ = mark_class(tmp_path / "1", {"7": RIGHT})
    _, marks = mark_class(tmp_path / "2", {"8": RIGHT})
    with pytest.raises(
        ExamError,
        match='student "8" is not in exam.json and grades.csv - expected the marks of this',
    ):
        list(make_feedback_sheets(MarksFolder(marks), open_exam(exam), WORDING, "en"))
    with pytest.raises(
        ExamError, match='no paper of student "8" - expected one for every student who is marked'
    ):
        PaperRecords(open_exam(exam)).paper("8")


def test_marks_of_another_exam_with_the_same_students_are_refused_by_feedback_and_report(
    tmp_path: Path,
) -> None:
    exam, marks = mark_class(tmp_path, {"7": RIGHT}, parameters=lambda student: {"r": 0.2})
    file = marks / "marks.csv"
    file.write_text(
        file.read_text(encoding="utf-8").replace("7,q1,v_B", "7,q1,v_Z"), encoding="utf-8"
    )
    message = (
        r'key.jsonl: the paper of student "7" does not ask q1.v_Z, which was marked - expected '
        "marks made from this exam folder - name the folder by which they were made"
    )
    with pytest.raises(ExamError, match=message):
        list(make_feedback_sheets(MarksFolder(marks), open_exam(exam), WORDING, "en"))
    with pytest.raises(ExamError, match=message):
        tally(MarksFolder(marks), open_exam(exam))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("student,name\n", "no column question, ask, response"),
        (
            "HEAD\n7,q1\n",
            r"marks.csv:2: 2 cells under 10 - expected the file as kinegrade grade wrote it - "
            r"grade again",
        ),
        (
            "HEAD\n7,q1,a,1,1,m,right,much,4,\n",
            'marks.csv:2: points is "much" - expected a number of zero or more',
        ),
        (
            "HEAD\n7,q1,a,1,1,m,right,1/0,4,\n",
            'marks.csv:2: points is "1/0" - expected a number of zero',
        ),
        ('HEAD\n7,q1,a,"1"1,1,m,right,4,4,\n', "is not a CSV file in UTF-8"),
    ],
)
def test_marks_that_were_changed_by_hand_are_refused(
    tmp_path: Path, text: str, message: str
) -> None:
    head = "student,question,ask,response,read_as,unit,verdict,points,out_of,reason"
    (tmp_path / "marks.csv").write_text(text.replace("HEAD", head), encoding="utf-8")
    with pytest.raises(TableError, match=message):
        list(MarksFolder(tmp_path).answers_by_student())


def test_marks_that_are_missing_are_refused(tmp_path: Path) -> None:
    with pytest.raises(
        TableError, match=r"grades.csv: cannot be read \(No such file .* made by kinegrade grade"
    ):
        _ = MarksFolder(tmp_path).totals
    (tmp_path / "complaints.csv").write_text(
        "file,line,column,content,problem,done\na,x,,,,\n", encoding="utf-8"
    )
    with pytest.raises(
        TableError, match='complaints.csv:2: line is "x" - expected the number of a line'
    ):
        MarksFolder(tmp_path).complaints()


@pytest.mark.parametrize(
    "line", ["{", "[]", '{"student": "7"}', '{"student": "7", "questions": [{}]}']
)
def test_a_broken_key_is_told(tmp_path: Path, line: str) -> None:
    exam, marks = mark_class(tmp_path, {"7": RIGHT}, parameters=lambda student: {"r": 0.2})
    (exam / "key.jsonl").write_text(line + "\n", encoding="utf-8")
    with pytest.raises(ExamError, match=r"key.jsonl.* is broken .* - restore the exam folder"):
        list(make_feedback_sheets(MarksFolder(marks), open_exam(exam), WORDING, "en"))
    (exam / "key.jsonl").unlink()
    with pytest.raises(
        ExamError, match=r"key.jsonl: cannot be read .* - expected an exam folder made by kinegrade"
    ):
        list(make_feedback_sheets(MarksFolder(marks), open_exam(exam), WORDING, "en"))


def test_a_broken_exam_is_told(tmp_path: Path) -> None:
    exam, marks = mark_class(tmp_path, {"7": RIGHT}, parameters=lambda student: {"r": 0.2})
    (exam / "exam.json").write_text('{"students": 3}', encoding="utf-8")
    with pytest.raises(
        ExamError, match=r"exam.json: format: missing - .* - restore the exam folder"
    ):
        list(make_feedback_sheets(MarksFolder(marks), open_exam(exam), WORDING, "en"))
    (exam / "exam.json").unlink()
    with pytest.raises(ExamError, match=r"exam.json: cannot be read"):
        list(make_feedback_sheets(MarksFolder(marks), open_exam(exam), WORDING, "en"))
