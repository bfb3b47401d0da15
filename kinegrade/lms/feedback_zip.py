"""Feedback files as a Moodle assignment takes them: one zip for the class, each file in a folder
whose name holds the number that the assignment gives to its participant.

The number stands in the assignment's grading worksheet alone, as `Participant 1234` in the
teacher's language, in the first column. Moodle reads the second and later parts of a folder's name,
between underscores, and passes over what stands before them (`mod/assign/feedback/file`, 2.3 to 5).
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from kinegrade.errors import TableError
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.records import Candidate
from kinegrade.files.cell_text import trim
from kinegrade.files.rows.row import Row
from kinegrade.files.tables import Table, read_table
from kinegrade.files.zip_package import open_package
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.lms.responses.people import People

_PARTICIPANT = re.compile(r"\D*(?P<number>[0-9]{1,12})")
_PLUGIN = "assignfeedback_file"
_BETWEEN_PARTS = re.compile(r"[_/\\:*?\"<>|\s]+")


@dataclass(frozen=True)
class Participants:
    """The numbers of the students in a Moodle assignment, and what a person should look at."""

    numbers: Mapping[str, str]
    complaints: tuple[Fault, ...]


def read_participants(exam: ExamFolder, worksheet: Path) -> Participants:
    """The numbers that an assignment's grading worksheet gives to the students of an exam, who are
    found in it by e-mail address or id. Raises TableError where it has none.
    """
    table = read_table(worksheet)
    people = People(exam.head.students)
    numbers: dict[str, str] = {}
    strangers = []
    for row in table.rows:
        found = _PARTICIPANT.fullmatch(trim(row.cell(0)))
        student = _find_student(people, row)
        if found and student is not None:
            numbers[student] = found["number"]
        else:
            strangers.append(_explain_stranger(table, row))
    if not numbers:
        what, expected = Message("feedback.no-participants"), Message("feedback.worksheet")
        raise TableError(Fault(table.file, what, expected, Message("feedback.download-worksheet")))
    missing = (each for each in exam.head.students if each.student not in numbers)
    return Participants(numbers, (*map(partial(_explain_missing, table), missing), *strangers))


def pack_feedback(
    exam: ExamFolder, numbers: Mapping[str, str], target: Path, files: Mapping[str, Sequence[Path]]
) -> None:
    """Write the zip of these files, by student; those who have no number are left out."""
    with open_package(target, force=False) as package:
        for student, several in files.items():
            if student in numbers:
                folder = _name_folder(exam.head.candidates[student], numbers[student])
                for file in several:
                    package.add(f"{folder}/{file.name}", file.read_bytes())


def _name_folder(candidate: Candidate, number: str) -> str:
    """As Moodle names the folders of its own downloads."""
    name = _BETWEEN_PARTS.sub(" ", candidate.name).strip(" .~") or "-"
    return f"{name}_{number}_{_PLUGIN}"


def _find_student(people: People, row: Row) -> str | None:
    """The student of a row, by any of its cells but the first."""
    cells = row.cells[1:]
    found = [people.by_email(cell) or people.by_id(cell) for cell in cells if trim(cell)]
    return next(filter(None, found), None)


def _explain_stranger(table: Table, row: Row) -> Fault:
    what = Message("feedback.participant-unknown", participant=Quoted(trim(row.cell(0))))
    return Fault(f"{table.file}:{row.line}", what, do=Message("feedback.gets-no-file"))


def _explain_missing(table: Table, candidate: Candidate) -> Fault:
    what = Message("feedback.no-participant", student=Quoted(candidate.student))
    return Fault(table.file, what, do=Message("feedback.gets-no-file"))
