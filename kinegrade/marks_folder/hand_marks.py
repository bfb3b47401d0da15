"""Marks that a person gave, beside those of the machine: for an ask, for a whole question, or on
top of everything.

They stand in a file of their own, manual.csv, with what the machine gave in the same place.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import chain
from pathlib import Path

from kinegrade.ask_names import Named
from kinegrade.errors import TableError
from kinegrade.files.csv_writing import restore
from kinegrade.language.message import Message
from kinegrade.marks_folder.cells import (
    Record,
    explain_cell,
    read_amount,
    read_records_if_any,
)
from kinegrade.marks_folder.layout import GRADES, MANUAL
from kinegrade.numbers.amounts import add_amounts

BY_HAND = "by hand"  # in place of the machine's verdict
_BETWEEN_COMMENTS = " / "
EXTRA = "bonus"  # in place of a question: points on top of everything, which no question has


@dataclass(frozen=True, slots=True)
class HandMark:
    """Points given by hand; `ask` is "" where they are for a whole question, or EXTRA.

    `machine` is what was given there without them, None where only a hand marks; `out_of` is what
    can be had, None for EXTRA. `paper` is the code by which it was given, "" where that was an id.
    """

    student: str
    question: str
    ask: str
    points: Fraction
    out_of: Fraction | None
    comment: str
    machine: Fraction | None = None
    paper: str = ""

    @property
    def column(self) -> str:
        """How files name what was marked: q1.v_B, q3, bonus."""
        return Named(self.question, self.ask).column

    @property
    def place(self) -> tuple[str, str]:
        """Whose mark it is, and for what."""
        return self.student, self.column

    @property
    def is_override(self) -> bool:
        """Whether the machine gave other points there."""
        return self.machine is not None and self.machine != self.points


ByHand = Mapping[str, Mapping[str, HandMark]]  # by student, then by what was marked


def group_by_student(marks: Iterable[HandMark]) -> ByHand:
    """The marks of each student; of two for the same thing the last, with the comments of both."""
    found: dict[str, dict[str, HandMark]] = {}
    for mark in marks:
        marked = found.setdefault(mark.student, {})
        before = marked.get(mark.column)
        marked[mark.column] = mark if before is None else _with_both_comments(before, mark)
    return found


def _with_both_comments(one: HandMark, other: HandMark) -> HandMark:
    comments = dict.fromkeys([*one.comment.split(_BETWEEN_COMMENTS), other.comment])
    return replace(other, comment=_BETWEEN_COMMENTS.join(filter(None, comments)))


def list_hand_marks(by_hand: ByHand) -> Iterator[HandMark]:
    """All of them, one student after the other."""
    return chain.from_iterable(marks.values() for marks in by_hand.values())


def find_only_by_hand(by_hand: ByHand) -> Mapping[str, Fraction]:
    """The questions that no machine marks and somebody has a mark for, EXTRA last, with what can be
    had: from then on they count for everybody.
    """
    found = {
        mark.question: mark.out_of or Fraction(0)
        for mark in list_hand_marks(by_hand)
        if not mark.ask and mark.machine is None
    }
    return dict(sorted(found.items(), key=lambda each: each[0] == EXTRA))


def settle_points(
    machine: Mapping[str, Fraction], marks: Iterable[HandMark]
) -> dict[str, Fraction]:
    """A student's points by question: those of the machine, and in their place what a hand gave."""
    points = dict(machine)
    for mark in marks:
        if mark.ask:
            points[mark.question] += mark.points - (mark.machine or Fraction(0))
        else:
            points[mark.question] = mark.points
    return points


def work_out_total(settled: Iterable[Fraction]) -> Fraction:
    """The total of a student whose points are settled: the one place that everything which writes,
    reads or checks a total asks.
    """
    return add_amounts(settled)


def read_hand_marks(folder: Path) -> ByHand:
    """The marks of manual.csv; none where there is no such file. Raises TableError."""
    path = folder / MANUAL.name
    records = read_records_if_any(folder, MANUAL)
    return group_by_student(_read_hand_mark(cells, path, line) for line, cells in records)


def are_edited(folder: Path) -> bool:
    """Whether manual.csv was saved after the totals, which are then still as they were written."""
    files = folder / MANUAL.name, folder / GRADES.name
    if not all(file.exists() for file in files):
        return False
    by_hand, totals = (file.stat().st_mtime_ns for file in files)
    return by_hand > totals


def _read_hand_mark(cells: Record, path: Path, line: int) -> HandMark:
    student, place, points, out_of, machine, comment, paper = cells
    question, _, ask = place.partition(".")
    if not question or (ask and not machine):
        expected = Message("marks.marked-place")
        raise TableError(explain_cell(path, line, "question", place, expected))
    return HandMark(
        student,
        question,
        ask,
        read_amount(points, path, line, "points"),
        read_amount(out_of, path, line, "out_of") if out_of else None,
        restore(comment),
        read_amount(machine, path, line, "machine") if machine else None,
        paper,
    )
