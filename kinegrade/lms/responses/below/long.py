"""Answers one below the other: a line for each student and ask, in any order, by the id or by the
code of the paper. What one student handed in at one time becomes one row.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinegrade.ask_names import AskNames
from kinegrade.errors import TableError
from kinegrade.exam.folder.records import ExamHead
from kinegrade.exam.roster.student_ids import StudentIds
from kinegrade.files.cell_text import is_answered, shorten, trim
from kinegrade.files.rows.row import Row
from kinegrade.files.tables import Complaint, Table
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.lms.responses.below.attempts import LongAttempt, settle_attempts
from kinegrade.lms.responses.below.columns import (
    LongColumns,
    find_long_columns,
    find_unknown_columns,
)
from kinegrade.lms.responses.below.units import find_unit, is_no_unit, join_unit
from kinegrade.lms.responses.typed_rows import Attempts, TypedRow, TypedRows, whole

TITLE = Message("responses.long")


def recognises(header: Sequence[str]) -> bool:
    """Whether there is a column of asks and one of answers beside one that identifies the
    student.
    """
    return find_long_columns(header) is not None


def read(table: Table, head: ExamHead, attempts: Attempts) -> TypedRows:
    """A row for each student. Raises TableError where it is no such table; lines that name no ask,
    and different answers to the same one, are complained of.
    """
    columns = find_long_columns(table.header)
    if columns is None:
        raise TableError(
            Fault(
                table.file,
                Message("responses.not-long"),
                Message("responses.long-columns"),
                Message("responses.name-columns"),
            )
        )
    gathered = _Gathered(table, columns, head)
    for row in table.rows:
        gathered.take(row)
    return gathered.typed_rows()


class _Gathered:
    """The rows of a table by student, and what is wrong with some of them."""

    def __init__(self, table: Table, columns: LongColumns, head: ExamHead) -> None:
        self.table, self.columns, self.head = table, columns, head
        students = (each.student for each in head.students)
        self.ids = StudentIds(students, head.owners, head.former_ids)
        self.named = AskNames(head.columns, shuffled=True)
        self.numbered = AskNames(head.columns)
        self.by_number = False
        self.students: dict[str, dict[str, LongAttempt]] = {}
        self.complaints = [*find_unknown_columns(table, columns)]

    def take(self, row: Row) -> None:
        """One line of the table, with the unit that stands beside its answer."""
        if is_no_unit(row, self.columns):
            self._complain_of_unit(row)
        row = join_unit(row, self.columns)
        written = ".".join(filter(None, (trim(row.cell(place)) for place in self.columns.parts)))
        column = self._find_ask(written)
        if column is None:
            problem = Message("responses.no-ask", name=Quoted(shorten(written)))
            self._complain(row, problem, Message("marking.not-graded"))
            return
        attempts = self.students.setdefault(self._find_owner(row), {})
        time = "".join(trim(row.cell(place)) for place in self.columns.time)
        attempt = attempts.setdefault(time, LongAttempt(row, time))
        before = attempt.answers.setdefault(column, row)
        here, there = (trim(each.cell(self.columns.answer)) for each in (row, before))
        if not is_answered(there):
            attempt.answers[column] = row
        elif is_answered(here) and here != there:
            place = f"{self.table.file}:{before.line}"
            problem = Message(
                "responses.answered-twice",
                here=Quoted(shorten(here)),
                there=Quoted(shorten(there)),
                place=place,
            )
            self._complain(row, problem, Message("responses.first-line-counts", place=place))

    def _find_ask(self, written: str) -> str | None:
        named = self.named.find(written)
        if named is None:
            named = self.numbered.find(written)
            self.by_number = self.by_number or named is not None
        return named.column if named is not None and named.ask else None

    def _find_owner(self, row: Row) -> str:
        """Whose row it is: the student, or else what is written there."""
        places = [place for found in self.columns.people.values() for place in found]
        cells = [trim(row.cell(place)) for place in places]
        known = (self.ids.exact(cell) or self.ids.formerly(cell) for cell in cells if cell)
        return next((student for student in known if student), "\n".join(cells))

    def _complain(self, row: Row, problem: Message, done: Message) -> None:
        self.complaints.append(Complaint(self.table.file, row.line, "", whole(row), problem, done))

    def _complain_of_unit(self, row: Row) -> None:
        stated, title = find_unit(row, self.columns), self.table.header[self.columns.unit[0]]
        problem = Message("marking.no-unit", stated=Quoted(shorten(stated)))
        done = Message("marking.number-in-own-unit")
        where = self.table.file, row.line, title, shorten(stated)
        self.complaints.append(Complaint(*where, problem, done))

    def _settle(self) -> Iterator[LongAttempt]:
        """The attempts of all students; times that differ within one are complained of."""
        for attempts in self.students.values():
            for attempt in settle_attempts([*attempts.values()], self.columns.answer):
                last = attempts[attempt.time]
                self.complaints += [self._tell_other_time(each, last) for each in attempt.others]
                yield attempt

    def _tell_other_time(self, other: LongAttempt, last: LongAttempt) -> Complaint:
        """That a time is not that at which the attempt was handed in."""
        problem = Message(
            "responses.other-time",
            here=Quoted(shorten(other.time)),
            there=Quoted(shorten(last.time)),
            place=f"{self.table.file}:{last.first.line}",
        )
        done = Message("responses.one-attempt", time=shorten(last.time))
        row, column = other.first, self.table.header[self.columns.time[0]]
        return Complaint(self.table.file, row.line, column, whole(row), problem, done)

    def typed_rows(self) -> TypedRows:
        """Everything, student by student and attempt by attempt."""
        columns, answer = self.head.columns, self.columns.answer
        rows, lines = [], {}
        for attempt in self._settle():
            found = [attempt.answers.get(column) for column in columns]
            responses = tuple("" if row is None else row.cell(answer) for row in found)
            rows.append(TypedRow(attempt.first, responses, submitted=attempt.time))
            first = attempt.first.line
            lines[first] = tuple(first if row is None else row.line for row in found)
        return TypedRows(
            columns,
            frozenset({answer, *self.columns.unit}),
            tuple(rows),
            (),
            self.columns.people,
            tuple(self.complaints),
            lines=lines,
            by_number=self.by_number,
        )
