"""Who is excused from which exam of a term, and for whom one that they sat is set aside: it does
not count for them.

[excused]
HW2 = ["1002", "1004"]

[set-aside]
FINAL = ["1003"]
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from kinegrade.errors import PolicyError, suggest
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import text
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.marks_folder.rows import ClassTotals

_EXCUSED, _SET_ASIDE = "excused", "set-aside"
Excuses = Mapping[str, frozenset[str]]  # for an exam, by its name, the ids of students


def read_excuses(stated: Table, names: Sequence[str]) -> Excuses:
    """The excuses that a plan's table states, for the exams of these names; notes faults."""
    for name in stated:
        if name not in names:
            what = Message("term.unknown-marks", name=Quoted(name), hint=suggest(name, names))
            stated.fault(name, what)
    return {name: frozenset(stated.listing(name, text, '"1002"')) for name in stated}


def require_excusable(
    file: Path, excused: Excuses, set_aside: Excuses, exams: Mapping[str, ClassTotals]
) -> None:
    """Raises PolicyError with all students who are in no exam, or who sat the exam from which they
    are excused: one that they sat is to be set aside.
    """
    faults = (
        *_find_unknown(f"{file}: {_EXCUSED}", excused, exams),
        *_find_present(f"{file}: {_EXCUSED}", excused, exams),
        *_find_unknown(f"{file}: {_SET_ASIDE}", set_aside, exams),
    )
    if faults:
        raise PolicyError(*faults)


def _find_unknown(
    where: str, excuses: Excuses, exams: Mapping[str, ClassTotals]
) -> Iterator[Fault]:
    """A fault for each student who is in no exam."""
    known = {each.student for totals in exams.values() for each in totals.students}
    for name, students in excuses.items():
        for student in sorted(students - known):
            yield Fault(
                f"{where}.{name}",
                Message("term.no-student", student=Quoted(student)),
                Message("term.a-listed-student"),
                suggest(student, known),
            )


def _find_present(
    where: str, excuses: Excuses, exams: Mapping[str, ClassTotals]
) -> Iterator[Fault]:
    """A fault for each student who sat the exam."""
    for name, students in excuses.items():
        sat = {each.student for each in exams[name].students if each.is_present}
        for student in sorted(students & sat):
            yield Fault(
                f"{where}.{name}",
                Message("term.sat", student=Quoted(student), name=name),
                Message("term.one-who-has-not"),
                Message("term.leave-out"),
            )
