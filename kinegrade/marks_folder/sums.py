"""The sums of marks.csv, one student after the other."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Set
from fractions import Fraction
from functools import lru_cache
from itertools import groupby
from operator import itemgetter
from pathlib import Path

import msgspec

from kinegrade.errors import TableError
from kinegrade.files.cell_text import is_answered
from kinegrade.files.csv_writing import restore
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.marks_folder.cells import (
    Record,
    explain_amount,
    explain_edited,
    find_amount,
    read_records,
)
from kinegrade.marks_folder.hand_marks import (
    ByHand,
    HandMark,
    find_only_by_hand,
    settle_points,
)
from kinegrade.marks_folder.layout import ANSWERS
from kinegrade.marks_folder.rows import QuestionSums, StudentSums
from kinegrade.numbers.amounts import add_amounts

_Line = tuple[int, Record]
_read_response = itemgetter(ANSWERS.columns.index("response"))
# The question beside the amount
_AMOUNTS: Mapping[str, Callable[[Record], tuple[str, str]]] = {
    column: itemgetter(*map(ANSWERS.columns.index, ("question", column)))
    for column in ("points", "out_of")
}


def read_sums(folder: Path, bonus: Set[str], by_hand: ByHand) -> Iterator[StudentSums]:
    """The sums of each student, in the order of marks.csv, settled by the marks `by_hand`; the
    points of the questions `bonus` come on top of the maximum. Raises TableError at the line of the
    fault.
    """
    path = folder / ANSWERS.name
    only_by_hand = find_only_by_hand(by_hand)
    seen: set[str] = set()
    for student, lines in groupby(read_records(folder, ANSWERS), _read_student):
        sums = _find_sums(student, list(lines), path)
        marks = by_hand.get(student, {})
        if marks or only_by_hand or bonus:
            sums = _settle(sums, marks, only_by_hand, bonus)
        if student in seen:
            problem = Message("marks.lines-apart", student=Quoted(student))
            raise TableError(explain_edited(f"{path}:{sums.line}", problem))
        seen.add(student)
        yield sums


def _read_student(line: _Line) -> str:
    return line[1][0]


def _find_sums(student: str, lines: Sequence[_Line], path: Path) -> StudentSums:
    """The sums of the lines of one student, as the machine gave them."""
    records = [cells for _, cells in lines]
    points, out_of = (_add_up(tuple(map(read, records))) for read in _AMOUNTS.values())
    if points is None or out_of is None:
        raise TableError(next(_find_damaged(lines, path)))
    answered = any(is_answered(restore(response)) for response in map(_read_response, records))
    return StudentSums(lines[-1][0], student, points, out_of, answered)


@lru_cache(maxsize=4096)  # few students have points that nobody else has
def _add_up(cells: tuple[tuple[str, str], ...]) -> QuestionSums | None:
    """The sums of amounts, each beside its question; None where one is no amount."""
    listed = defaultdict[str, list[Fraction]](list)
    for question, cell in cells:
        amount = find_amount(cell)
        if amount is None:
            return None
        listed[question].append(amount)
    counts = {question: len(amounts) for question, amounts in listed.items()}
    return QuestionSums({name: add_amounts(each) for name, each in listed.items()}, counts)


def _find_damaged(lines: Iterable[_Line], path: Path) -> Iterator[Fault]:
    """What is wrong with the cells of these lines that hold no amount."""
    for line, record in lines:
        for column, read in _AMOUNTS.items():
            _, cell = read(record)
            if find_amount(cell) is None:
                yield explain_amount(path, line, column, cell)


def _settle(
    sums: StudentSums,
    marks: Mapping[str, HandMark],
    only_by_hand: Mapping[str, Fraction],
    bonus: Set[str],
) -> StudentSums:
    """The sums with the marks by hand, and the questions that only hands mark."""
    out_of = {**sums.out_of.by_question, **only_by_hand}
    nothing = dict.fromkeys(only_by_hand, Fraction(0))
    points = settle_points({**sums.points.by_question, **nothing}, marks.values())
    return msgspec.structs.replace(
        sums,
        points=QuestionSums(points, sums.points.counts),
        out_of=QuestionSums(out_of, sums.out_of.counts),
        answered=sums.answered or bool(marks),
        bonus=add_amounts(out_of[each] for each in bonus & out_of.keys()),
        by_hand=bool(marks),
    )
