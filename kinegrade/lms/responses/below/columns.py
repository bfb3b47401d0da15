"""The columns of a table of answers one below the other, by their headers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from kinegrade.exam.roster.known_columns import (
    list_code_columns,
    list_column_names,
    list_columns_of_people,
    list_key_columns,
)
from kinegrade.files.cell_text import make_header_key, shorten, trim
from kinegrade.files.tables import Complaint, Table
from kinegrade.language.message import Message
from kinegrade.language.spellings import list_preferred_spellings
from kinegrade.lms.responses.people import Kind
from kinegrade.lms.responses.sheet import SUBMITTED

_QUESTION = Message("marking.columns-question")
_ASK = Message("marking.columns-ask")
_ANSWER = Message("marking.columns-answer")
_UNIT = Message("marking.columns-unit")


@dataclass(frozen=True, slots=True)
class LongColumns:
    """The places of the columns; `parts` are those that name the ask, the question first; `unit`
    and `time` are empty where there is no such column.
    """

    people: Mapping[Kind, Sequence[int]]
    parts: tuple[int, ...]
    answer: int
    unit: tuple[int, ...]
    time: tuple[int, ...]

    @property
    def known(self) -> frozenset[int]:
        """All that are read."""
        people = (place for places in self.people.values() for place in places)
        return frozenset((*people, *self.parts, self.answer, *self.unit, *self.time))


def find_long_columns(header: Sequence[str]) -> LongColumns | None:
    """What the columns are, None where one of asks, of answers or of students is missing."""
    keys = [make_header_key(name) for name in header]

    def find(names: Sequence[str]) -> list[int]:
        return [keys.index(name) for name in names if name in keys][:1]

    named_by = find(list_key_columns())
    codes = [place for place in find(list_code_columns()) if place not in named_by]
    people: dict[Kind, Sequence[int]] = {
        "id": named_by,
        "email": find(list_column_names("email")),
        "code": codes,
    }
    named = (find(list_preferred_spellings(each)) for each in (_QUESTION, _ASK))
    parts = tuple(dict.fromkeys(place for found in named for place in found))
    answer = find(list_preferred_spellings(_ANSWER))
    if not any(people.values()) or not parts or not answer:
        return None
    unit = find(list_preferred_spellings(_UNIT))
    return LongColumns(people, parts, answer[0], tuple(unit), tuple(find([SUBMITTED])))


def find_unknown_columns(table: Table, columns: LongColumns) -> Iterator[Complaint]:
    """One for each that is not read, with all that stands in it."""
    for place, title in enumerate(table.header):
        if place in columns.known or make_header_key(title) in list_columns_of_people():
            continue
        cells = ((row.line, row.cell(place)) for row in table.rows)
        filled = [f"{line}: {shorten(cell)}" for line, cell in cells if trim(cell)]
        if not filled and not trim(title):
            continue
        done = Message("marking.column-kept") if filled else Message("marking.ignored")
        content, what = "; ".join(filled), Message("marking.no-answer-column-here")
        yield Complaint(table.file, None, shorten(title), content, what, done)
