"""The layout of a marks folder: the names of its files and columns, in one place for writing and
reading.

Columns are found by name, so columns added by a later version do no harm.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, Literal, NamedTuple


class TableFile(NamedTuple):
    """A file of the folder that is a table: its columns in the order in which they are written, and
    those that may be missing.
    """

    name: str
    columns: tuple[str, ...]
    optional: tuple[str, ...] = ()


class AnswerCells(NamedTuple):
    """Lines of marks.csv, column by column: cells as they stand in the CSV file, all columns of one
    length. A class is written faster this way than line by line.
    """

    student: Sequence[str]
    question: Sequence[str]
    ask: Sequence[str]
    response: Sequence[str]
    read_as: Sequence[str]
    unit: Sequence[str]
    verdict: Sequence[str]
    points: Sequence[str]
    out_of: Sequence[str]
    reason: Sequence[str]
    mistakes: Sequence[str]
    rule: Sequence[str]


# grades.csv has a column for each question between these
_BEFORE_QUESTIONS = ("student", "name")
_AFTER_QUESTIONS = ("total", "out_of", "percent", "status")
_KEPT_AMOUNTS = ("before", "before_out_of", "by_this_marking", "out_of", "stands")

# Earlier versions named the mistakes and the policy in the reason alone
ANSWERS: Final = TableFile("marks.csv", AnswerCells._fields, optional=("mistakes", "rule"))
MISTAKE: Final = "mistake"  # the verdict on an answer that known mistakes lead to
NAMES_BETWEEN: Final = " "  # identifiers of mistakes contain no blank
BY_POLICY: Final = "policy"  # the rule of an answer that was not compared by the paper's
# Earlier versions wrote no status
GRADES: Final = TableFile(
    "grades.csv", (*_BEFORE_QUESTIONS, *_AFTER_QUESTIONS), optional=("percent", "status")
)
COMPLAINTS: Final = TableFile(
    "complaints.csv", ("file", "line", "column", "content", "problem", "done")
)
# Only with --never-lower
KEPT: Final = TableFile("kept.csv", ("student", "name", *_KEPT_AMOUNTS, "reason"))
# Only where questions came from a pool: whose line of the key each answer was marked by
PUT: Final = TableFile("variants.csv", ("student", "question", "ask", "key_of"))
# Only where questions stood in a different order from the bank's
PRINTED: Final = TableFile("printed.csv", ("student", "questions"))
QUESTIONS_BETWEEN: Final = " "  # question identifiers contain no blank
POLICY: Final = "policy.toml"
_TABLES = (ANSWERS, GRADES, COMPLAINTS, KEPT, PUT, PRINTED)
FILES: Final = (*(file.name for file in _TABLES), POLICY)
MARKER: Final = COMPLAINTS.name  # the file by which kinegrade recognises a marks folder

Status = Literal["marked", "absent"]  # absent: answered nothing at all
STATUSES: Final[tuple[Status, ...]] = ("marked", "absent")
FOR_PEOPLE: Final = (GRADES, ANSWERS, COMPLAINTS)
_OF_NUMBERS = {"points", "total", "out_of", "percent", "line"}  # besides the questions
TEXT_COLUMNS: Final = frozenset(name for file in FOR_PEOPLE for name in file.columns) - _OF_NUMBERS


def make_grades_header(questions: tuple[str, ...]) -> tuple[str, ...]:
    """The columns of grades.csv for these questions."""
    return (*_BEFORE_QUESTIONS, *questions, *_AFTER_QUESTIONS)
