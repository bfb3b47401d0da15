"""Whether grades.csv still says what marks.csv adds up to: totals that were changed by hand are
refused.

`refuse_changed_totals` is called by every command that hands totals out. marks.csv is read one
student after the other. A total that kept.csv keeps is held against kept.csv. Every amount is
written with four places, so a sum of amounts may be off by half a place for each.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from itertools import groupby
from pathlib import Path

from kinegrade.csv_writing import restored
from kinegrade.errors import TableError, one_line
from kinegrade.grading.amounts import PLACES, amount_text
from kinegrade.grading.marks_folder import KEPT
from kinegrade.tables import Row, Table, read_table, trimmed, written_records

_NOT_QUESTIONS = {"student", "name", "total", "out_of", "percent", "status"}
_STATUSES = ("marked", "absent")  # folders of earlier versions have no such column
_AMOUNT = re.compile(r"[0-9]{1,20}(?:\.[0-9]{1,20})?")
# Amounts are added as whole numbers of the last place that is read.
_UNIT = 10**20
_HALF_A_PLACE = _UNIT // (2 * 10**PLACES)
_DASHES = "-\u2010\u2011\u2012\u2013\u2014\u2015\u2212\uff0d"
_MOST_NAMED = 20
_MENDING = (
    "expected the file as kinegrade grade wrote it - grade again; to change marks, grade by "
    "a --policy"
)


@dataclass(frozen=True, slots=True)
class _Sums:
    """What one student's lines of marks.csv add up to, by question; amounts are whole numbers of
    10^-20 points.

    `answered` is whether anything besides blanks and dashes was typed.
    """

    student: str
    points: Mapping[str, int]
    out_of: Mapping[str, int]
    lines: Mapping[str, int]
    answered: bool


def refuse_changed_totals(folder: Path) -> None:
    """Raises TableError that names each row of grades.csv which marks.csv and kept.csv contradict.

    Raises TableError too for files that `grade` cannot have written.
    """
    grades = _Grades(folder)
    for sums in _sums(folder / "marks.csv"):
        grades.compare(sums)
    grades.finish()


def _sums(path: Path) -> Iterator[_Sums]:
    columns = ("student", "question", "response", "points", "out_of")
    seen: set[str] = set()
    records = written_records(path, columns)
    for student, lines in groupby(records, lambda record: record[1][0]):
        points, out_of, count = defaultdict[str, int](int), defaultdict[str, int](int), 0
        numbers = defaultdict[str, int](int)
        answered = False
        for line, (_, question, response, got, possible) in lines:
            points[question] += _amount(got, f"{path.name}:{line}", "points")
            out_of[question] += _amount(possible, f"{path.name}:{line}", "out_of")
            numbers[question] += 1
            count = line
            answered = answered or _is_answer(response)
        if student in seen:
            raise TableError(
                f'{path}:{count}: the lines of student "{one_line(student)}" do not stand together '
                "- "
                "expected the file as kinegrade grade wrote it - grade again"
            )
        seen.add(student)
        yield _Sums(student, points, out_of, numbers, answered)


def _is_answer(response: str) -> bool:
    return bool(response) and bool(trimmed(restored(response)).strip(f"{_DASHES} "))


def _amount(cell: str, place: str, name: str) -> int:
    amount = _scaled(cell)
    if amount is None:
        raise TableError(
            f'{place}: {name} is "{one_line(cell[:40])}" - expected a number - grade again'
        )
    return amount


@lru_cache(maxsize=4096)  # few amounts are different
def _scaled(cell: str) -> int | None:
    return int(Fraction(cell) * _UNIT) if _AMOUNT.fullmatch(cell) else None


class _Grades:
    """The rows of grades.csv, each held against the sums of its student."""

    def __init__(self, folder: Path) -> None:
        self.path = folder / "grades.csv"
        self.table = _table(self.path, ("student", "name", "total"))
        self.kept = _kept(folder / KEPT)
        self.rows: dict[str, Row] = {}
        self.faults: list[str] = []
        self.full = 0  # lines of the first student: nobody has more
        place = self.table.header.index("student")
        for row in self.table.rows:
            student = row.cell(place)
            if student in self.rows:
                self._fault(row, "stands there twice")
            self.rows[student] = row

    def compare(self, sums: _Sums) -> None:
        """Notes what the row of a student says otherwise than the sums."""
        row = self.rows.pop(sums.student, None)
        if row is None:
            self.faults.append(
                f'{self.path}: student "{one_line(sums.student)}" has marks and no row here'
            )
            return
        lines = sum(sums.lines.values())
        if not self.full:
            missing = [name for name in sums.points if name not in self.table.header]
            self.faults += [f"{self.path}: no column {name}" for name in missing]
        self.full = self.full or lines
        problems = [
            *self._wrong_points(row, sums),
            *self._wrong_total(row, sums, lines),
            *self._wrong_out_of(row, sums, lines),
            *self._wrong_status(row, sums),
        ] or [*self._wrong_percent(row)]
        if problems:
            self._fault(row, "; ".join(problems))

    def _wrong_points(self, row: Row, sums: _Sums) -> Iterator[str]:
        for name in self.table.header:
            if name not in _NOT_QUESTIONS:
                expected, lines = sums.points.get(name, 0), sums.lines.get(name, 0)
                yield from _difference(name, self._cell(row, name), expected, lines)

    def _wrong_total(self, row: Row, sums: _Sums, lines: int) -> Iterator[str]:
        total = self._cell(row, "total")
        if sums.student not in self.kept:
            yield from _difference("total", total, sum(sums.points.values()), lines)
        elif total != self.kept[sums.student]:
            yield f"total is {_shown(total)}, {_shown(self.kept[sums.student])} by {KEPT}"

    def _wrong_out_of(self, row: Row, sums: _Sums, lines: int) -> Iterator[str]:
        """Where lines of marks.csv are missing, whoever reports or compares sees that."""
        if "out_of" in self.table.header and lines == self.full:
            expected = sum(sums.out_of.values())
            yield from _difference("out_of", self._cell(row, "out_of"), expected, lines)

    def _wrong_percent(self, row: Row) -> Iterator[str]:
        """The share is held against the total and the maximum beside it; all three are rounded."""
        if not {"percent", "out_of"} <= set(self.table.header):
            return
        stated = Fraction(self._cell(row, "percent"), _UNIT)
        out_of = Fraction(self._cell(row, "out_of"), _UNIT)
        total = Fraction(self._cell(row, "total"), _UNIT)
        expected = 100 * total / out_of if out_of else Fraction(0)
        rounding = Fraction(1, 100) * (1 + (1 / out_of if out_of else 0))
        if abs(stated - expected) > rounding:
            shown = amount_text(expected, places=2)
            yield f"percent is {amount_text(stated)}, {shown} by the total"

    def _wrong_status(self, row: Row, sums: _Sums) -> Iterator[str]:
        if "status" not in self.table.header:
            return
        status = row.cell(self.table.header.index("status"))
        if status not in _STATUSES:
            yield f'status is "{one_line(status[:40])}", neither {" nor ".join(_STATUSES)}'
        elif status == "absent" and sums.answered:
            yield "status is absent, and marks.csv has answers"

    def _cell(self, row: Row, name: str) -> int:
        cell = row.cell(self.table.header.index(name))
        return _amount(cell, f"{self.path.name}:{row.line}", name)

    def finish(self) -> None:
        """Raises TableError with all that was found."""
        for row in self.rows.values():
            self._fault(row, "has no lines in marks.csv")
        if not self.faults:
            return
        shown = self.faults[:_MOST_NAMED]
        more = len(self.faults) - len(shown)
        if more:
            shown.append(f"{self.path}: {more} more rows do not agree with marks.csv")
        raise TableError(*(f"{fault} - {_MENDING}" for fault in shown))

    def _fault(self, row: Row, problem: str) -> None:
        student = one_line(row.cell(self.table.header.index("student")))
        self.faults.append(f'{self.path}:{row.line}: student "{student}": {problem}')


def _difference(name: str, amount: int, expected: int, lines: int) -> Iterator[str]:
    """What to say where an amount is not the sum of so many, each of them rounded."""
    if abs(amount - expected) > (lines + 1) * _HALF_A_PLACE:
        yield f"{name} is {_shown(amount)}, {_shown(expected)} by marks.csv"


def _shown(amount: int) -> str:
    return amount_text(Fraction(amount, _UNIT))


def _kept(path: Path) -> Mapping[str, int]:
    """The totals that stand though they are not the sum, by student."""
    if not path.exists():
        return {}
    return {
        student: _amount(stands, f"{path.name}:{line}", "stands")
        for line, (student, stands) in written_records(path, ("student", "stands"))
    }


def _table(path: Path, columns: tuple[str, ...]) -> Table:
    table = read_table(path)
    missing = [name for name in columns if name not in table.header]
    if missing or table.complaints:
        problems = [*(f"no column {name}" for name in missing), *map(str, table.complaints)]
        raise TableError(
            f"{path}: {'; '.join(problems)} - expected the file as kinegrade grade wrote it - "
            "grade again"
        )
    return table
