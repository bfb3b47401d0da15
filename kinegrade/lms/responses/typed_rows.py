"""The stage between a download and the answer sheet: what was typed into which answer box, row by
row.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

import msgspec

from kinegrade.files.cell_text import shorten
from kinegrade.files.csv_writing import write_csv_text
from kinegrade.files.rows.row import Row
from kinegrade.files.tables import Complaint
from kinegrade.language.message import Message
from kinegrade.lms.responses.people import Kind

Attempts = Literal["finished", "all"]


class TypedRow(msgspec.Struct, frozen=True, gc=False):  # there are many
    """A row of the download, and its responses in the order of the columns, exactly as typed.

    `moment` sorts the attempts of a student; "" where the file is in chronological order. `right`
    are the right answers according to the download, and `texts` the texts of the questions, in the
    same order, where the download has them. `submitted` is when it was handed in, as the download
    writes it, "" where it does not.
    """

    row: Row
    responses: tuple[str, ...]
    moment: str = ""
    right: tuple[str, ...] = ()
    texts: tuple[str, ...] = ()
    submitted: str = ""


@dataclass(frozen=True, slots=True)
class NotTaken:
    """A row that is left out: the column that shows it, why, and what was done.

    `attempted` where there may be answers that the file does not have, or that are left out.
    """

    row: Row
    column: str
    problem: Message
    done: Message
    attempted: bool


@dataclass(frozen=True)
class TypedRows:
    """What a dialect makes of a download.

    `columns` are answer columns of the exam, such as q1.v_B; `sources` the indices of the
    download's columns they come from. One of the columns `people`, or of those `named` for it,
    identifies the student. `assumed` states which column was taken for what. `not_taken` are rows
    whose answers do not count. `drawn` are the groups of columns that a system draws together from
    a pool; where it is empty, each column is drawn by itself. `lines` are those of the single
    responses, by the line of their row, where each stands on its own; `by_number` is whether
    questions are named by their numbers alone.
    """

    columns: tuple[str, ...]
    sources: frozenset[int]
    rows: tuple[TypedRow, ...]
    people: tuple[int, ...]
    named: Mapping[Kind, Sequence[int]] = field(default_factory=dict)
    complaints: tuple[Complaint, ...] = ()
    assumed: tuple[Message, ...] = ()
    not_taken: tuple[NotTaken, ...] = ()
    drawn: tuple[tuple[str, ...], ...] = ()
    lines: Mapping[int, tuple[int, ...]] = field(default_factory=dict)
    by_number: bool = False


def whole(row: Row) -> str:
    """A row as a complaint shows it."""
    return write_csv_text([shorten(cell) for cell in row.cells], []).rstrip("\n")
