"""The class: who gets a paper.

`Roster.read` reads one. Columns `student` and `name`, optionally `email`, by any of
their usual names, in any order; other columns are ignored. Ids are texts: leading zeros and case
are kept.
"""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from hashlib import sha256
from os import PathLike
from pathlib import Path
from typing import Literal, TypeAlias, get_args
from unicodedata import normalize
from urllib.parse import quote

from kinegrade.errors import Problem, TableError
from kinegrade.files.cell_text import make_header_key, shorten, trim
from kinegrade.files.tables import Complaint, Row, Table, parse_table, read_table
from kinegrade.language.lines import show_in_one_line
from kinegrade.language.message import Fault, Message, Quoted, list_all, list_choices, list_plainly
from kinegrade.language.spellings import list_preferred_spellings

Column: TypeAlias = Literal["student", "name", "email"]
_FORMULA_SIGNS = ("=", "+", "-", "@", "\uff1d", "\uff0b", "\uff0d", "\uff20")  # full-width ones too
_REQUIRED: tuple[Column, ...] = ("student", "name")
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

    @classmethod
    def read(cls, path: str | PathLike[str], *, odd_ids: bool = False) -> Roster:
        """Reads a roster file; raises TableError with all its faults at once.

        Ids that a spreadsheet would take for a formula are a fault too, unless `odd_ids` are
        wanted: they are keys, so they stand as they are in every table that is written.

        >>> [student.name for student in Roster.read("roster.csv").students]
        ['Ann', 'Ben']
        >>> Roster.read("bank.toml")
        Traceback (most recent call last):
        kinegrade.errors.TableError: bank.toml: ...
        """
        return _make_roster(read_table(Path(path)), odd_ids=odd_ids)


def list_column_names(column: Column) -> tuple[str, ...]:
    """The names that a column may have, in small letters, the best first: those of English, then
    those of all other languages.

    >>> list_column_names("name")[:2]
    ('name', 'full name')
    """
    return list_preferred_spellings(Message(f"roster.columns-{column}"))


def parse_roster(content: bytes, file: str, *, odd_ids: bool = False) -> Roster:
    """Reads the bytes of a roster as `Roster.read` does; `file` is its name in messages. Raises
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
    if student.isascii() and student.isalnum():  # as most ids are
        return student
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
    codes = list_plainly(f"U+{ord(character):04X}" for character in sorted(set(characters)))
    whose = student.name or Message("roster.nameless")
    problem = Message("roster.unprintable-id", whose=whose, codes=codes)
    done = Message("roster.unprintable-id-done")
    return Complaint(
        file, student.line or None, "student", show_in_one_line(student.student), problem, done
    )


def _make_roster(table: Table, *, odd_ids: bool) -> Roster:
    columns = _find_columns(table)
    faults: list[Problem] = [*_find_empty_ids(table, columns), *_find_repeated_ids(table, columns)]
    if not odd_ids:
        faults += _find_formula_ids(table, columns)
    if not table.rows:
        faults.append(Fault(table.file, Message("roster.no-students")))
    if faults:
        raise TableError(*faults)
    stems = make_file_names(trim(row.cell(columns["student"])) for row in table.rows)
    students = tuple(_read_student(row, columns, stems) for row in table.rows)
    return Roster(students, (*table.complaints, *_find_nameless(table, columns)), table.file)


def _find_columns(table: Table) -> dict[Column, int]:
    """Where each column stands; of several names for one column the best counts."""
    header = [make_header_key(cell) for cell in table.header]
    columns: tuple[Column, ...] = get_args(Column)
    found = {
        column: header.index(next(name for name in names if name in header))
        for column, names in zip(columns, map(list_column_names, columns), strict=True)
        if not set(names).isdisjoint(header)
    }
    missing = [_explain_missing(table, column) for column in _REQUIRED if column not in found]
    if missing:
        raise TableError(*missing)
    return found


def _explain_missing(table: Table, column: Column) -> Fault:
    do = Message(
        "roster.name-column",
        columns=list_plainly(map(shorten, table.header)),
        names=list_choices(map(Quoted, list_column_names(column))),
    )
    return Fault(table.file, Message("roster.no-column", column=Quoted(column)), do=do)


def _find_empty_ids(table: Table, columns: Mapping[Column, int]) -> Iterator[Fault]:
    for row in table.rows:
        if not trim(row.cell(columns["student"])):
            name = Quoted(shorten(trim(row.cell(columns["name"]))))
            yield Fault(f"{table.file}:{row.line}", Message("roster.no-id", name=name))


def _find_repeated_ids(table: Table, columns: Mapping[Column, int]) -> Iterator[Fault]:
    lines: dict[str, list[int]] = defaultdict(list)
    for row in table.rows:
        lines[make_student_key(row.cell(columns["student"]))].append(row.line)
    for student, places in lines.items():
        if student and len(places) > 1:
            shown = Quoted(shorten(student))
            what = Message("roster.repeated-id", student=shown, lines=list_all(places))
            yield Fault(table.file, what)


def _find_formula_ids(table: Table, columns: Mapping[Column, int]) -> Iterator[Fault]:
    for row in table.rows:
        student = trim(row.cell(columns["student"]))
        if student.startswith(_FORMULA_SIGNS):
            what = Message(
                "roster.formula-id",
                student=Quoted(shorten(student)),
                name=shorten(_read_name(row, columns)),
                sign=student[0],
            )
            yield Fault(f"{table.file}:{row.line}", what)


def _read_student(row: Row, columns: Mapping[Column, int], stems: Mapping[str, str]) -> Student:
    student = trim(row.cell(columns["student"]))
    email = trim(row.cell(columns["email"])) if "email" in columns else ""
    return Student(student, _read_name(row, columns), email, stems[student], row.line)


def _read_name(row: Row, columns: Mapping[Column, int]) -> str:
    return " ".join(trim(row.cell(columns["name"])).split())


def _find_nameless(table: Table, columns: Mapping[Column, int]) -> Iterator[Complaint]:
    for row in table.rows:
        if not _read_name(row, columns):
            student = trim(row.cell(columns["student"]))
            problem, done = Message("roster.no-name"), Message("roster.no-name-done")
            yield Complaint(table.file, row.line, "name", student, problem, done)
