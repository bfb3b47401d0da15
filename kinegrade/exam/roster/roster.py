"""The class: who gets a paper, and where they sit.

`Roster.read` reads one, as a registry, a learning management system or a person sends it: CSV in
any usual encoding, or a workbook. Columns are known by their usual titles in any order, or named.
Ids are texts: leading zeros and case are kept.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from os import PathLike
from pathlib import Path
from types import MappingProxyType

from kinegrade.exam.roster.columns import Wishes, make_header_sign
from kinegrade.exam.roster.reading import read_class
from kinegrade.exam.roster.students import Student
from kinegrade.exam.roster.way_of_reading import WayOfReading
from kinegrade.files.tables import Complaint, Table, parse_table, read_table
from kinegrade.files.workbooks.inspection import is_workbook
from kinegrade.files.workbooks.spreadsheet import read_workbook
from kinegrade.language.message import Message

_AS_TITLED: Wishes = MappingProxyType({})
_DIGITS = re.compile(r"([0-9]+)")
_LAST = (10**9, "")


@dataclass(frozen=True, slots=True)
class Roster:
    """The students in the order of the file, and complaints for a person to look at; `file` is its
    name in messages, `way` says how it was read, `odd_ids` that odd ids are wanted.
    """

    students: tuple[Student, ...]
    complaints: tuple[Complaint, ...]
    file: str = field(default="roster", compare=False)
    way: WayOfReading | None = field(default=None, compare=False, repr=False)
    odd_ids: bool = field(default=False, compare=False, repr=False)

    @classmethod
    def read(
        cls,
        path: str | PathLike[str],
        *,
        odd_ids: bool = False,
        columns: Wishes = _AS_TITLED,
    ) -> Roster:
        """Reads a roster file; raises TableError with all its faults at once.

        `columns` names the titles of columns that are not known by them, and by "" columns that are
        not to be used. Ids that a spreadsheet would take for a formula are a fault too, and ids
        that differ by zeros in front alone, unless `odd_ids` are wanted: they are keys, so they
        stand as they are in every table that is written.

        >>> [student.name for student in Roster.read("roster.csv").students]
        ['Ann', 'Ben']
        >>> Roster.read("bank.toml")
        Traceback (most recent call last):
        kinegrade.errors.TableError: bank.toml: ...
        """
        file, is_header = Path(path), make_header_sign(columns)
        if is_workbook(file):
            table = read_workbook(file, is_header, is_header)
        else:
            table = read_table(file, None, is_header)
        return _make_roster(table, columns, odd_ids=odd_ids)

    @property
    def notes(self) -> tuple[Message, ...]:
        """How it was read, where that needs to be said."""
        return () if self.way is None or self.way.plain else tuple(self.way.notes())

    @property
    def seated(self) -> Roster:
        """The same, by rooms, seats and groups as far as they are known: the order in which papers
        lie on the pile.
        """
        return replace(self, students=tuple(sorted(self.students, key=find_seat)))


def parse_roster(content: bytes, file: str, *, odd_ids: bool = False) -> Roster:
    """Reads the bytes of a CSV file as `Roster.read` does; `file` is its name in messages. Raises
    TableError.

    >>> parse_roster(b"name,ID\\nAnn,007\\n", "roster.csv").students[0].student
    '007'
    """
    table = parse_table(content, file, None, make_header_sign(_AS_TITLED))
    return _make_roster(table, _AS_TITLED, odd_ids=odd_ids)


def _make_roster(table: Table, wishes: Wishes, *, odd_ids: bool) -> Roster:
    read = read_class(table, wishes, odd_ids=odd_ids)
    return Roster(read.students, read.complaints, table.file, read.way, odd_ids)


def find_seat(student: Student) -> tuple[tuple[tuple[int, str], ...], ...]:
    """What the place in a pile goes by: room, seat, group, numbers in texts by their size; those
    without come last.
    """
    return tuple(map(_order, (student.room, student.seat, student.group)))


def _order(text: str) -> tuple[tuple[int, str], ...]:
    """The parts of a text, A2 before A10."""
    parts = filter(None, _DIGITS.split(text.casefold()))
    return tuple(map(_order_part, parts)) or (_LAST,)


def _order_part(part: str) -> tuple[int, str]:
    """Digits by their number, whatever its size; other texts before them."""
    digits = part.lstrip("0")
    return (1 + len(digits), digits) if _DIGITS.fullmatch(part) else (0, part)
