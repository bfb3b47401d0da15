"""The columns of a file of marks by hand, as people and kinegrade's own files call them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from kinegrade.errors import TableError
from kinegrade.exam.roster.known_columns import list_code_columns, list_column_names
from kinegrade.exam.roster.student_names import NameColumns, find_name_columns
from kinegrade.files.cell_text import make_header_key, trim
from kinegrade.files.rows.row import Row
from kinegrade.files.tables import Table
from kinegrade.language.message import Fault, Message, Quoted, list_plainly
from kinegrade.language.spellings import list_preferred_spellings

_QUESTION = Message("marking.columns-question")
_ASK = Message("marking.columns-ask")
_POINTS = Message("marking.columns-points")
_COMMENT = Message("marking.columns-comment")
_MACHINE, _EXAM = "machine", "exam"  # which kinegrade's own files have


@dataclass(frozen=True, slots=True)
class HandColumns:
    """The places of the columns, None for those that the file does not have; one of `student` and
    `code` it has.
    """

    student: int | None
    code: int | None
    question: int
    ask: int | None
    points: int
    comment: int | None
    machine: int | None
    exam: int | None
    names: NameColumns

    def cell(self, row: Row, place: int | None) -> str:
        """A cell without blanks around it, "" where there is no such column."""
        return "" if place is None else trim(row.cell(place))

    def is_ours(self, row: Row, identity: str) -> bool:
        """Whether a row stands in a list that kinegrade wrote: in one of marks by hand, or of what
        is still open in the exam that is known so.
        """
        return self.machine is not None or self.cell(row, self.exam) == identity != ""

    def target(self, row: Row) -> str:
        """What a row marks, as it is written there."""
        parts = self.cell(row, self.question), self.cell(row, self.ask)
        return ".".join(part for part in parts if part)


def find_hand_columns(table: Table) -> HandColumns:
    """What the columns of a table are. Raises TableError naming all that are missing."""
    header = [make_header_key(cell) for cell in table.header]
    student = _find(header, list_column_names("student"))
    code = _find(header, list_code_columns())
    question, points = (
        _find(header, list_preferred_spellings(each)) for each in (_QUESTION, _POINTS)
    )
    named = {"question": question, "points": points}
    missing = [] if student is not None or code is not None else ["student"]
    missing += [name for name, place in named.items() if place is None]
    if question is None or points is None or missing:
        raise TableError(
            Fault(
                table.file,
                Message("marks.no-column", columns=list_plainly(map(Quoted, missing))),
                Message("marking.hand-columns"),
            )
        )
    ask, comment = (_find(header, list_preferred_spellings(each)) for each in (_ASK, _COMMENT))
    ask = None if ask == question else ask  # German has one word for both
    machine, exam = (_find(header, [name]) for name in (_MACHINE, _EXAM))
    names = find_name_columns(table.header)
    return HandColumns(student, code, question, ask, points, comment, machine, exam, names)


def _find(header: Sequence[str], names: Sequence[str]) -> int | None:
    """The column of the best of these names."""
    return next((header.index(name) for name in names if name in header), None)
