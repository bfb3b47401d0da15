"""What `kinegrade grade` wrote, read again: every marked answer, the grades and the complaints.

The class report and the feedback sheets are made of these. Columns are found by their names, so
that columns which a later version adds do no harm; cells are given as they were before they were
made safe for spreadsheets.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from itertools import groupby
from operator import attrgetter
from pathlib import Path

from kinegrade.csv_writing import restored
from kinegrade.errors import TableError
from kinegrade.exact.written import NumberError, written_number
from kinegrade.tables import Complaint, written_records

_ANSWERS = (
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
_TOTALS = ("student", "name", "total", "out_of")
_COMPLAINTS = ("file", "line", "column", "content", "problem", "done")
_PLAIN = re.compile(r"-?[0-9]{1,40}(?:\.[0-9]{1,40})?")
_MENDING = "expected the file as kinegrade grade wrote it - grade again"


@dataclass(frozen=True, slots=True)
class MarkedAnswer:
    """One line of marks.csv; `read_as` is in plain digits and in `unit`, both empty where nothing
    was read.
    """

    student: str
    question: str
    ask: str
    typed: str
    read_as: str
    unit: str
    verdict: str
    points: Fraction
    out_of: Fraction
    reason: str

    @property
    def column(self) -> str:
        """Its column in the answer sheet."""
        return f"{self.question}.{self.ask}"


@dataclass(frozen=True, slots=True)
class StudentTotal:
    """What grades.csv says of one student in all."""

    student: str
    name: str
    total: Fraction
    out_of: Fraction


def answers_by_student(folder: Path) -> Iterator[tuple[str, tuple[MarkedAnswer, ...]]]:
    """The answers of each student, in the order of the roster and of the asks; one student at a
    time.

    Raises TableError for a file that is missing or not as it was written, at the line where that is
    found.
    """
    for student, answers in groupby(marked_answers(folder), attrgetter("student")):
        yield student, tuple(answers)


def marked_answers(folder: Path) -> Iterator[MarkedAnswer]:
    """The lines of marks.csv one by one. Raises TableError as `answers_by_student` does."""
    path = folder / "marks.csv"
    for line, cells in written_records(path, _ANSWERS):
        student, question, ask, typed, read_as, unit, verdict, points, out_of, reason = cells
        yield MarkedAnswer(
            student,
            question,
            ask,
            restored(typed),
            _number(read_as, path, line),
            unit,
            verdict,
            _amount(points, path, line),
            _amount(out_of, path, line),
            restored(reason),
        )


def student_totals(folder: Path) -> dict[str, StudentTotal]:
    """The totals of grades.csv by student, in the order of the roster. Raises TableError."""
    path = folder / "grades.csv"
    return {
        student: StudentTotal(
            student, restored(name), _amount(total, path, line), _amount(out_of, path, line)
        )
        for line, (student, name, total, out_of) in written_records(path, _TOTALS)
    }


def complaints(folder: Path) -> tuple[Complaint, ...]:
    """The lines of complaints.csv. Raises TableError."""
    path = folder / "complaints.csv"
    found = []
    for line, cells in written_records(path, _COMPLAINTS):
        file, number, column, content, problem, done = map(restored, cells)
        if number and not number.isdecimal():
            raise TableError(f'{path}:{line}: line is "{number}" - {_MENDING}')
        found.append(
            Complaint(file, int(number) if number else None, column, content, problem, done)
        )
    return tuple(found)


def _number(text: str, path: Path, line: int) -> str:
    """What an answer was read as, as it stands there, if it is a number of bounded size or
    empty.
    """
    if not text or _PLAIN.fullmatch(text):
        return text
    try:
        written_number(text)
    except NumberError as fault:
        raise TableError(
            f'{path}:{line}: "{text[:40]}" stands where a number should - {_MENDING}'
        ) from fault
    return text


def _amount(text: str, path: Path, line: int) -> Fraction:
    try:
        return _fraction(text)
    except (ValueError, ZeroDivisionError) as fault:
        raise TableError(
            f'{path}:{line}: "{text[:40]}" stands where points should - {_MENDING}'
        ) from fault


@lru_cache(maxsize=4096)
def _fraction(text: str) -> Fraction:
    return written_number(text)
