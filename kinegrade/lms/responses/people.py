"""Whose responses these are: students are found by id or e-mail address, never by name, and never
guessed.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

import msgspec

from kinegrade.exam.folder.records import Candidate
from kinegrade.exam.roster.student_ids import StudentIds
from kinegrade.exam.roster.students import make_student_key
from kinegrade.files.cell_text import make_header_key, shorten, trim
from kinegrade.files.rows.row import Row
from kinegrade.language.message import Message, Quoted, Text, list_all

Kind = Literal["id", "email", "code"]


class Found(msgspec.Struct, frozen=True, gc=False):  # there are many
    """The student of a row; else the column at fault, why, and the students who may be meant.

    `restored` is the id as it stands in the file where it is not the exam's; `code` is that of the
    paper where nothing else names the student, or of a spare paper that is nobody's. A student is
    found `by_code` whom the code of the paper names.
    """

    student: str | None
    column: str = ""
    problem: Text = ""
    likely: tuple[str, ...] = ()
    restored: str = ""
    code: str = ""
    by_code: bool = False


@dataclass(frozen=True, slots=True)
class Columns:
    """The columns that identify the student; None where the file has none. Where they are blank,
    the `codes` of papers do.
    """

    identifier: int | None
    email: int | None
    codes: tuple[int, ...] = ()

    @property
    def indices(self) -> tuple[int, ...]:
        """The columns that the file has."""
        return tuple(index for index in (self.identifier, self.email) if index is not None)


class People:
    """The students of an exam, by the ids and addresses that files have; `spares` are papers that
    are nobody's.
    """

    def __init__(self, students: Iterable[Candidate], spares: Iterable[Candidate] = ()) -> None:
        known = list(students)
        codes = {person.paper: person.student for person in known if person.paper}
        former = {before: person.student for person in known for before in person.formerly}
        self._ids = StudentIds((person.student for person in known), codes, former)
        self._spares = StudentIds((), {each.paper: each.paper for each in spares})
        self._by_email = _grouped(known, lambda person: make_header_key(person.email))

    def by_id(self, cell: str) -> str | None:
        """The student with that id, wrapped by a spreadsheet or not, or with that paper."""
        return self._ids.exact(cell)

    def by_email(self, cell: str) -> str | None:
        """The student with that e-mail address, regardless of case."""
        return _only(self._by_email.get(make_header_key(cell))) if "@" in cell else None

    def describe_restored(self, restored: Mapping[str, str]) -> Iterator[tuple[Message, Message]]:
        """What is said of ids that are not those of the exam, and of what was done."""
        return self._ids.describe_restored(restored)

    def _likely(self, cell: str) -> str | None:
        """The one student whose id differs from a cell, or from the login in its address, by zeros
        or case alone.
        """
        return _only(self._ids.near(cell.partition("@")[0]))

    def columns(
        self,
        rows: Sequence[Row],
        candidates: Sequence[int],
        named: Mapping[Kind, Sequence[int]] | None = None,
    ) -> Columns:
        """Which of the candidate columns hold ids and addresses: those whose names say so, else
        those with the most known ones.
        """
        named = named or {}
        return Columns(
            self._best(rows, named.get("id") or (), candidates, self.by_id),
            self._best(rows, named.get("email") or (), candidates, self.by_email),
            tuple(named.get("code") or ()),
        )

    def _best(
        self,
        rows: Sequence[Row],
        named: Sequence[int],
        candidates: Sequence[int],
        find: Callable[[str], str | None],
    ) -> int | None:
        """The column with the most known students, the first of equals; a named one even if it has
        no known student.
        """
        if len(named) == 1:
            return named[0]
        known = {index: _count(rows, index, find) for index in named or candidates}
        most = max(known.values(), default=0)
        best = [index for index, count in known.items() if count == most]
        if most and len(best) == 1:
            return best[0]
        by_id = find == self.by_id
        likely = {index: _count(rows, index, self._likely) if by_id else 0 for index in best}
        likeliest = max(likely, key=lambda index: likely[index], default=None)
        is_known = likeliest is not None and (most or likely[likeliest])
        return likeliest if named or is_known else None

    def find_all(
        self, rows: Sequence[Row], header: Sequence[str], columns: Columns
    ) -> tuple[Found, ...]:
        """The students of all rows; an id that differs by zeros or case is accepted where that is
        certain.
        """
        place = columns.identifier
        if place is None:
            return tuple([self.find(row, header, columns) for row in rows])
        cells = [row.cell(place) for row in rows]
        # As in most files; an address beside the id may be that of another student
        exact = [None] * len(rows) if columns.email is not None else self._ids.all_exact(cells)
        found = [
            self.find(row, header, columns) if student is None else Found(student)
            for row, student in zip(rows, exact, strict=True)
        ]
        unknown = [
            number
            for number, each in enumerate(found)
            if each.student is None and not self._other_address(rows[number], columns)
        ]
        restored = self._ids.restored(
            [cells[number] for number in unknown],
            {each.student for each in found if each.student is not None},
        )
        for number in unknown:
            if cells[number] in restored:
                found[number] = Found(restored[cells[number]])
        return tuple(map(self._said, cells, found))

    def _said(self, cell: str, found: Found) -> Found:
        """The same, with the id as it stands in the file where it is that student's in another
        form.
        """
        student = found.student
        if student is None or cell == student or trim(cell) == trim(student):
            return found
        if self._ids.coded(cell) == found.student:
            return msgspec.structs.replace(found, by_code=True)
        meant = self._ids.exact(cell) or _only(self._ids.near(cell))
        return msgspec.structs.replace(found, restored=cell) if meant == found.student else found

    def _other_address(self, row: Row, columns: Columns) -> bool:
        """Whether a row has the address of a student; its id is then not that of another."""
        return (
            columns.email is not None and make_header_key(row.cell(columns.email)) in self._by_email
        )

    def find(self, row: Row, header: Sequence[str], columns: Columns) -> Found:
        """The student of a row; none where id and address are those of different students."""
        cells = {index: row.cell(index) for index in columns.indices}
        named = {who for cell in cells.values() if (who := self.by_id(cell) or self.by_email(cell))}
        if len(named) == 1:
            return Found(named.pop())
        index = next((index for index, cell in cells.items() if make_student_key(cell)), None)
        if index is None:
            return self._by_code({place: row.cell(place) for place in columns.codes}, header)
        if named:
            students = list_all(sorted(named))
            return Found(None, header[index], Message("responses.different", students=students))
        return self._unknown(cells[index], header[index])

    def _by_code(self, cells: Mapping[int, str], header: Sequence[str]) -> Found:
        """The student of a row that has the code of one paper and nothing else that names one."""
        written = {place: trim(cell) for place, cell in cells.items() if trim(cell)}
        owners = {self._ids.coded(code) for code in written.values()}
        owner = owners.pop() if len(owners) == 1 else None
        place, code = next(iter(written.items()), (None, ""))
        if place is None or (owner is None and not self._spares.coded(code)):
            return Found(None, "", Message("responses.no-id"))
        if owner is None:
            return self._unknown(code, header[place])
        return Found(owner, header[place], Message("responses.no-id"), code=code, by_code=True)

    def _unknown(self, cell: str, column: str) -> Found:
        shown = Quoted(shorten(make_student_key(cell)))
        spare = self._spares.coded(cell)
        if spare:
            problem = Message("marking.nobodys-paper", code=spare)
            return Found(None, column, problem, code=spare)
        if make_header_key(cell) in self._by_email:
            return Found(None, column, Message("responses.shared-address", address=shown))
        login = self._likely(cell)
        likely = self._ids.near(cell) or ((login,) if login else ())
        return Found(None, column, Message("marking.no-student", student=shown), likely)


def _grouped(
    people: Iterable[Candidate], key: Callable[[Candidate], str]
) -> Mapping[str, tuple[str, ...]]:
    groups: dict[str, list[str]] = defaultdict(list)
    for person in people:
        if key(person):
            groups[key(person)].append(person.student)
    return {name: tuple(found) for name, found in groups.items()}


def _only(found: tuple[str, ...] | None) -> str | None:
    return found[0] if found is not None and len(found) == 1 else None


def _count(rows: Sequence[Row], index: int, find: Callable[[str], str | None]) -> int:
    return len({find(row.cell(index)) for row in rows} - {None})
