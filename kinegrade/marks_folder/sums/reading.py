"""The sums of marks.csv, one student after the other."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Set
from fractions import Fraction
from functools import lru_cache
from itertools import groupby, islice
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
from kinegrade.marks_folder.sums.columns import OddTextError, read_students
from kinegrade.numbers.amounts import add_amounts

_Line = tuple[int, Record]
_read_response = itemgetter(ANSWERS.columns.index("response"))
_read_question = itemgetter(ANSWERS.columns.index("question"))
_AMOUNTS: Mapping[str, Callable[[Record], str]] = {
    column: itemgetter(ANSWERS.columns.index(column)) for column in ("points", "out_of")
}


def read_sums(folder: Path, bonus: Set[str], by_hand: ByHand) -> Iterator[StudentSums]:
    """The sums of each student, in the order of marks.csv, settled by the marks `by_hand`; the
    points of the questions `bonus` come on top of the maximum. Raises TableError at the line of the
    fault.
    """
    path = folder / ANSWERS.name
    only_by_hand = find_only_by_hand(by_hand)
    seen: set[str] = set()
    for added in _sum_up(folder):
        student = added.student
        if student in seen:
            problem = Message("marks.lines-apart", student=Quoted(student))
            raise TableError(explain_edited(f"{path}:{added.line}", problem))
        seen.add(student)
        marks = by_hand.get(student, {})
        settled = marks or only_by_hand or bonus
        yield _settle(added, marks, only_by_hand, bonus) if settled else added


def _sum_up(folder: Path) -> Iterator[StudentSums]:
    """The sums as the machine gave them: by columns as far as the text is as `grade` writes it, and
    record by record from there on.
    """
    path, summed = folder / ANSWERS.name, 0
    try:
        for sums in read_students(path, _add_up):
            summed += sums.points.lines
            yield sums
    except (OddTextError, OSError):
        rest = islice(read_records(folder, ANSWERS), summed, None)
        for name, lines in groupby(rest, _read_student):
            yield _find_sums(name, list(lines), path)


def _read_student(line: _Line) -> str:
    return line[1][0]


def _find_sums(student: str, lines: Sequence[_Line], path: Path) -> StudentSums:
    """The sums of the lines of one student, as the machine gave them."""
    records = [cells for _, cells in lines]
    questions = tuple(map(_read_question, records))
    points, out_of = (
        _add_up_once(questions, tuple(map(read, records))) for read in _AMOUNTS.values()
    )
    if points is None or out_of is None:
        raise TableError(next(_find_damaged(lines, path)))
    answered = any(is_answered(restore(response)) for response in map(_read_response, records))
    return StudentSums(lines[-1][0], student, points, out_of, answered)


def _add_up(questions: tuple[str, ...], cells: tuple[str, ...]) -> QuestionSums | None:
    """The sums of amounts, each with its question; None where one is no amount."""
    listed = defaultdict[str, list[Fraction]](list)
    for question, cell in zip(questions, cells, strict=True):
        amount = find_amount(cell)
        if amount is None:
            return None
        listed[question].append(amount)
    return _share(questions, tuple((name, add_amounts(each)) for name, each in listed.items()))


_add_up_once = lru_cache(maxsize=4096)(_add_up)  # few students have points that nobody else has


@lru_cache(maxsize=4096)  # far fewer than ways to get them, ask by ask
def _share(questions: tuple[str, ...], added: tuple[tuple[str, Fraction], ...]) -> QuestionSums:
    """Sums by question, held once."""
    return QuestionSums(dict(added), _count(questions))


@lru_cache(maxsize=256)  # most papers ask the same
def _count(questions: tuple[str, ...]) -> Mapping[str, int]:
    """How many lines each question has."""
    return Counter(questions)


def _find_damaged(lines: Iterable[_Line], path: Path) -> Iterator[Fault]:
    """What is wrong with the cells of these lines that hold no amount."""
    for line, record in lines:
        for column, read in _AMOUNTS.items():
            cell = read(record)
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
