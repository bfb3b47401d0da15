"""The class: who gets a paper.

`read_roster` is called by `generate`. Columns `student` and `name`, optionally `email`, by any of
their usual names, in any order; other columns are ignored. Ids are texts: leading zeros and case
are kept.
"""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from hashlib import sha256
from pathlib import Path
from unicodedata import normalize
from urllib.parse import quote

from kinegrade.errors import TableError
from kinegrade.language.lines import show_in_one_line
from kinegrade.tables import (
    Complaint,
    Row,
    Table,
    make_header_key,
    parse_table,
    read_table,
    shorten,
    trim,
)

COLUMN_NAMES: Mapping[str, tuple[str, ...]] = {
    "student": ("student", "id", "id number", "student id", "student number", "学号", "學號"),
    "name": ("name", "full name", "student name", "姓名"),
    "email": ("email", "e-mail", "email address", "e-mail address", "邮箱", "電子郵件"),
}
_FORMULA_SIGNS = ("=", "+", "-", "@", "\uff1d", "\uff0b", "\uff0d", "\uff20")  # full-width ones too
_REQUIRED = ("student", "name")
_LONGEST_STEM = 100
_RESERVED = re.compile(r"(?:con|prn|aux|nul|com[0-9]|lpt[0-9])(?:\.|$)", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class Student:
    """One student; `file_name` is a stem safe on every system and different from all others of the
    roster.

    `line` is where the student stands in the roster's file, 0 where there is none.
    """

    student: str
    name: str
    email: str
    file_name: str
    line: int = field(default=0, compare=False)


@dataclass(frozen=True, slots=True)
class Roster:
    """The students in the order of the file, and complaints for a person to look at; `file` is its
    name in messages.
    """

    students: tuple[Student, ...]
    complaints: tuple[Complaint, ...]
    file: str = field(default="roster", compare=False)


def read_roster(path: Path, *, odd_ids: bool = False) -> Roster:
    """Reads a roster file; raises TableError with all its faults at once.

    Ids that a spreadsheet would take for a formula are a fault too, unless `odd_ids` are wanted:
    they are keys, so they stand as they are in every table that is written.
    """
    return _make_roster(read_table(path), odd_ids=odd_ids)


def parse_roster(content: bytes, file: str, *, odd_ids: bool = False) -> Roster:
    """Reads the bytes of a roster as `read_roster` does; `file` is its name in messages. Raises
    TableError.

    >>> parse_roster(b"name,ID\\nAnn,007\\n", "roster.csv").students[0].student
    '007'
    """
    return _make_roster(parse_table(content, file), odd_ids=odd_ids)


def make_student_key(student: str) -> str:
    """An id as it is compared: surrounding blanks and full-width forms are ignored, zeros and case
    matter.

    >>> make_student_key("\\uff10\\uff10\\uff17 ")
    '007'
    """
    return trim(normalize("NFKC", student))


def make_file_names(students: Iterable[str]) -> dict[str, str]:
    """A file stem for each id: the id itself where it is plain, percent-encoded where it is not.

    No two stems are equal, not even where the file system takes upper and lower case for the same.

    >>> make_file_names(["007", "a/b", "CON"])
    {'007': '007', 'a/b': 'a%2Fb', 'CON': '%43ON'}
    """
    stems = {student: _make_stem(student) for student in students}
    alike = Counter(stem.lower() for stem in stems.values())
    return {
        student: _cut(student, _encode_capitals(stem) if alike[stem.lower()] > 1 else stem)
        for student, stem in stems.items()
    }


def _make_stem(student: str) -> str:
    stem = quote(student, safe="", errors="surrogatepass").replace("~", "%7E")
    if stem.startswith(".") or _RESERVED.match(stem):
        return f"%{ord(stem[0]):02X}{stem[1:]}"
    return stem


def _encode_capitals(stem: str) -> str:
    return re.sub(r"(%..)|([A-Z])", lambda found: found[1] or f"%{ord(found[2]):02X}", stem)


def _cut(student: str, stem: str) -> str:
    """The stem, shortened if it is long: file systems allow 255 bytes at most. The encoding never
    gives `%-`, so it stays unique.
    """
    if len(stem) <= _LONGEST_STEM:
        return stem
    digest = sha256(student.encode("utf-8", "surrogatepass")).hexdigest()[:32]
    return f"{stem[:40]}%-{digest}"


def complain_of_unprintable_id(file: str, student: Student, characters: Iterable[str]) -> Complaint:
    """The complaint about characters of an id that do not print: it cannot be typed as it stands on
    the paper.
    """
    codes = ", ".join(f"U+{ord(character):04X}" for character in sorted(set(characters)))
    whose = student.name or "a student without a name"
    problem = f"the id of {whose} has characters that do not print ({codes})"
    done = (
        "on the paper they are code points, or not visible at all; correct the id before papers "
        "are printed"
    )
    return Complaint(
        file, student.line or None, "student", show_in_one_line(student.student), problem, done
    )


def _make_roster(table: Table, *, odd_ids: bool) -> Roster:
    columns = _find_columns(table)
    faults = [*_find_empty_ids(table, columns), *_find_repeated_ids(table, columns)]
    if not odd_ids:
        faults += _find_formula_ids(table, columns)
    if not table.rows:
        faults.append(f"{table.file}: has no students - expected a line for each - add them")
    if faults:
        raise TableError(*faults)
    stems = make_file_names(trim(row.cell(columns["student"])) for row in table.rows)
    students = tuple(_read_student(row, columns, stems) for row in table.rows)
    return Roster(students, (*table.complaints, *_find_nameless(table, columns)), table.file)


def _find_columns(table: Table) -> dict[str, int]:
    """Where each column stands; of several names for one column the one first in COLUMN_NAMES
    counts.
    """
    header = [make_header_key(cell) for cell in table.header]
    found = {
        column: header.index(next(name for name in names if name in header))
        for column, names in COLUMN_NAMES.items()
        if not set(names).isdisjoint(header)
    }
    shown = ", ".join(shorten(cell) for cell in table.header)
    missing = [
        f'{table.file}: no column "{column}" - the columns here are: {shown} - name one of them '
        + " or ".join(f'"{name}"' for name in COLUMN_NAMES[column])
        for column in _REQUIRED
        if column not in found
    ]
    if missing:
        raise TableError(*missing)
    return found


def _find_empty_ids(table: Table, columns: Mapping[str, int]) -> Iterator[str]:
    for row in table.rows:
        if not trim(row.cell(columns["student"])):
            name = shorten(trim(row.cell(columns["name"])))
            yield (
                f'{table.file}:{row.line}: no student id ("{name}") - expected one on every line '
                "- add it"
            )


def _find_repeated_ids(table: Table, columns: Mapping[str, int]) -> Iterator[str]:
    lines: dict[str, list[int]] = defaultdict(list)
    for row in table.rows:
        lines[make_student_key(row.cell(columns["student"]))].append(row.line)
    for student, places in lines.items():
        if student and len(places) > 1:
            where = " and ".join(map(str, places))
            yield (
                f'{table.file}: student id "{shorten(student)}" stands on lines {where} '
                "- expected each id once - correct or delete one"
            )


def _find_formula_ids(table: Table, columns: Mapping[str, int]) -> Iterator[str]:
    for row in table.rows:
        student = trim(row.cell(columns["student"]))
        if student.startswith(_FORMULA_SIGNS):
            name = shorten(_read_name(row, columns))
            yield (
                f'{table.file}:{row.line}: student id "{shorten(student)}" ({name}) begins with '
                f"{student[0]}, so that spreadsheets take it for a formula - expected a letter or "
                "a digit first - correct it, or add --allow-odd-ids"
            )


def _read_student(row: Row, columns: Mapping[str, int], stems: Mapping[str, str]) -> Student:
    student = trim(row.cell(columns["student"]))
    email = trim(row.cell(columns["email"])) if "email" in columns else ""
    return Student(student, _read_name(row, columns), email, stems[student], row.line)


def _read_name(row: Row, columns: Mapping[str, int]) -> str:
    return " ".join(trim(row.cell(columns["name"])).split())


def _find_nameless(table: Table, columns: Mapping[str, int]) -> Iterator[Complaint]:
    for row in table.rows:
        if not _read_name(row, columns):
            student = trim(row.cell(columns["student"]))
            yield Complaint(
                table.file, row.line, "name", student, "no name", "the paper carries the id alone"
            )
