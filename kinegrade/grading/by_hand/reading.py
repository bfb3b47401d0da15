"""Files of marks by hand, read: whose mark, for what, how many points, and why.

All that is wrong with them is found at once; then none of their marks counts.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path

from kinegrade.ask_names import Named
from kinegrade.exam.roster.student_ids import StudentIds
from kinegrade.files.cell_text import make_header_key, shorten
from kinegrade.files.csv_writing import restore
from kinegrade.files.rows.row import Row
from kinegrade.files.tables import Complaint, Table, drop_headers, read_table
from kinegrade.files.workbooks.inspection import is_workbook
from kinegrade.files.workbooks.spreadsheet import read_workbook
from kinegrade.grading.by_hand.columns import HandColumns, find_hand_columns
from kinegrade.grading.by_hand.hand_file import GIVE_NEW, HandFile, HandRow, Newer
from kinegrade.grading.by_hand.markable import Markable
from kinegrade.grading.by_hand.typed_points import explain_points, read_typed_points
from kinegrade.grading.same_key import is_of_another_exam
from kinegrade.language.message import Fault, Message, Quoted, Text, list_choices
from kinegrade.language.spellings import list_spellings
from kinegrade.marks_folder.hand_marks import EXTRA, HandMark
from kinegrade.numbers.amounts import write_amount
from kinegrade.question_numbers import find_bank_number


def read_hand_file(path: Path, markable: Markable, newer: Newer | None = None) -> HandFile:
    """The marks of a CSV file or workbook; where it is a list of an earlier marking, with what the
    machine gave then. Of one that is carried over only what no `newer` mark replaces is looked at.

    Raises TableError where it is no such table.
    """
    table = read_workbook(path) if is_workbook(path) else read_table(path)
    return _Reader(table, find_hand_columns(table), markable, str(path), newer).read()


@dataclass(frozen=True)
class _Reader:
    table: Table
    columns: HandColumns
    markable: Markable
    path: str
    newer: Newer | None
    found: HandFile = field(default_factory=HandFile)

    def read(self) -> HandFile:
        """All rows."""
        surplus = (each for each in self.table.complaints if each.content)
        self.found.faults.extend(map(self._explain_unread, surplus))
        rows = drop_headers(self.table)
        if self._is_of_another_exam(rows):
            what, do = Message("marking.hand-of-another-exam"), Message("marking.open-of-this-exam")
            return HandFile(faults=[Fault(self.path, what, do=do)])
        students = self._find_students(rows)
        for row in rows:
            self._read_row(row, students)
        return self.found

    def _is_of_another_exam(self, rows: Sequence[Row]) -> bool:
        """Whether rows say so that mark something, as those of our own lists do."""
        columns = self.columns
        said = (
            columns.cell(row, columns.exam) for row in rows if columns.cell(row, columns.points)
        )
        return any(is_of_another_exam(cell, self.markable.identity) for cell in said)

    def _find_students(self, rows: Sequence[Row]) -> Mapping[str, str]:
        """The students by the cells that name them: exactly, or as spreadsheets left ids."""
        ids, find = self.markable.ids, self.markable.find_student
        cells = dict.fromkeys(self.columns.cell(row, self.columns.student) for row in rows)
        exact = {cell: student for cell in cells if (student := find(cell))}
        unknown = [cell for cell in cells if cell and cell not in exact]
        self.found.restored = ids.restored(unknown, set(exact.values()))
        return {**exact, **self.found.restored}

    def _read_row(self, row: Row, students: Mapping[str, str]) -> None:
        points = self.columns.cell(row, self.columns.points)
        comment = restore(self.columns.cell(row, self.columns.comment))
        if not points and not comment:
            self.found.unmarked += 1
            return
        student = self._find_student(row, students)
        named = self._find_named(row, student)
        if student is None or named is None or self._is_replaced(student, named, points):
            return
        if not points and named.column in self.markable.by_hand:
            self.found.unmarked += 1
            self.found.comments[student, named.column] = comment
            return
        held = self._is_held(row, student, named)
        amount = None if held is None else self._read_points(row, points, named)
        if amount is None or self._is_cut(row, points, comment, named):
            return
        maximum = self.markable.maxima.get(named.column)
        before = _read_amount(self.columns.cell(row, self.columns.machine))
        mark = HandMark(
            *(student, named.question, named.ask, amount, maximum, comment, before),
            paper=self._find_code(row, student),
        )
        found = HandRow(mark, f"{self.path}:{row.line}", carried=self.newer is not None)
        if not held:
            self.found.not_held.append(found)
        elif self.markable.leaves_out(named.column, amount):
            self.found.dropped.append(found)
        elif not self._is_above(row, amount, named):
            self.found.rows.append(found)

    def _is_replaced(self, student: str, named: Named, points: str) -> bool:
        """Whether a newer mark takes the place of this one, whatever stands here."""
        if self.newer is None or not self.newer.replaces(student, named):
            return False
        amount = self.newer.points.get((student, named.column))
        self.found.replaced += amount is None or amount != _read_amount(points)
        return True

    def _find_student(self, row: Row, students: Mapping[str, str]) -> str | None:
        cell = self.columns.cell(row, self.columns.student)
        code = self.columns.cell(row, self.columns.code)
        owner = self.markable.ids.coded(code) if code else None
        ours, student = self.columns.is_ours(row, self.markable.identity), students.get(cell)
        if spare := self.markable.spares.coded(code or cell):
            what = Message("marking.nobodys-paper", code=spare)
            self._fault(row, spare, what, do=Message("marking.give-to-owner"))
            return None
        exchanged = student is None or (student, code) in self.markable.had
        if ours and owner not in (None, student) and exchanged:
            self.found.followed += 1
            return owner
        if code and owner is None and not ours:  # changed with the version
            self._fault(row, code, Message("marking.no-such-code"))
            return None
        if not cell:
            if owner is None:
                self._fault(row, "", Message("marking.no-id"))
            return owner
        if student is None:
            self._fault(row, "", *_explain_unknown(cell, self.markable.ids))
        elif owner is not None and owner != student:
            what = Message("marking.code-of-another", student=Quoted(owner))
            self._fault(row, code, what, do=Message("marking.correct-one", student=Quoted(student)))
            return None
        return None if student is None or self._has_other_name(row, student) else student

    def _find_code(self, row: Row, student: str) -> str:
        """The code of the student's paper where the row was given by that, "" where by the id."""
        cell = self.columns.cell(row, self.columns.student)
        code = self.columns.cell(row, self.columns.code)
        ours = self.columns.is_ours(row, self.markable.identity)
        by = code if code and (ours or not cell) else cell
        given = self.markable.ids.coded(by) == student
        return self.markable.codes[student] if given else ""

    def _has_other_name(self, row: Row, student: str) -> bool:
        """Whether the name beside the id is that of another student, which is a fault."""
        other = self.markable.people.find_other(student, self.columns.names.written(row))
        if other is not None:
            what = Message("marking.name-of-another", student=Quoted(other))
            self._fault(row, "", what, do=Message("marking.correct-name", student=Quoted(student)))
        return other is not None

    def _find_named(self, row: Row, student: str | None) -> Named | None:
        written = self.columns.target(row)
        named = self.markable.names.find(written)
        if named is None and make_header_key(written) in list_spellings(Message("marking.extra")):
            named = Named(EXTRA)
        if named is None:
            what = Message("marking.nothing-of-this-name", name=Quoted(shorten(written)))
            held = self.markable.describe_held(student or "", written)
            self._fault(row, "", what, held or self.markable.explain_names())
        return named

    def _is_held(self, row: Row, student: str, named: Named) -> bool | None:
        """Whether the student's paper holds the question; None where that is a fault, as it is in
        what is not carried over.
        """
        if self.markable.is_held(student, named.question):
            return True
        if self.newer is not None:
            return False
        question = find_bank_number(named.question)
        what = Message("marking.not-on-paper", question=question, student=Quoted(student))
        held = self.markable.describe_held(student, named.question)
        self._fault(row, "", what, held, Message("marking.correct-here"))
        return None

    def _read_points(self, row: Row, cell: str, named: Named) -> Fraction | None:
        maximum = self.markable.maxima.get(named.column)
        wrong = explain_points(cell, maximum)
        if wrong is not None:
            self._fault(row, named.column, *wrong)
        return _read_amount(cell) if wrong is None else None

    def _is_above(self, row: Row, points: Fraction, named: Named) -> bool:
        """Whether there are fewer points to be had, which is a fault."""
        maximum = self.markable.maxima.get(named.column)
        if maximum is None or points <= maximum:
            return False
        shown = write_amount(points), write_amount(maximum)
        what = Message("marking.above-points", points=shown[0], maximum=shown[1])
        do = GIVE_NEW if self.newer is not None else Message("marking.rest-as-bonus", name=EXTRA)
        self._fault(row, named.column, what, do=do)
        return True

    def _is_cut(self, row: Row, points: str, comment: str, named: Named) -> bool:
        """Whether points and comment may be one number that its decimal comma cut in two, which is
        a fault.
        """
        beside = self.columns.comment == self.columns.points + 1
        cut = self.table.separator == "," and beside and points.isdecimal() and comment.isdecimal()
        if cut:
            whole, decimals = Quoted(points), Quoted(comment)
            what = Message("marking.points-cut", points=whole, comment=decimals)
            do = Message("marking.write-points", comma=f'"{points},{comment}"')
            self._fault(row, named.column, what, do=do)
        return cut

    def _explain_unread(self, complaint: Complaint) -> Fault:
        where = self.path if complaint.line is None else f"{self.path}:{complaint.line}"
        return Fault(where, complaint.problem, do=Message("marking.correct-row"))

    def _fault(
        self, row: Row, what_for: str, what: Message, expected: Text = "", do: Text = ""
    ) -> None:
        where = f"{self.path}:{row.line}"
        self.found.faults.append(
            Fault(f"{where}: {what_for}" if what_for else where, what, expected, do)
        )


def _read_amount(cell: str) -> Fraction | None:
    """The points in a cell, None where it holds none."""
    typed = read_typed_points(cell)
    return None if typed is None else typed.points


def _explain_unknown(cell: str, ids: StudentIds) -> tuple[Message, Text, Text]:
    """That nobody has that id, and who may be meant."""
    likely = ids.near(cell)
    what = Message("marking.no-student", student=Quoted(shorten(cell)))
    do = Message("marking.one-of", students=list_choices(map(Quoted, likely))) if likely else ""
    return what, "", do
