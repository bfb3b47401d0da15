"""In which order the questions stood on papers that were shuffled: printed.csv of a folder of
marks.

`grade` writes it, so that exports can call a question by the number that its student knows. There
is none where every paper has the bank's order.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import msgspec

from kinegrade.csv_writing import write_csv
from kinegrade.errors import ExamError, TableError, one_line
from kinegrade.tables import written_records

PRINTED = "printed.csv"
_HEADER = ("student", "questions")
_STATED = b'"printed"'
_BETWEEN = " "  # no identifier of a question holds one
_MENDING = "expected it as kinegrade generate wrote it - restore the exam folder"

Orders = Mapping[str, tuple[str, ...]]  # by student, the questions as they were printed


class _Head(msgspec.Struct, gc=False):
    student: str
    printed: tuple[str, ...] | None = None  # exams of earlier versions do not state it


def write_printed(marks: Path, exam: Path, questions: Sequence[str]) -> None:
    """Writes the orders that differ from the bank's `questions`; no file where none does.

    Raises ExamError for a paper that states other questions.
    """
    bank = tuple(questions)
    decode = msgspec.json.Decoder(_Head).decode
    rows: list[tuple[str, str]] = []
    path = exam / "key.jsonl"
    with path.open("rb") as lines:
        for number, line in enumerate(lines, 1):
            if line.isspace():
                continue
            # All papers of an exam state their order or none does; reading on would cost as much
            # as marking.
            if _STATED not in line:
                break
            try:
                head = decode(line)
            except (msgspec.MsgspecError, UnicodeDecodeError, RecursionError) as fault:
                raise _unknown(path, number) from fault
            if head.printed is None or head.printed == bank:
                continue
            if sorted(head.printed) != sorted(bank):
                raise _unknown(path, number)
            rows.append((head.student, _BETWEEN.join(head.printed)))
    if rows:
        write_csv(marks / PRINTED, _HEADER, rows)


def read_printed(marks: Path, questions: Sequence[str]) -> Orders:
    """The orders that differ from that of `questions`. Raises TableError."""
    path = marks / PRINTED
    if not path.exists():
        return {}
    found: dict[str, tuple[str, ...]] = {}
    for line, (student, listed) in written_records(path, _HEADER):
        order = tuple(listed.split(_BETWEEN))
        if sorted(order) != sorted(questions):
            raise TableError(
                f'{path}:{line}: questions is "{one_line(listed[:40])}" - expected the questions '
                "of grades.csv in the order of the paper - grade again"
            )
        found[student] = order
    return found


def _unknown(path: Path, line: int) -> ExamError:
    return ExamError(
        f'{path}: line {line}: "printed" is not an order of the questions - {_MENDING}'
    )
