"""The answer sheet: which cell is whose answer to what.

`read_sheet` is called by `grade`. Nothing that stands in the file is lost: what does not become an answer
becomes a complaint that carries it.
"""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from operator import itemgetter
from typing import NamedTuple
from unicodedata import normalize

from kinegrade.csv_writing import csv_text
from kinegrade.errors import TableError
from kinegrade.exam.roster import COLUMN_NAMES, student_key
from kinegrade.grading.key import Ask, Sitting
from kinegrade.tables import Complaint, Row, Table, header_key, shortened, trimmed

_NEEDLESS = {*COLUMN_NAMES["name"], *COLUMN_NAMES["email"], "paper"}


_ANSWER_COLUMN = re.compile(r"q[0-9]+\.\w+")  # as generate heads the answer sheet


class Entry(NamedTuple):
    """One row of a student: the responses in the order of the asks; `line` is None where the student has no row.

    `whole` is the row as it came, where the student has several.
    """

    line: int | None
    responses: tuple[str, ...]
    whole: str = ""


@dataclass(frozen=True, slots=True)
class Sheet:
    """Each student's entries by id, one or more in the order of the file; `columns` are those of the asks, as named.

    `complaints` are those that stand before it is decided which of several entries counts: see `repeated`.
    """

    file: str
    columns: tuple[str, ...]
    entries: Mapping[str, tuple[Entry, ...]]
    complaints: tuple[Complaint, ...]


@dataclass(frozen=True, slots=True)
class _Columns:
    student: int
    asks: tuple[int | None, ...]
    extra: tuple[int, ...]

    def responses(self) -> Callable[[tuple[str, ...]], tuple[str, ...]]:
        """What picks the responses from the cells of a row; what is not there is blank."""

        def one_by_one(cells: tuple[str, ...]) -> tuple[str, ...]:
            return tuple(
                [
                    cells[index] if index is not None and index < len(cells) else ""
                    for index in self.asks
                ]
            )

        places = [index for index in self.asks if index is not None]
        if len(places) < len(self.asks) or len(places) == 1:
            return one_by_one
        all_at_once, width = itemgetter(*places), max(places) + 1
        return lambda cells: all_at_once(cells) if len(cells) >= width else one_by_one(cells)


def read_sheet(table: Table, exam: Sitting) -> Sheet:
    """Finds everybody's responses.

    Raises TableError if there is no student column, no answer column, or the sheet is that of another exam.
    """
    columns = _columns(table, exam.asks)
    rows, unknown = _rows_by_student(table, columns, exam)
    responses, nothing = columns.responses(), (Entry(None, ("",) * len(exam.asks)),)
    entries = {
        student: _entries(rows[student], responses) if student in rows else nothing
        for student in exam.students
    }
    complaints = [
        *table.complaints,
        *_missing_columns(table, columns, exam.asks),
        *_extra_columns(table, columns),
        *_missing_students(table, entries),
        *unknown,
    ]
    names = (
        ask.column if index is None else table.header[index]
        for ask, index in zip(exam.asks, columns.asks, strict=True)
    )
    return Sheet(table.file, tuple(names), entries, tuple(complaints))


def _columns(table: Table, asks: Sequence[Ask]) -> _Columns:
    header = [header_key(cell) for cell in table.header]
    student = next((header.index(name) for name in COLUMN_NAMES["student"] if name in header), None)
    found = _ask_columns(table.header, asks)
    faults = []
    if student is None:
        faults.append('no column "student" - expected one with the student ids')
    if all(index is None for index in found):
        faults.append(
            f"no answer column - expected {', '.join(ask.column for ask in asks[:4])} ..."
        )
    strange = [
        cell for cell in header if _ANSWER_COLUMN.fullmatch(cell) and cell not in _keys(asks)
    ]
    if not faults and len(strange) > sum(index is not None for index in found):
        faults.append(
            f"most answer columns are not asked in this exam ({', '.join(strange[:4])} ...)"
        )
    if student is None or faults:
        raise TableError(
            *(
                f"{table.file}: {fault} - fill in the answers.csv of the exam folder"
                for fault in faults
            )
        )
    unused = (index for index in range(len(header)) if index not in {student, *found})
    return _Columns(
        student, found, tuple(index for index in unused if header[index] not in _NEEDLESS)
    )


def _keys(asks: Sequence[Ask]) -> set[str]:
    return {header_key(ask.column) for ask in asks}


def _ask_columns(header: Sequence[str], asks: Sequence[Ask]) -> tuple[int | None, ...]:
    """Exact spelling goes first, because v_A and v_a may both be asked; else case does not matter."""
    backwards = list(enumerate(header))[::-1]  # so that of two like columns the first one stays
    exact = {_exact_key(cell): index for index, cell in backwards}
    folded = {header_key(cell): index for index, cell in backwards}
    alike = Counter(header_key(ask.column) for ask in asks)

    def find(column: str) -> int | None:
        key = header_key(column)
        return exact.get(_exact_key(column), folded.get(key) if alike[key] == 1 else None)

    return tuple(find(ask.column) for ask in asks)


def _exact_key(column: str) -> str:
    return trimmed(normalize("NFKC", column))


def _rows_by_student(
    table: Table, columns: _Columns, exam: Sitting
) -> tuple[Mapping[str, Sequence[Row]], list[Complaint]]:
    known = {student_key(student): student for student in exam.students}
    rows: dict[str, list[Row]] = defaultdict(list)
    strangers = []
    for row in table.rows:
        cell = row.cell(columns.student)
        key = cell if cell in known else student_key(cell)
        if key in known:
            rows[known[key]].append(row)
        else:
            strangers.append((row, key))
    near = _near_ids(known.values()) if strangers else {}
    return rows, [
        _unknown(table, row, columns, key, near.get(_bare(key))) for row, key in strangers
    ]


def _near_ids(students: Iterable[str]) -> dict[str, str]:
    """Ids without leading zeros and case, where that still means one student."""
    near: dict[str, list[str]] = defaultdict(list)
    for student in students:
        near[_bare(student_key(student))].append(student)
    return {bare: found[0] for bare, found in near.items() if len(found) == 1}


def _bare(key: str) -> str:
    return key.casefold().lstrip("0")


def _unknown(table: Table, row: Row, columns: _Columns, key: str, likely: str | None) -> Complaint:
    problem = f'no student "{shortened(key)}" in the exam' if key else "no student id"
    hint = f'; probably "{likely}": correct the id and grade again' if key and likely else ""
    return Complaint(
        table.file,
        row.line,
        table.header[columns.student],
        _whole(row),
        problem,
        f"not graded{hint}",
    )


def _whole(row: Row) -> str:
    return csv_text([shortened(cell) for cell in row.cells], []).rstrip("\n")


def _entries(
    rows: Sequence[Row], responses: Callable[[tuple[str, ...]], tuple[str, ...]]
) -> tuple[Entry, ...]:
    if len(rows) == 1:
        (row,) = rows
        return (Entry(row.line, responses(row.cells)),)
    return tuple([Entry(row.line, responses(row.cells), _whole(row)) for row in rows])


def _missing_columns(table: Table, columns: _Columns, asks: Sequence[Ask]) -> Iterator[Complaint]:
    for ask, index in zip(asks, columns.asks, strict=True):
        if index is None:
            yield Complaint(
                table.file, None, ask.column, "", "no such column", "all its answers count as blank"
            )


def _extra_columns(table: Table, columns: _Columns) -> Iterator[Complaint]:
    for index in columns.extra:
        name = shortened(table.header[index])
        filled = [row for row in table.rows if trimmed(row.cell(index))]
        if trimmed(name):
            done = "ignored" + ("; its cells follow" if filled else "")
            yield Complaint(
                table.file,
                None,
                name,
                "",
                "not an answer column of the exam, or its second one",
                done,
            )
        for row in filled:
            content = shortened(row.cell(index))
            yield Complaint(
                table.file,
                row.line,
                name,
                content,
                "stands in a column that is ignored",
                "kept here only",
            )


def _missing_students(
    table: Table, entries: Mapping[str, tuple[Entry, ...]]
) -> Iterator[Complaint]:
    for student, (entry, *_) in entries.items():
        if entry.line is None:
            yield Complaint(
                table.file,
                None,
                "",
                student,
                f'no row for student "{student}"',
                "all answers count as blank",
            )


def repeated(file: str, entries: Sequence[Entry], counted: Entry) -> Iterator[Complaint]:
    """A complaint for each entry of a student that does not count; it carries the row."""
    answers = list(map(trimmed, counted.responses))
    for entry in entries:
        if entry is counted:
            continue
        problem = f"another row for this student stands on line {counted.line}"
        same = list(map(trimmed, entry.responses)) == answers
        done = (
            "ignored, the answers are the same"
            if same
            else f"line {counted.line} counts; this row is kept here only"
        )
        yield Complaint(file, entry.line, "", entry.whole, problem, done)
