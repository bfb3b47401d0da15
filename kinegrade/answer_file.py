"""A file of answers as it goes from reading to marking: its table, and what only a download can
tell of its rows.

`kinegrade.lms.responses` makes it of a download, `kinegrade.grading.sheet` reads one or several of
them as one class.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from kinegrade.tables import Complaint, Table

Sources = tuple[str, ...]  # for each answer, whose line of the key it is marked by; "" is one's own


@dataclass(frozen=True, slots=True)
class LeftOut:
    """A row of a student of the exam that is not marked, and why; `attempted` where answers may be
    missing here.

    Somebody without an attempt in one file may have one in another; nothing is said of that then.
    """

    student: str
    complaint: Complaint
    attempted: bool


@dataclass(frozen=True)
class AnswerFile:
    """One file of answers.

    `put` says of a row, by its line, from whose paper its questions came, for every column of the
    table but the first; rows that are not there hold answers to the student's own paper.
    """

    table: Table
    put: Mapping[int, Sources] = field(default_factory=dict)
    left_out: tuple[LeftOut, ...] = ()
