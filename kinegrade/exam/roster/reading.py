"""A class from a table: who is in it, and how the table was read."""

from __future__ import annotations

import unicodedata
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from kinegrade.errors import FieldError, Problem, TableError
from kinegrade.exam.roster.cell_values import (
    read_extra_time,
    read_paper_language,
    read_print_format,
)
from kinegrade.exam.roster.columns import (
    NAMES,
    Columns,
    Wishes,
    find_columns,
    find_other_ids,
    list_unused,
)
from kinegrade.exam.roster.known_columns import Column
from kinegrade.exam.roster.mended_ids import (
    Identity,
    find_id_faults,
    find_ids_without_digits,
    find_short_ids,
    mend_ids,
)
from kinegrade.exam.roster.mended_names import mend_names
from kinegrade.exam.roster.students import Student, make_file_names
from kinegrade.exam.roster.way_of_reading import WayOfReading
from kinegrade.files.cell_text import trim
from kinegrade.files.rows.row import Row
from kinegrade.files.tables import Complaint, Table
from kinegrade.language.message import Fault, Message, Quoted, list_all

_IDEOGRAPH = "CJK UNIFIED"  # as Unicode calls the characters of Chinese names
_PARTIAL: Sequence[Column] = ("group", "room", "seat")  # strange where some students lack them


@dataclass(frozen=True, slots=True)
class ReadClass:
    """The students of a table, in its order, what a person should look at, and how it was read."""

    students: tuple[Student, ...]
    complaints: tuple[Complaint, ...]
    way: WayOfReading


def read_class(table: Table, wishes: Wishes, *, odd_ids: bool) -> ReadClass:
    """The class in a table. Raises TableError with all its faults at once."""
    columns = find_columns(table, wishes)
    rows, others = _part_students(table, columns)
    names, said_of_names = mend_names([_read_name(row, columns) for row in rows])
    ids, said_of_ids = mend_ids([trim(row.cell(columns.places["student"])) for row in rows])
    people = [
        Identity(row.line, student, name)
        for row, student, name in zip(rows, ids, names, strict=True)
    ]
    title = table.header[columns.places["student"]]
    faults: list[Problem] = [
        *find_id_faults(table, people, title, odd_ids=odd_ids),
        *_find_value_faults(table, rows, columns),
    ]
    if not rows:
        faults.append(Fault(table.file, Message("roster.no-students")))
    if faults:
        raise TableError(*faults)
    stems = make_file_names(ids)
    students = tuple(
        _read_student(row, columns, each, stems[each.student], table)
        for row, each in zip(rows, people, strict=True)
    )
    complaints = (
        *_find_complaints(table, columns),
        *find_short_ids(table, people),
        *find_ids_without_digits(table, people),
        *_find_nameless(table, people),
        *_find_partial(table, students, columns),
    )
    unused = tuple(list_unused(table, columns))
    remarks = *said_of_ids, *said_of_names
    said = (*remarks, *find_other_ids(table, columns, wishes), *_find_shared_addresses(students))
    way = WayOfReading(table, columns, unused, tuple(others), said)
    return ReadClass(students, complaints, way)


def _part_students(table: Table, columns: Columns) -> tuple[list[Row], list[Row]]:
    """The rows of students, and the others that the export of a system has."""
    system = columns.system
    if system is None:
        return list(table.rows), []
    place = next(columns.places[each] for each in NAMES if columns.has(each))
    others = [row for row in table.rows if system.not_students.fullmatch(row.cell(place))]
    return [row for row in table.rows if row not in others], others


def _read_name(row: Row, columns: Columns) -> str:
    """The name as it is printed: the first name first, but in Chinese."""
    name = columns.read(row, "name")
    if not columns.has("name"):
        return _join(columns.read(row, "first"), columns.read(row, "last"))
    last, comma, first = name.partition(",")
    if columns.system is not None and columns.system.turned and comma and "," not in first:
        return _join(first.strip(), last.strip())
    return name


def _join(first: str, last: str) -> str:
    if _is_east_asian(first) and _is_east_asian(last):
        return f"{last}{first}"
    return f"{first} {last}".strip()


def _is_east_asian(name: str) -> bool:
    """Whether a name is written without blanks, the family name first."""
    return bool(name) and all(unicodedata.name(each, "").startswith(_IDEOGRAPH) for each in name)


def _read_student(row: Row, columns: Columns, person: Identity, stem: str, table: Table) -> Student:
    title = table.header[columns.places["extra-time"]] if columns.has("extra-time") else ""
    extra = read_extra_time(columns.read(row, "extra-time"), title)
    return Student(
        person.student,
        person.name,
        columns.read(row, "email"),
        stem,
        group=columns.read(row, "group"),
        room=columns.read(row, "room"),
        seat=columns.read(row, "seat"),
        language=read_paper_language(columns.read(row, "language")) or "",
        extra_time=extra.text if extra else "",
        print_format=read_print_format(columns.read(row, "format")),
        line=row.line,
    )


def _find_value_faults(table: Table, rows: Iterable[Row], columns: Columns) -> Iterator[Problem]:
    """Cells of which it is not known what they mean, and two students on one seat."""
    taken: dict[tuple[str, str], int] = {}
    title = table.header[columns.places["extra-time"]] if columns.has("extra-time") else ""
    readers: tuple[tuple[Column, Callable[[str], object]], ...] = (
        ("language", read_paper_language),
        ("extra-time", lambda cell: read_extra_time(cell, title)),
        ("format", read_print_format),
    )
    for row in rows:
        where = f"{table.file}:{row.line}"
        for column, read in readers:
            try:
                read(columns.read(row, column))
            except FieldError as error:
                yield from (Fault(where, fault, do=_do_without(column)) for fault in error.faults)
        seat = (columns.read(row, "room"), columns.read(row, "seat"))
        if all(seat) and taken.setdefault(seat, row.line) != row.line:
            what = Message("roster.seat-taken", seat=seat[1], room=seat[0], line=taken[seat])
            yield Fault(where, what)


def _do_without(column: Column) -> Message:
    return Message("roster.do-without", column=column)


def _find_complaints(table: Table, columns: Columns) -> Iterator[Complaint]:
    """What is odd in the table, but for columns that are not used."""
    titles = {table.header[place] for place in columns.places.values()}
    return (each for each in table.complaints if not each.column or each.column in titles)


def _find_nameless(table: Table, people: Iterable[Identity]) -> Iterator[Complaint]:
    for each in people:
        if not each.name:
            problem, done = Message("roster.no-name"), Message("roster.no-name-done")
            yield Complaint(table.file, each.line, "name", each.student, problem, done)


def _find_shared_addresses(students: Sequence[Student]) -> Iterator[Message]:
    """A remark for each e-mail address of several students."""
    owners: dict[str, list[str]] = defaultdict(list)
    for each in students:
        if each.email:
            owners[each.email.casefold()].append(each.student)
    for email, several in owners.items():
        if len(several) > 1:
            whose = list_all(map(Quoted, several))
            yield Message("roster.shared-email", email=email, students=whose)


def _find_partial(
    table: Table, students: Sequence[Student], columns: Columns
) -> Iterator[Complaint]:
    """A complaint for each column that some students have nothing in."""
    values = {
        "group": [each.group for each in students],
        "room": [each.room for each in students],
        "seat": [each.seat for each in students],
    }
    for column in filter(columns.has, _PARTIAL):
        blank = [
            student for student, value in zip(students, values[column], strict=True) if not value
        ]
        if blank and len(blank) < len(students):
            problem = Message("roster.partial", count=len(blank), student=blank[0].student)
            merged = _looks_merged(values[column])
            done = Message(
                "roster.partial-done" if merged else "roster.partial-blank", line=blank[0].line
            )
            yield Complaint(table.file, None, column, "", problem, done)


def _looks_merged(values: Sequence[str]) -> bool:
    """Whether blanks are what merged cells leave: the first line of each block has the value, and
    the others nothing.
    """
    filled = [value for value in values if value]
    twice = any(value and value == after for value, after in pairwise(values))
    return bool(values[0]) and not twice and 2 * len(filled) <= len(values)
