"""Grades that stood in a download and are replaced by others: somebody may have put them there."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from kinegrade.files.cell_text import is_answered, shorten, trim
from kinegrade.language.message import Fault, Message, Quoted, list_plainly
from kinegrade.lms.grades.cells import Cell, Record
from kinegrade.lms.grades.filling_task import FillingTask
from kinegrade.lms.grades.item_candidates import number
from kinegrade.lms.grades.matching import Matching

_MOST_SHOWN = 5


def find_replaced(
    task: FillingTask, rows: Sequence[Record], matching: Matching, changes: Mapping[Cell, str]
) -> Iterator[Fault]:
    """A note for each column in which other grades stood: how many, and the first of them."""
    for column in task.columns.values():
        cells = ((row.line, row.cells[column.place]) for row in rows)
        shown = [
            Message(
                "grades.other-grade",
                student=Quoted(matching.students[line].student),
                before=shorten(trim(cell.text)),
                after=changes[cell],
            )
            for line, cell in cells
            if cell in changes and _is_other(trim(cell.text), changes[cell])
        ]
        if shown:
            more = ["…"] if len(shown) > _MOST_SHOWN else []
            students = list_plainly([*shown[:_MOST_SHOWN], *more])
            what = Message("grades.replaced", count=len(shown), students=students)
            yield Fault(f'{task.table.file}: "{column.header}"', what)


def _is_other(before: str, after: str) -> bool:
    """Whether a cell held something else than what it gets; "-" is nothing."""
    return is_answered(before) and number(before) != number(after)
