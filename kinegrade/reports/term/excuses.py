"""Who is excused from which exam of a term: it does not count for them.

[excused]
HW2 = ["1002", "1004"]
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from kinegrade.errors import PolicyError, suggest
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import text
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.marks_folder.rows import ClassTotals

_TABLE = "excused"
Excuses = Mapping[str, frozenset[str]]  # for an exam, by its name, the ids of students


def read_excuses(stated: Table, names: Sequence[str]) -> Excuses:
    """The excuses that a plan's table states, for the exams of these names; notes faults."""
    for name in stated:
        if name not in names:
            what = Message("term.unknown-marks", name=Quoted(name), hint=suggest(name, names))
            stated.fault(name, what)
    return {name: frozenset(stated.listing(name, text, '"1002"')) for name in stated}


def require_excusable(file: Path, excuses: Excuses, exams: Mapping[str, ClassTotals]) -> None:
    """Raises PolicyError with all excuses of students who are in no exam, or who sat the exam from
    which they are excused.
    """
    faults = tuple(
        Fault(f"{file}: {_TABLE}.{name}", *said)
        for name, students in excuses.items()
        for said in _list_unfit(name, students, exams)
    )
    if faults:
        raise PolicyError(*faults)


def _list_unfit(
    name: str, students: frozenset[str], exams: Mapping[str, ClassTotals]
) -> Iterator[tuple[Message, Message, Message]]:
    """What is wrong with the excuses from an exam, what was expected and what to do."""
    known = {each.student for totals in exams.values() for each in totals.students}
    sat = {each.student for each in exams[name].students if each.is_present}
    for student in sorted(students - known):
        yield (
            Message("term.no-student", student=Quoted(student)),
            Message("term.a-listed-student"),
            suggest(student, known),
        )
    for student in sorted(students & sat):
        yield (
            Message("term.sat", student=Quoted(student), name=name),
            Message("term.one-who-has-not"),
            Message("term.leave-out"),
        )
