"""The questions of an exam that are still to be marked by hand: for everybody, so that no mark,
total or percentage counts them, or for some students, who have no points for them so far.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from fractions import Fraction
from pathlib import Path
from typing import NamedTuple

from kinegrade.errors import TableError
from kinegrade.language.message import Fault, Message, Quoted, list_all
from kinegrade.marks_folder.cells import explain_amount, find_amount, read_records_if_any
from kinegrade.marks_folder.layout import OPEN
from kinegrade.question_numbers import find_bank_number

_NAMED = 5  # students that a message names


class OpenQuestion(NamedTuple):
    """A question that is still to be marked by hand, its points, and the students who lack a mark;
    folders of earlier versions name none. It `counts` where others have a mark for it.
    """

    question: str
    points: Fraction
    students: tuple[str, ...] = ()
    counts: bool = False


def describe_open(questions: Sequence[OpenQuestion]) -> Message:
    """Which nobody has a mark for, one or more, and what totals are of meanwhile."""
    return Message(
        "marks.open",
        count=len(questions),
        questions=list_all([find_bank_number(each.question) for each in questions]),
        points=Message("marks.open-points", count=add_open_points(questions)),
    )


def describe_lacking(question: OpenQuestion) -> Message:
    """Whose marks are missing for a question that others have a mark for."""
    named = [Quoted(student) for student in question.students[:_NAMED]]
    return Message(
        "marks.lacking" if len(question.students) <= _NAMED else "marks.lacking-more",
        count=len(question.students),
        question=find_bank_number(question.question),
        students=list_all(named),
    )


def describe_unmarked(
    where: str, unmarked: Sequence[OpenQuestion], lacking: Iterable[OpenQuestion]
) -> Iterator[Fault]:
    """What is still to be marked by hand: that nobody has a mark for, and that some lack."""
    do = Message("marks.add-by-hand")
    if unmarked:
        yield Fault(where, describe_open(unmarked), do=do)
    for question in lacking:
        yield Fault(where, describe_lacking(question), do=do)


def add_open_points(questions: Iterable[OpenQuestion]) -> Fraction:
    """The points of all of them."""
    return sum((each.points for each in questions), Fraction(0))


def read_open_questions(folder: Path, counted: Collection[str]) -> tuple[OpenQuestion, ...]:
    """The questions of open.csv, of which those `counted` are in the totals; none where there is no
    such file. Raises TableError.
    """
    path = folder / OPEN.name
    points: dict[str, Fraction] = {}
    students: dict[str, list[str]] = {}
    for line, (student, _, _, question, out_of, typed, *_) in read_records_if_any(folder, OPEN):
        # Earlier versions had no column out_of
        column, cell = ("out_of", out_of) if student else ("points", typed)
        amount = find_amount(cell)
        if amount is None:
            raise TableError(explain_amount(path, line, column, cell))
        points[question] = amount
        students.setdefault(question, []).extend([student] if student else [])
    return tuple(
        OpenQuestion(question, amount, tuple(students[question]), question in counted)
        for question, amount in points.items()
    )
