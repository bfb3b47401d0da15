"""Names in two files into which the same answers were typed: beside one id they are those of one
student, or two people disagree whose row it is.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from kinegrade.exam.roster.student_names import are_unlike, find_name_columns
from kinegrade.files.rows.row import Row
from kinegrade.files.tables import Complaint, Table, drop_headers
from kinegrade.grading.sheets.sheet import Part
from kinegrade.language.message import Message, Quoted


@dataclass(frozen=True)
class NamedEntries:
    """A table of answers, and the rows that its students have there."""

    table: Table
    part: Part

    def names(self) -> Mapping[str, tuple[str, Row]]:
        """By student the name in the last row, and that row; nothing where there are no names."""
        columns = find_name_columns(self.table.header)
        if not columns.places:
            return {}
        lines = {each[-1].line: student for student, each in self.part.entries.items()}
        found = ((lines.get(row.line), row) for row in drop_headers(self.table))
        return {student: (columns.written(row), row) for student, row in found if student}


def find_unlike_entries(first: NamedEntries, second: NamedEntries) -> Iterator[Complaint]:
    """A complaint for each student who has the names of two people in the two files."""
    before, columns = first.names(), find_name_columns(second.table.header)
    for student, (name, row) in second.names().items():
        other, _ = before.get(student, ("", row))
        if are_unlike(name, other):
            what = Message(
                "marking.name-in-the-other",
                here=Quoted(name),
                name=Quoted(other),
                file=first.table.file,
            )
            do = Message("marking.check-whose-row", student=Quoted(student))
            title = second.table.header[columns.places[0]]
            yield Complaint(second.table.file, row.line, title, name, what, do)
