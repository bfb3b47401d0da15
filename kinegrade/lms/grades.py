"""The grades of a class as a learning management system gets them, read from the folder that
`grade` wrote.

`read_grades` is called by every export. Who handed in nothing is told apart, because an empty or
zero grade would overwrite what stands in the system. Amounts are the numbers that stand in the
files.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache
from itertools import groupby
from pathlib import Path
from types import MappingProxyType
from typing import assert_never

from kinegrade.csv_writing import restored
from kinegrade.errors import ExamError, TableError, one_line
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.language import Language
from kinegrade.lms.dialect import Field
from kinegrade.printed_order import read_printed
from kinegrade.question_numbers import bank_number
from kinegrade.tables import Row, Table, read_table, trimmed, written_records

Worth = tuple[tuple[str, str], ...]  # (question, points to be had), for each ask
TOTAL = ""  # the item that is the sum of all questions
_NOT_QUESTIONS = {"student", "name", "total", "out_of", "percent", "status"}
ABSENT = "absent"  # in the column status, which folders of earlier versions have not
_AMOUNT = re.compile(r"[0-9]{1,20}(?:\.[0-9]{1,20})?")
_DASHES = "-\u2010\u2011\u2012\u2013\u2014\u2015\u2212\uff0d"


@dataclass(frozen=True, slots=True)
class StudentGrade:
    """One student's points by question and in all (item TOTAL), and what there was to get of each.

    `name` stands as in grades.csv, neutralised against spreadsheets; `email` is empty where no exam
    was read. `printed` are the questions as they followed on the paper, empty where they did as in
    the bank.
    """

    student: str
    name: str
    email: str
    points: Mapping[str, Fraction]
    out_of: Mapping[str, Fraction]
    handed_in: bool
    printed: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class ClassGrades:
    """Everybody in the order of grades.csv; `title` is the exam's, empty where no exam was read.

    `language` is that of the papers, English where no exam was read.
    """

    questions: tuple[str, ...]
    students: tuple[StudentGrade, ...]
    title: str = ""
    language: Language = "en"

    def exported(self, *, ungraded: bool) -> tuple[StudentGrade, ...]:
        """Who gets a grade: those who handed in something, or everybody."""
        return tuple(each for each in self.students if ungraded or each.handed_in)


def known_as(grade: StudentGrade, field: Field) -> str:
    """What a system that goes by a key knows a student by: the address, or the id, which may be the
    login there.
    """
    match field:
        case "id" | "login":
            return grade.student
        case "email":
            return trimmed(grade.email)
        case _:
            assert_never(field)


def read_grades(folder: Path, exam: ExamFolder | None = None) -> ClassGrades:
    """Reads grades.csv and marks.csv of a folder; e-mails and the title from an exam folder.

    Who is absent has handed in nothing, unless an earlier total is kept; so has, in a folder of an
    earlier version that does not say who is absent, whoever answered nothing. Raises TableError for
    a folder that `grade` cannot have written, ExamError for a damaged exam.
    """
    grades = _table(folder / "grades.csv", ("student", "name", "total"))
    available, filled = _marked(folder / "marks.csv")
    kept = _kept(folder / "kept.csv")
    questions = tuple(name for name in grades.header if name not in _NOT_QUESTIONS)
    orders = read_printed(folder, questions)
    students = []
    for row in grades.rows:
        cells = {name: row.cell(place) for place, name in enumerate(grades.header)}
        student, out_of = cells["student"], dict(available.get(cells["student"], {}))
        points = {name: _amount(grades, row, name) for name in questions}
        points[TOTAL] = _amount(grades, row, "total")
        out_of[TOTAL] = sum(out_of.values(), Fraction(0))
        handed_in = (
            cells["status"] != ABSENT or student in kept
            if "status" in cells
            else student in filled or points[TOTAL] > 0
        )
        printed = orders.get(student, ())
        students.append(
            StudentGrade(student, cells["name"], "", points, out_of, handed_in, printed)
        )
    found = ClassGrades(questions, tuple(students))
    return found if exam is None else _with_exam(found, exam)


def feedback_text(grade: StudentGrade, questions: tuple[str, ...]) -> str:
    """What the system tells a student: points by the number of the question on the student's own
    paper, and nothing that the student typed.

    >>> points = {"q1": Fraction(5, 2), "q2": Fraction(0)}
    >>> out_of = {"q1": Fraction(4), "q2": Fraction(3)}
    >>> feedback_text(StudentGrade("7", "", "", points, out_of, True), ("q1", "q2"))
    '1: 2.5/4; 2: 0/3'
    >>> feedback_text(StudentGrade("7", "", "", points, out_of, True, ("q2", "q1")), ("q1", "q2"))
    '1: 0/3; 2: 2.5/4'
    """
    numbered = (
        [(str(number), name) for number, name in enumerate(grade.printed, 1)]
        if grade.printed
        else [(bank_number(name), name) for name in questions]
    )
    parts = [
        f"{number}: "
        f"{decimal_text(grade.points[name])}/{decimal_text(grade.out_of.get(name, Fraction(0)))}"
        for number, name in numbered
    ]
    return "; ".join(parts)


def decimal_text(amount: Fraction, places: int = 4) -> str:
    """The shortest decimal with a point and at most that many places, halves rounded up.

    >>> decimal_text(Fraction(2, 3)), decimal_text(Fraction(2, 3), 2), decimal_text(Fraction(1000))
    ('0.6667', '0.67', '1000')
    """
    whole, decimals = divmod((2 * amount * 10**places + 1) // 2, 10**places)
    digits = f"{decimals:0{places}d}".rstrip("0")
    return f"{whole}.{digits}" if digits else str(whole)


def _table(path: Path, columns: tuple[str, ...]) -> Table:
    table = read_table(path)
    missing = [name for name in columns if name not in table.header]
    if missing or table.complaints:
        problems = [*(f"no column {name}" for name in missing), *map(str, table.complaints)]
        raise TableError(
            f"{path}: {'; '.join(problems)} - expected the file as kinegrade grade wrote it - "
            "grade again"
        )
    return table


def _kept(path: Path) -> set[str]:
    """Whose earlier total stands."""
    if not path.exists():
        return set()
    return {student for _, (student, _) in written_records(path, ("student", "stands"))}


def _amount(table: Table, row: Row, name: str) -> Fraction:
    cell = row.cell(table.header.index(name))
    if _AMOUNT.fullmatch(cell):
        return Fraction(cell)
    raise _no_amount(f"{table.file}:{row.line}", name, cell)


def _no_amount(place: str, name: str, cell: str) -> TableError:
    return TableError(
        f'{place}: {name} is "{one_line(cell[:40])}" - expected a number - grade again'
    )


def _marked(path: Path) -> tuple[Mapping[str, Mapping[str, Fraction]], set[str]]:
    """The points each student could get in each question, and who wrote something besides blanks
    and dashes.
    """
    worth: dict[str, Worth] = defaultdict(tuple)
    same: dict[Worth, Worth] = {}  # so that it is kept once for a class
    filled: set[str] = set()
    records = written_records(path, ("student", "question", "response", "out_of"))
    for student, lines in groupby(records, lambda record: record[1][0]):
        found: Worth = ()
        for line, (_, question, response, out_of) in lines:
            if not _AMOUNT.fullmatch(out_of):
                raise _no_amount(f"{path.name}:{line}", "out_of", out_of)
            found = (*found, (question, out_of))
            if student not in filled and trimmed(restored(response)).strip(f"{_DASHES} "):
                filled.add(student)
        found = worth[student] + found
        worth[student] = same.setdefault(found, found)
    return {student: _available(parts) for student, parts in worth.items()}, filled


@lru_cache(maxsize=64)  # mostly the same for everybody
def _available(worth: Worth) -> Mapping[str, Fraction]:
    available: dict[str, Fraction] = defaultdict(Fraction)
    for question, out_of in worth:
        available[question] += Fraction(out_of)
    return MappingProxyType(dict(available))


def _with_exam(grades: ClassGrades, exam: ExamFolder) -> ClassGrades:
    candidates = exam.head.candidates
    strangers = [each.student for each in grades.students if each.student not in candidates]
    if strangers:
        raise ExamError(
            f'{exam.head_file}: no student "{strangers[0]}" ({len(strangers)} of the marked class '
            "are not there) - expected the exam by which these marks were made - name that folder"
        )
    return replace(
        grades,
        title=" ".join(exam.head.title.split()),
        language=exam.language,
        students=tuple(
            replace(each, email=trimmed(candidates[each.student].email)) for each in grades.students
        ),
    )
