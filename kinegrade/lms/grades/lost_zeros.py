"""Ids of a downloaded file that lack the zeros of the class's ids, or have more: one cause, most
likely a spreadsheet, told once. They are not taken by themselves.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeVar

from kinegrade.files.tables import Complaint
from kinegrade.language.message import Message, Quoted, list_first
from kinegrade.lms.grades.cells import CellTable, Record
from kinegrade.lms.grades.grades import StudentGrade
from kinegrade.lms.grades.key_column import KeyColumn

_SEVERAL = 3  # fewer are told one by one, with their lines
_MOST_NAMED = 3
_Item = TypeVar("_Item")


@dataclass(frozen=True, slots=True)
class LostZeros:
    """The students whose ids differ from that of one row by zeros in front alone, by the row's
    line, and the one complaint about them.
    """

    students: Mapping[int, str]
    complaints: tuple[Complaint, ...]


def find_lost_zeros(
    table: CellTable,
    columns: Sequence[KeyColumn],
    missing: Sequence[StudentGrade],
    free: Sequence[Record],
) -> LostZeros:
    """Those of the students without a row and of the rows that no student matches."""
    for column in columns:
        rows = _collect((column.value(row), row.line) for row in free)
        wanted = _collect((column.wanted(each), each.student) for each in missing)
        pairs = {
            rows[number][0]: each[0]
            for number, each in wanted.items()
            if len(each) == len(rows.get(number, ())) == 1
        }
        if len(pairs) >= _SEVERAL:
            cells = {row.line: column.value(row) for row in free}
            shown = [
                Message("grades.id-for", cell=Quoted(cells[line]), student=Quoted(student))
                for line, student in pairs.items()
            ]
            names, title = list_first(shown, _MOST_NAMED), table.titles[column.place]
            found = Message("grades.zeros-differ", number=len(pairs), ids=names)
            done = Message("grades.restore-zeros")
            return LostZeros(pairs, (Complaint(table.file, None, title, "", found, done),))
    return LostZeros({}, ())


def _collect(numbered: Iterable[tuple[str, _Item]]) -> Mapping[str, list[_Item]]:
    """What has a number, by its digits without zeros in front."""
    found: dict[str, list[_Item]] = defaultdict(list)
    for text, item in numbered:
        if text.isdecimal():
            found[text.lstrip("0")].append(item)
    return found
