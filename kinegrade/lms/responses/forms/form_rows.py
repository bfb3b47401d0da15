"""What all forms have in common: a column for each question, one of which asks for the student's id
where the form needs no sign-in.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import cache

from kinegrade.exam.folder.records import ExamHead
from kinegrade.exam.roster.known_columns import Column, list_column_names
from kinegrade.files.cell_text import make_header_key
from kinegrade.files.tables import Table
from kinegrade.language.message import Message, Quoted
from kinegrade.language.spellings import match_spellings
from kinegrade.lms.responses.ask_headers import asks_by_name, columns_of_asks, without_derived
from kinegrade.lms.responses.people import Kind
from kinegrade.lms.responses.typed_rows import TypedRow, TypedRows

_LONGEST_TITLE = 80  # of a question for id, address or name
_TITLES: Mapping[str, Message] = {
    "id": Message("responses.titles-of-ids"),
    "email": Message("responses.titles-of-addresses"),
    "name": Message("responses.titles-of-names"),
}
_COLUMNS: Mapping[str, Column] = {"id": "student", "email": "email", "name": "name"}


def form_rows(
    table: Table,
    head: ExamHead,
    *,
    questions: Sequence[int],
    known: Mapping[Kind, Sequence[int]],
    end: int | None = None,
) -> TypedRows:
    """The responses of a form whose questions are these columns; `known` are other columns that
    identify the student, `end` is the one that says when it was sent, None where none does.

    Raises TableError where questions and asks do not agree.
    """
    questions = without_derived(table.header, questions)
    about = _find_about(table, head, questions)
    personal = {place for places in about.values() for place in places}
    columns = columns_of_asks(table, [place for place in questions if place not in personal], head)
    named: dict[Kind, Sequence[int]] = {
        "id": about["id"],
        "email": [*known["email"], *about["email"]] if "email" in known else about["email"],
    }
    rest = [place for place in questions if place not in {*columns.values(), *about["name"]}]
    times = ["" if end is None else row.cell(end) for row in table.rows]
    rows = tuple(
        TypedRow(row, tuple(map(row.cell, columns.values())), submitted=time)
        for row, time in zip(table.rows, times, strict=True)
    )
    assumed = tuple(
        Message("responses.column", columns=_show(table.header[place]), asks=column)
        for column, place in columns.items()
    )
    return TypedRows(
        tuple(columns), frozenset(columns.values()), rows, tuple(rest), named, assumed=assumed
    )


def _find_about(
    table: Table, head: ExamHead, questions: Sequence[int]
) -> Mapping[str, Sequence[int]]:
    """The questions that ask for the id, the address or the name, and for no answer."""
    taken = {
        place for places in asks_by_name(table.header, questions, head).values() for place in places
    }
    return {
        kind: [
            place
            for place in questions
            if place not in taken and _asks_for(kind, table.header[place])
        ]
        for kind in _TITLES
    }


def _asks_for(kind: str, title: str) -> bool:
    """Whether a question asks for id, address or name."""
    key = make_header_key(re.sub(r"[*?:：？_.]", " ", title[: _LONGEST_TITLE + 1]))
    if len(title) > _LONGEST_TITLE:
        return False
    return (
        key in list_column_names(_COLUMNS[kind])
        or _match_titles(_TITLES[kind]).search(key) is not None
    )


@cache
def _match_titles(titles: Message) -> re.Pattern[str]:
    """Finds one of the titles in any language; a Latin one only as whole words."""
    return re.compile(rf"(?<![a-z0-9]){match_spellings(titles)}(?![a-z0-9])")


def _show(title: str) -> Quoted:
    return Quoted(" ".join(title.split())[:60])
