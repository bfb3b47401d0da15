"""The stage between a download and the answer sheet: what was typed into which answer box, row by
row.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

from kinegrade.csv_writing import csv_text
from kinegrade.lms.responses.people import Kind
from kinegrade.tables import Complaint, Row, shortened

Attempts = Literal["finished", "all"]


@dataclass(frozen=True, slots=True)
class TypedRow:
    """A row of the download, and its responses in the order of the columns exactly as typed.

    `moment` sorts the attempts of a student; "" where the order of the file is that of time.
    `right` are the answers that the download says were right, and `texts` those of the questions as
    they were put, in the same order, where it says so.
    """

    row: Row
    responses: tuple[str, ...]
    moment: str = ""
    right: tuple[str, ...] = ()
    texts: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class NotTaken:
    """A row that is not taken over: in which column that shows, why, and what was done.

    `attempted` where there may be answers that the file does not have, or that are not taken over.
    """

    row: Row
    column: str
    problem: str
    done: str
    attempted: bool


@dataclass(frozen=True)
class TypedRows:
    """What a dialect makes of a download.

    `columns` are answer columns of the exam, such as q1.v_B; `sources` the places of the download's
    columns they come from. Students stand in one of the columns `people`, or of those that are
    `named` for it. `assumed` says in words which column was taken for what. `not_taken` are rows of
    people whose answers do not count. `drawn` are the columns that a system draws as one where it
    draws from a pool; each by itself where nothing is said.
    """

    columns: tuple[str, ...]
    sources: frozenset[int]
    rows: tuple[TypedRow, ...]
    people: tuple[int, ...]
    named: Mapping[Kind, Sequence[int]] = field(default_factory=dict)
    complaints: tuple[Complaint, ...] = ()
    assumed: str = ""
    not_taken: tuple[NotTaken, ...] = ()
    drawn: tuple[tuple[str, ...], ...] = ()


def whole(row: Row) -> str:
    """A row as a complaint carries it."""
    return csv_text([shortened(cell) for cell in row.cells], []).rstrip("\n")
