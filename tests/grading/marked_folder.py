"""Exams of any number of students, answered as a test wants and marked by the real marking."""

from __future__ import annotations

import csv
from collections.abc import Callable, Mapping, Sequence
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.grading.grade import grade
from tests.grading.small_exam import exam, paper, write_exam

COLUMNS = ("q1.v_B", "q1.omega_AB", "q2.a_B")
RIGHT = ("1.732", "0", "-0.125")
Answers = Mapping[str, Sequence[str]]  # the cells of each student, in the order of `COLUMNS`


def mark_class(
    folder: Path,
    answers: Answers,
    *,
    version: Callable[[str], str] | None = None,
    parameters: Callable[[str], Mapping[str, float]] = lambda student: {},
) -> tuple[Path, Path]:
    """(EXAM, MARKS) of a class; who has no cells hands in no row."""
    folder.mkdir(exist_ok=True)
    head = exam()
    head["students"] = [
        {
            "student": student,
            "name": f"Student {student}",
            "paper": "K7Q2",
            "email": "",
            **({"version": version(student)} if version else {}),
        }
        for student in answers
    ]
    if version:
        head["versions"] = sorted({version(student) for student in answers})
    papers = [with_parameters(paper(student), parameters(student)) for student in answers]
    write_exam(folder / "EXAM", head, papers)
    return folder / "EXAM", graded(folder, answers)


def graded(folder: Path, answers: Answers) -> Path:
    """The marks of answers to folder/EXAM."""
    with (folder / "answers.csv").open("w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream)
        writer.writerow(["student", *COLUMNS])
        writer.writerows([student, *cells] for student, cells in answers.items() if cells)
    grade(open_exam(folder / "EXAM"), folder / "answers.csv", folder / "MARKS")
    return folder / "MARKS"


def with_parameters(record: dict[str, Any], parameters: Mapping[str, float]) -> dict[str, Any]:
    """A line of key.jsonl whose first question has these numbers drawn."""
    record["questions"][0]["parameters"] = {
        name: {"exact": str(value), "value": value, "unit": "m"}
        for name, value in parameters.items()
    }
    return record


class Page(HTMLParser):
    """The tags, attributes and text of an HTML page."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: set[str] = set()
        self.attributes: list[tuple[str, str | None]] = []
        self.text = ""
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.add(tag)
        self.attributes += attrs

    def handle_data(self, data: str) -> None:
        self.text += data
