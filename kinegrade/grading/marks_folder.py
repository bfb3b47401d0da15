"""Reading a folder of marks again, as `grade` wrote it: for comparing two, and for letting nobody
fall below one.

Used by `never_lower` and `comparison`. Amounts are the numbers that stand in the files.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

from kinegrade.csv_writing import restored
from kinegrade.errors import TableError, one_line
from kinegrade.tables import Row, read_table

_AMOUNT = re.compile(r"[0-9]{1,20}(?:\.[0-9]{1,20})?")
KEPT = "kept.csv"  # who keeps an earlier total; only where --never-lower was given


@dataclass(frozen=True, slots=True)
class Total:
    """One student's line of grades.csv; `kept` is what kept.csv says of it, else empty."""

    name: str
    points: Fraction
    out_of: Fraction
    kept: str = ""

    @property
    def share(self) -> Fraction:
        """Of the points there are; 0 where there are none."""
        return self.points / self.out_of if self.out_of else Fraction(0)


@dataclass(frozen=True, slots=True)
class Line:
    """One line of marks.csv: an answer, judged."""

    typed: str
    verdict: str
    reason: str
    points: Fraction
    out_of: Fraction


Lines = Mapping[tuple[str, str], Line]  # by student and answer column


def read_totals(folder: Path) -> Mapping[str, Total]:
    """Everybody's total by student, in the order of grades.csv. Raises TableError."""
    grades, reasons = (
        _File(folder / "grades.csv", ("student", "name", "total", "out_of")),
        _kept(folder / KEPT),
    )
    return {
        student: Total(
            restored(name),
            grades.amount(row, "total"),
            grades.amount(row, "out_of"),
            reasons.get(student, ""),
        )
        for row, (student, name, *_) in grades.rows()
    }


def read_lines(folder: Path) -> Lines:
    """Everybody's answers with their verdicts, in the order of marks.csv. Raises TableError."""
    names = ("student", "question", "ask", "response", "verdict", "reason", "points", "out_of")
    marks = _File(folder / "marks.csv", names)
    return {
        (student, f"{question}.{ask}"): Line(
            restored(typed),
            verdict,
            restored(reason),
            marks.amount(row, "points"),
            marks.amount(row, "out_of"),
        )
        for row, (student, question, ask, typed, verdict, reason, *_) in marks.rows()
    }


def _kept(file: Path) -> Mapping[str, str]:
    if not file.exists():
        return {}
    return {
        student: restored(reason)
        for _, (student, reason) in _File(file, ("student", "reason")).rows()
    }


class _File:
    """A table that `grade` wrote, by its columns. Raises TableError for one that it cannot have
    written.
    """

    def __init__(self, path: Path, names: Sequence[str]) -> None:
        self.path, self.table, self.names = path, read_table(path), names
        missing = [name for name in names if name not in self.table.header]
        faults = [f"{path.parent}/{complaint}" for complaint in self.table.complaints]
        if missing:
            faults.append(
                f"{path}: no column {', '.join(missing)} - expected the file as kinegrade grade "
                "wrote it"
            )
        if faults:
            raise TableError(*(f"{fault} - grade again" for fault in faults))

    def rows(self) -> Iterator[tuple[Row, list[str]]]:
        """Each row with its cells in the order of the names."""
        places = [self.table.header.index(name) for name in self.names]
        for row in self.table.rows:
            yield row, [row.cell(place) for place in places]

    def amount(self, row: Row, name: str) -> Fraction:
        """A cell that holds a number of points."""
        cell = row.cell(self.table.header.index(name))
        if _AMOUNT.fullmatch(cell):
            return Fraction(cell)
        raise TableError(
            f'{self.path}:{row.line}: {name} is "{one_line(cell[:40])}" - expected a number of '
            "zero or more "
            "- grade again"
        )
