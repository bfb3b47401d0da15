"""Canvas's Student Analysis of a classic quiz: two columns for each question, "12345: its text" and
then its points.

The header of a points column is the maximum, which repeats, so columns are found by position. Other
headers are translated, and which of them are present depends on the permissions of the person who
downloaded the file. A question whose text asks for another unit than the paper does is read in that
unit; the test student that Canvas makes up is skipped.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from kinegrade.errors import TableError
from kinegrade.exam.folder.records import ExamHead
from kinegrade.files.assumed_unit import in_unit
from kinegrade.files.cell_text import make_header_key, trim
from kinegrade.files.rows.row import Row
from kinegrade.files.tables import Table
from kinegrade.language.message import Fault, Message, list_plainly
from kinegrade.lms.responses.ask_headers import asks_by_name, columns_of_asks
from kinegrade.lms.responses.asked_units import asked_unit
from kinegrade.lms.responses.people import Kind, People
from kinegrade.lms.responses.typed_rows import Attempts, TypedRow, TypedRows

TITLE = Message("responses.canvas")
_TEST_STUDENTS = ("Student, Test", "Test Student")
_QUESTION = re.compile(r"\d+: ")
_POINTS = re.compile(r"\d+(?:\.\d+)?")
_MOMENT = re.compile(r"\d{4}-\d\d-\d\d \d\d:\d\d:\d\d UTC")


@dataclass(frozen=True, slots=True)
class _Source:
    """A column of responses, and the unit that its question asks for where that is not the
    paper's.
    """

    place: int
    unit: str


def recognises(header: Sequence[str]) -> bool:
    """Whether there are pairs of a question and its points."""
    return bool(_questions(header))


def read(table: Table, head: ExamHead, attempts: Attempts) -> TypedRows:
    """The responses, attempts in the order of their submission. Canvas lists submitted attempts
    only.

    Where every student has another variant from a pool, a question is found by the ask's name in
    its text. Raises TableError where questions and asks do not agree.
    """
    questions = _questions(table.header)
    if not questions:
        raise TableError(Fault(table.file, Message("responses.no-pairs", report=TITLE)))
    columns = _columns(table, questions, head)
    people = range(1, questions[0])  # the first is the name
    named = _named(table.header, people)
    known = People(head.students)
    rows = [row for row in table.rows if not _is_test_student(row, people, named, known)]
    sources = [_sources(table.header, column, places, head) for column, places in columns.items()]
    typed = (
        TypedRow(
            row,
            tuple(_response(row, each) for each in sources),
            _moment(row, people),
            texts=tuple(_text(table, row, places) for places in columns.values()),
            submitted=_moment(row, people),
        )
        for row in rows
    )
    return TypedRows(
        tuple(columns),
        frozenset(place for places in columns.values() for place in places),
        tuple(typed),
        tuple(people),
        named,
        assumed=tuple(_assumed(table, columns, sources, len(rows))),
    )


def _sources(
    header: Sequence[str], column: str, places: Sequence[int], head: ExamHead
) -> tuple[_Source, ...]:
    """The columns of an ask, each with the unit that its text asks for."""
    unit = head.units.get(column, "")
    return tuple(_Source(place, asked_unit(header[place], unit)) for place in places)


def _assumed(
    table: Table,
    columns: Mapping[str, Sequence[int]],
    sources: Sequence[Sequence[_Source]],
    count: int,
) -> Iterator[Message]:
    """Which column was taken for what, in which unit, and whose row was skipped."""
    for column, places in columns.items():
        numbers = list_plainly(table.header[place].partition(":")[0] for place in places)
        yield Message("responses.column", columns=numbers, asks=column)
    for column, each in zip(columns, sources, strict=True):
        units = sorted({source.unit for source in each if source.unit})
        if units:
            yield Message("responses.converted", ask=column, units=list_plainly(units))
    if count < len(table.rows):
        yield Message("responses.test-student")


def _questions(header: Sequence[str]) -> list[int]:
    return [
        place
        for place in range(len(header) - 1)
        if _QUESTION.match(header[place]) and _POINTS.fullmatch(trim(header[place + 1]))
    ]


def _columns(
    table: Table, questions: Sequence[int], head: ExamHead
) -> Mapping[str, tuple[int, ...]]:
    named = asks_by_name(table.header, questions, head)
    if any(len(places) > 1 for places in named.values()):
        return named
    return {column: (place,) for column, place in columns_of_asks(table, questions, head).items()}


def _response(row: Row, sources: Sequence[_Source]) -> str:
    """The response in the one column that the student was shown; the others are blank."""
    return next(
        (
            in_unit(row.cell(source.place), source.unit)
            for source in sources
            if trim(row.cell(source.place))
        ),
        "",
    )


def _is_test_student(
    row: Row, people: Sequence[int], named: Mapping[Kind, Sequence[int]], known: People
) -> bool:
    """Whether a row is that of Canvas's test student, and of no student of the class."""
    if trim(row.cell(0)) not in _TEST_STUDENTS:
        return False
    cells = [row.cell(place) for place in named["id"] or people]
    return not any(known.by_id(cell) or known.by_email(cell) for cell in cells)


def _text(table: Table, row: Row, places: Sequence[int]) -> str:
    """The text of the question that the student was shown, "" where that is unclear.

    It is the one with an answer; where all are blank, the one with points, even zero.
    """
    put = [place for place in places if trim(row.cell(place))] or [
        place for place in places if trim(row.cell(place + 1))
    ]
    return table.header[put[0]].partition(": ")[2] if len(put) == 1 else ""


def _moment(row: Row, people: Sequence[int]) -> str:
    return next(
        (row.cell(place) for place in people if _MOMENT.fullmatch(trim(row.cell(place)))), ""
    )


def _named(header: Sequence[str], people: Sequence[int]) -> Mapping[Kind, Sequence[int]]:
    """The institution's id comes before Canvas's internal number, which may be another student's
    id.
    """
    return {"id": [place for place in people if make_header_key(header[place]) == "sis_id"]}
