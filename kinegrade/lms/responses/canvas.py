"""Canvas's Student Analysis of a classic quiz: two columns for each question, "12345: its text" and then its points.

The header of the points is their number and repeats, so everything goes by position. Other headers are translated,
and which of them are there depends on the rights of whoever downloaded the file.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from kinegrade.errors import TableError
from kinegrade.lms.responses.ask_headers import asks_by_name, columns_of_asks
from kinegrade.lms.responses.exam_asks import ExamAsks
from kinegrade.lms.responses.people import Kind
from kinegrade.lms.responses.typed_rows import Attempts, TypedRow, TypedRows
from kinegrade.tables import Row, Table, header_key, trimmed

TITLE = "the Student Analysis of a Canvas quiz"
_QUESTION = re.compile(r"\d+: ")
_POINTS = re.compile(r"\d+(?:\.\d+)?")
_MOMENT = re.compile(r"\d{4}-\d\d-\d\d \d\d:\d\d:\d\d UTC")


def recognises(header: Sequence[str]) -> bool:
    """Whether there are pairs of a question and its points."""
    return bool(_questions(header))


def read(table: Table, asks: ExamAsks, attempts: Attempts) -> TypedRows:
    """The responses, attempts in the order of their submission. Canvas lists none that is not submitted.

    A question of which every student has another one from a pool is found by the ask's name in its text. Raises
    TableError where questions and asks do not agree.
    """
    questions = _questions(table.header)
    if not questions:
        raise TableError(
            f'{table.file}: has no columns like "12345: text" followed by points - expected {TITLE} '
            "- download that of a classic quiz"
        )
    columns = _columns(table, questions, asks)
    people = range(1, questions[0])  # the first is the name
    rows = tuple(
        TypedRow(
            row, tuple(_response(row, places) for places in columns.values()), _moment(row, people)
        )
        for row in table.rows
    )
    assumed = "; ".join(
        f"{', '.join(table.header[place].partition(':')[0] for place in places)} is {column}"
        for column, places in columns.items()
    )
    return TypedRows(
        tuple(columns),
        frozenset(place for places in columns.values() for place in places),
        rows,
        tuple(people),
        _named(table.header, people),
        assumed=assumed,
    )


def _questions(header: Sequence[str]) -> list[int]:
    return [
        place
        for place in range(len(header) - 1)
        if _QUESTION.match(header[place]) and _POINTS.fullmatch(trimmed(header[place + 1]))
    ]


def _columns(
    table: Table, questions: Sequence[int], asks: ExamAsks
) -> Mapping[str, tuple[int, ...]]:
    named = asks_by_name(table.header, questions, asks)
    if any(len(places) > 1 for places in named.values()):
        return named
    return {column: (place,) for column, place in columns_of_asks(table, questions, asks).items()}


def _response(row: Row, places: Sequence[int]) -> str:
    """What stands in the one of these columns that the student was shown; the others are blank."""
    return next((row.cell(place) for place in places if trimmed(row.cell(place))), "")


def _moment(row: Row, people: Sequence[int]) -> str:
    return next(
        (row.cell(place) for place in people if _MOMENT.fullmatch(trimmed(row.cell(place)))), ""
    )


def _named(header: Sequence[str], people: Sequence[int]) -> Mapping[Kind, Sequence[int]]:
    """The student's id of the institution goes before Canvas's own number, which may be somebody else's id."""
    return {"id": [place for place in people if header_key(header[place]) == "sis_id"]}
