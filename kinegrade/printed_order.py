"""In which order the questions stood on papers that were shuffled: printed.csv of a folder of
marks.

`grade` writes it, so that exports can call a question by the number that its student knows. There
is none where every paper has the bank's order.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from kinegrade.csv_writing import write_csv
from kinegrade.errors import TableError, one_line
from kinegrade.tables import written_records

PRINTED = "printed.csv"
_HEADER = ("student", "questions")
_BETWEEN = " "  # no identifier of a question holds one

Orders = Mapping[str, tuple[str, ...]]  # by student, the questions as they were printed


def write_printed(marks: Path, orders: Orders) -> None:
    """Writes the orders that differ from the bank's; no file where none does."""
    if orders:
        rows = ((student, _BETWEEN.join(order)) for student, order in orders.items())
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
