"""A small class marked again with marks by hand, through the command line."""

from __future__ import annotations

from pathlib import Path

from click.testing import Result

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.folder.records import Candidate
from tests.small_class import kinegrade, table

HEAD = "student,question,points,comment\n"
ADA, SOFYA = "1001", "1002"


def grade(folder: Path, *options: str | Path, marks: str = "MARKS") -> Result:
    """Mark again into the same folder."""
    place = "-o", folder / marks, "--force"
    return kinegrade("grade", folder / "EXAM", folder / "answers.csv", *place, *options)


def give(folder: Path, rows: str, *options: str | Path, name: str = "by-hand.csv") -> Result:
    """Mark again with these marks by hand."""
    file = folder / name
    file.write_text(HEAD + rows, encoding="utf-8")
    return grade(folder, "--manual", file, *options)


def totals(folder: Path, marks: str = "MARKS") -> dict[str, tuple[str, str]]:
    """Everybody's total, and what it is out of."""
    rows = table(folder / marks / "grades.csv")
    return {row["student"]: (row["total"], row["out_of"]) for row in rows}


def faults(result: Result, folder: Path) -> list[str]:
    """The lines of a refusal, without the place of the folder."""
    assert result.exit_code == 2
    return [
        line.removeprefix("error: ").replace(f"{folder}/", "")
        for line in result.stderr.splitlines()
    ]


def open_exam_students(folder: Path) -> tuple[Candidate, ...]:
    """The students of the exam with their codes."""
    return open_exam(folder / "EXAM").head.students
