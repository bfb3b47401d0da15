"""A class's answers lead to the same marks whichever way they come in."""

from __future__ import annotations

import csv
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

from kinegrade.errors import ExamError
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.keyed_exam import read_whole
from kinegrade.files.rows.cell_grid import CellGrid
from kinegrade.files.tables import Table, read_table
from kinegrade.grading.marking import MarkingTerms, mark
from kinegrade.grading.marks import Marks
from kinegrade.grading.policy.accepted import alternatives
from kinegrade.grading.policy.policy import AS_PRINTED
from kinegrade.grading.sheets.class_sheet import read_sheet
from kinegrade.lms.responses.answer_table import read_responses
from kinegrade.lms.responses.other_paper import right_answers
from tests.lms.response_files import csv_text, workbook, write_asks
from tests.said import said
from tests.small_class import STUDENTS, asks_of

Way = Callable[[Path, dict[str, list[str]], list[str]], Path]
IDENTITY = ["姓", "名", "学号", "Email地址", "状态", "开始时间", "完成时间", "用时", "Grade/10.00"]


def typed(exam: Path) -> tuple[dict[str, list[str]], list[str]]:
    """By student what was typed into each answer box: right, wrong, blank, unreadable, with
    separators.
    """
    asks = asks_of(exam)
    columns = list(dict.fromkeys(column for _, column in asks))
    whims = ("{:.6g}", "{:.6g}", "", "=1+1", "{:.3g}; no; part 2", "{:.6g}", "about {:.4g}", "-")
    cells = {
        student: [
            whims[(3 * number + place) % len(whims)].format(float(asks[student, column]["value"]))
            for place, column in enumerate(columns)
        ]
        for number, student in enumerate(STUDENTS)
    }
    return cells, columns


def moodle(folder: Path, cells: dict[str, list[str]], columns: list[str]) -> Path:
    """One Cloze question for each mechanism, in Chinese."""
    questions = list(dict.fromkeys(column.partition(".")[0] for column in columns))
    header = [*IDENTITY, *(f"回答{number}" for number in range(1, len(questions) + 1))]
    rows = []
    for student, each in cells.items():
        slots = [
            [
                text
                for text, column in zip(each, columns, strict=True)
                if column.startswith(f"{question}.")
            ]
            for question in questions
        ]
        whole = [
            "; ".join(f"子问题 {number}：{text}" for number, text in enumerate(slot, 1))
            for slot in slots
        ]
        rows.append(
            ["王", "伟", student, "x@example.org", "完成", "x", "x", "9 分钟", "5.00", *whole]
        )
    return written(folder / "moodle.csv", header, rows)


def canvas(folder: Path, cells: dict[str, list[str]], columns: list[str]) -> Path:
    """One numerical question for each ask."""
    header = ["name", "sis_id", "submitted"]
    header += [name for number, _ in enumerate(columns) for name in (f"{number}: find it", "1.0")]
    return written(
        folder / "canvas.csv",
        header,
        [
            [
                "x",
                student,
                "2021-07-12 20:01:01 UTC",
                *(part for text in each for part in (text, "0.0")),
            ]
            for student, each in cells.items()
        ],
    )


def google(folder: Path, cells: dict[str, list[str]], columns: list[str]) -> Path:
    """The questions backwards, named by their asks."""
    header = ["Timestamp", "学号", *(f"[{column}]" for column in reversed(columns))]
    return written(
        folder / "google.csv",
        header,
        [["2026/05/01", f"#{student}", *reversed(each)] for student, each in cells.items()],
    )


def microsoft(folder: Path, cells: dict[str, list[str]], columns: list[str]) -> Path:
    """A workbook of texts, as a form writes short answers."""
    header = ["ID", "Start time", "Completion time", "Email", "Name", "Student ID"]
    header += [name for column in columns for name in (f"Find {column}", f"Points - Find {column}")]
    rows = [
        [1, "x", "x", "anonymous", "", student, *(part for text in each for part in (text, 1))]
        for student, each in cells.items()
    ]
    return workbook(folder / "microsoft.xlsx", header, *rows)


def sheet(folder: Path, cells: dict[str, list[str]], columns: list[str]) -> Path:
    """The exam's own sheet, with ids as spreadsheets protect them."""
    return written(
        folder / "sheet.csv",
        ["student", *columns],
        [[f'="{student}"', *each] for student, each in cells.items()],
    )


def written(path: Path, header: Sequence[str], rows: Sequence[Sequence[str]]) -> Path:
    path.write_text(csv_text(header, *rows), encoding="utf-8-sig")
    return path


def marked(exam: Path, table: Table) -> Marks:
    known = read_whole(open_exam(exam))
    return mark(
        known,
        read_sheet(table, known),
        MarkingTerms(AS_PRINTED, alternatives(known, AS_PRINTED, open_exam(exam))),
    )


@pytest.mark.parametrize(
    ("way", "source"),
    [
        (moodle, "moodle"),
        (canvas, "canvas"),
        (google, "google-forms"),
        (microsoft, "ms-forms"),
        (sheet, "sheet"),
    ],
)
def test_marks_are_those_of_the_answer_sheet(
    small_class: Path, tmp_path: Path, way: Way, source: str
) -> None:
    exam = small_class / "EXAM"
    cells, columns = typed(exam)
    plain = written(
        tmp_path / "answers.csv",
        ["student", *columns],
        [[who, *each] for who, each in cells.items()],
    )
    expected = marked(exam, read_table(plain))
    read = read_responses(way(tmp_path, cells, columns), open_exam(exam))
    found = marked(exam, read.table)
    assert read.source == source
    assert isinstance(read.table.rows, CellGrid)  # which is marked by columns
    assert read.table.complaints == ()
    assert [row.cells for row in read.table.rows] == [row.cells for row in read_table(plain).rows]
    assert found.grades == expected.grades
    assert found.marks == expected.marks
    assert {each.verdict.kind for each in found.marks} >= {"right", "blank", "unreadable"}


def test_the_blank_answer_sheet_of_the_exam_is_read(small_class: Path) -> None:
    read = read_responses(small_class / "EXAM" / "answers.csv", open_exam(small_class / "EXAM"))
    with (small_class / "EXAM" / "answers.csv").open(encoding="utf-8-sig", newline="") as file:
        assert [tuple(row) for row in csv.reader(file)] == [
            read.table.header,
            *(row.cells for row in read.table.rows),
        ]


def asked(exam: Path, whose: str, student: str) -> list[str]:
    """A Moodle file of one row: a student who was put somebody's paper and gave its right answers,
    as it says.
    """
    values = [
        f"{float(ask['value']):.9g}".replace(".", ",")
        for (who, _), ask in asks_of(exam).items()
        if who == whose
    ]
    return [
        "x",
        "y",
        student,
        "x@example.org",
        "Beendet",
        "x",
        "x",
        "9 Minuten",
        "5,00",
        *(cell for value in values for cell in (value, value)),
    ]


def test_the_paper_of_somebody_else_is_told_and_not_marked(
    small_class: Path, tmp_path: Path
) -> None:
    exam = small_class / "EXAM"
    names = [
        name
        for number in range(1, 7)
        for name in (f"Antwort {number}", f"Richtige Antwort {number}")
    ]
    rows = [asked(exam, "007", "007"), asked(exam, "0012", "a/b")]
    read = read_responses(
        written(tmp_path / "moodle.csv", [*IDENTITY[:-1], "Bewertung/10,00", *names], rows),
        open_exam(exam),
    )
    assert [row.cells[0] for row in read.table.rows] == ["007"]
    (complaint,) = read.table.complaints
    assert said(complaint.problem).startswith(
        'student "a/b" was given another paper: the right answer to q1.v_B is '
    )
    assert (complaint.line, said(complaint.done)) == (3, "not graded")


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (
            b"{}",
            r"key.jsonl: line 1: is broken \(Object missing required field `student`\) - expected "
            r"it as kinegrade generate wrote it",
        ),
        (None, r"key.jsonl: cannot be read \(Is a directory\) - expected an exam folder made by"),
    ],
)
def test_a_broken_key_is_told(tmp_path: Path, content: bytes | None, message: str) -> None:
    exam = open_exam(write_asks(tmp_path))
    exam.keys.file.unlink()
    if content is None:
        exam.keys.file.mkdir()
    else:
        exam.keys.file.write_bytes(content)
    with pytest.raises(ExamError, match=message):
        right_answers(exam, "S9")
