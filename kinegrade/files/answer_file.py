"""A file of answers on its way from reading to marking: its table, and what only a download can say
about its rows.

`kinegrade.lms.responses` makes it from a download, `kinegrade.grading.sheets.sheet` reads one or
several as one class.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from kinegrade.files.tables import Complaint, Table

Sources = tuple[str, ...]  # for each answer, whose line of the key marks it; "": the student's


@dataclass(frozen=True, slots=True)
class LeftOut:
    """A row of a student of the exam that is not marked, and why; `attempted` where answers may be
    missing here.

    A student without an attempt in one file may have one in another; this is then not reported.
    """

    student: str
    complaint: Complaint
    attempted: bool


@dataclass(frozen=True)
class AnswerFile:
    """One file of answers.

    `put` maps the line of a row to the students from whose papers its questions came, for every
    column of the table but the first; other rows hold answers to the student's own paper. `lines`
    maps the line of a row to those of its single cells, likewise, where they stand on others.
    `submitted` says by line when a row was handed in, as far as the file does. `coded` are the
    students whom it had by the codes of their papers.
    """

    table: Table
    put: Mapping[int, Sources] = field(default_factory=dict)
    left_out: tuple[LeftOut, ...] = ()
    lines: Mapping[int, tuple[int, ...]] = field(default_factory=dict)
    submitted: Mapping[int, str] = field(default_factory=dict)
    coded: frozenset[str] = frozenset()
