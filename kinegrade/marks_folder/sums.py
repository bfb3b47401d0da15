"""The sums of marks.csv, one student after the other."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import replace
from fractions import Fraction
from itertools import groupby
from pathlib import Path

from kinegrade.errors import TableError
from kinegrade.files.cell_text import is_answered
from kinegrade.files.csv_writing import restore
from kinegrade.language.message import Message, Quoted
from kinegrade.marks_folder.cells import Record, explain_edited, read_amount, read_records
from kinegrade.marks_folder.hand_marks import (
    ByHand,
    HandMark,
    find_only_by_hand,
    settle_points,
)
from kinegrade.marks_folder.layout import ANSWERS
from kinegrade.marks_folder.rows import StudentSums
from kinegrade.numbers.amounts import add_amounts

_Line = tuple[int, Record]


def read_sums(folder: Path, bonus: Set[str], by_hand: ByHand) -> Iterator[StudentSums]:
    """The sums of each student, in the order of marks.csv, settled by the marks `by_hand`; the
    points of the questions `bonus` come on top of the maximum. Raises TableError at the line of the
    fault.
    """
    path = folder / ANSWERS.name
    only_by_hand = find_only_by_hand(by_hand)
    seen: set[str] = set()
    for student, lines in groupby(read_records(folder, ANSWERS), _read_student):
        found = _find_sums(student, lines, path)
        sums = _settle(found, by_hand.get(student, {}), only_by_hand, bonus)
        if student in seen:
            problem = Message("marks.lines-apart", student=Quoted(student))
            raise TableError(explain_edited(f"{path}:{sums.line}", problem))
        seen.add(student)
        yield sums


def _read_student(line: _Line) -> str:
    return line[1][0]


def _find_sums(student: str, lines: Iterable[_Line], path: Path) -> StudentSums:
    points, out_of = defaultdict[str, list[Fraction]](list), defaultdict[str, list[Fraction]](list)
    answered, line = False, 0
    for line, (_, question, _, response, _, _, _, got, possible, *_) in lines:
        points[question].append(read_amount(got, path, line, "points"))
        out_of[question].append(read_amount(possible, path, line, "out_of"))
        answered = answered or is_answered(restore(response))
    counts = {question: len(amounts) for question, amounts in points.items()}
    return StudentSums(
        line,
        student,
        _sum_by_question(points),
        _sum_by_question(out_of),
        counts,
        answered,
    )


def _settle(
    sums: StudentSums,
    marks: Mapping[str, HandMark],
    only_by_hand: Mapping[str, Fraction],
    bonus: Set[str],
) -> StudentSums:
    """The sums with the marks by hand, and the questions that only hands mark."""
    out_of = {**sums.out_of, **only_by_hand}
    nothing = dict.fromkeys(only_by_hand, Fraction(0))
    return replace(
        sums,
        points=settle_points({**sums.points, **nothing}, marks.values()),
        out_of=out_of,
        answered=sums.answered or bool(marks),
        bonus=add_amounts(out_of[each] for each in bonus & out_of.keys()),
        by_hand=bool(marks),
    )


def _sum_by_question(amounts: Mapping[str, Sequence[Fraction]]) -> Mapping[str, Fraction]:
    return {question: add_amounts(each) for question, each in amounts.items()}
