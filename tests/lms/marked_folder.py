"""A class of four, marked: one handed in nothing. And how an export into a download is held against
it.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.files.csv_writing import write_csv_text
from kinegrade.lms.grades.cells import Cell, read_cells
from kinegrade.lms.grades.dialect import Dialect, ExportOptions
from kinegrade.lms.grades.fill_in import Filled, fill_in
from kinegrade.lms.grades.from_scratch import Fresh, new_file
from kinegrade.lms.grades.grades import ClassGrades, read_grades
from kinegrade.marks_folder.folder import MarksFolder

STUDENTS = {
    "0012345": ("王伟", "w1@example.invalid"),
    "0012346": ("O'Neil, Zoë", "W2@example.invalid"),
    "0012347": ("'=HYPERLINK(1)", "w3@example.invalid"),
    "0012348": ("Some Blank", ""),
}
POINTS = {
    "0012345": ("7", "1.25", "8.25"),
    "0012346": ("4", "0", "4"),
    "0012347": ("0", "0", "0"),
    "0012348": ("6.6667", "3", "9.6667"),
}
TYPED = {"0012345": "'=1+1", "0012346": "-", "0012347": "-", "0012348": "6"}
OUT_OF = {"q1": "7", "q2": "3"}


def write_marks(folder: Path, *, students: Mapping[str, str] | None = None) -> Path:
    """MARKS with the files that an export reads; `students` renames ids, in the order of
    STUDENTS.
    """
    folder.mkdir(parents=True, exist_ok=True)
    renamed = students or {}
    grades, marks = [], []
    for student, (name, _) in STUDENTS.items():
        who = renamed.get(student, student)
        percent = f"{10 * float(POINTS[student][-1]):.4g}"
        grades.append((who, name, *POINTS[student], "10", percent))
        for question, points in zip(OUT_OF, POINTS[student], strict=False):
            typed = TYPED[student] if question == "q2" else ("" if student == "0012347" else "1,5")
            marks.append(
                (who, question, "v_B", typed, "", "m/s", "wrong", points, OUT_OF[question], "why")
            )
    header = (
        "student",
        "question",
        "ask",
        "response",
        "read_as",
        "unit",
        "verdict",
        "points",
        "out_of",
        "reason",
    )
    texts = {
        "grades": write_csv_text(
            ("student", "name", "q1", "q2", "total", "out_of", "percent"), grades
        ),
        "marks": write_csv_text(header, marks),
        "complaints": write_csv_text(
            ("file", "line", "column", "content", "problem", "done"),
            [("a.csv", "7", "q1.v_B", "'@x", "unreadable", "no points")],
        ),
    }
    for name, text in texts.items():
        (folder / f"{name}.csv").write_text(text, encoding="utf-8", newline="")
    return folder


def write_exam(folder: Path, title: str = "Kinematics quiz", language: str = "en") -> Path:
    """An exam folder with what an export reads of it."""
    folder.mkdir(parents=True, exist_ok=True)
    head = {
        "format": 1,
        "title": title,
        "language": language,
        "questions": [
            {"question": question, "asks": [{"ask": "v_B", "unit": "m/s", "points": int(points)}]}
            for question, points in OUT_OF.items()
        ],
        "students": [
            {"student": student, "name": name, "email": email}
            for student, (name, email) in STUDENTS.items()
        ],
    }
    text = json.dumps(head)
    (folder / "exam.json").write_text(text, encoding="utf-8")
    return folder


def grades_of(folder: Path) -> ClassGrades:
    """The class with titles and e-mails."""
    return read_grades(
        MarksFolder(write_marks(folder / "MARKS")), open_exam(write_exam(folder / "EXAM"))
    )


def fresh(folder: Path, dialect: Dialect, options: ExportOptions | None = None) -> Fresh:
    """A new file for the class."""
    return new_file(dialect, grades_of(folder), options or ExportOptions())


def filled(
    folder: Path, dialect: Dialect, content: bytes | str, options: ExportOptions | None = None
) -> Filled:
    """The class's grades filled into a download of these bytes; what is no grade or comment has to
    stay.
    """
    path = folder / "download.csv"
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    result = fill_in(dialect, grades_of(folder), path, options or ExportOptions())
    (folder / "filled.csv").write_bytes(result.content)
    return result


def changed(folder: Path) -> dict[tuple[int, str], str]:
    """The cells that a filling changed, by line and header; every byte between changed cells is the
    same.
    """
    before, after = read_cells(folder / "download.csv"), read_cells(folder / "filled.csv")
    cells = [
        [
            (row.line, title, cell)
            for row in table.rows
            for title, cell in zip(table.titles, row.cells, strict=True)
        ]
        for table in (before, after)
    ]
    differing = [
        (one, other) for one, other in zip(*cells, strict=True) if one[2].text != other[2].text
    ]
    rests = [
        remainder(table.text, [pair[side][2] for pair in differing])
        for side, table in enumerate((before, after))
    ]
    if rests[0] != rests[1] or before.encoding != after.encoding:
        raise ValueError("something besides cells has changed")
    return {(line, title): cell.text for _, (line, title, cell) in differing}


def remainder(text: str, cells: list[Cell]) -> list[str]:
    """What stands between the cells."""
    places = [0, *(place for cell in cells for place in (cell.start, cell.end)), len(text)]
    return [text[start:end] for start, end in zip(places[::2], places[1::2], strict=True)]
