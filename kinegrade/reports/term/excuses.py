"""Who is excused from which exam of a term, and for whom one that they sat is set aside: it does
not count for them.

[excused]
HW2 = ["1002", "1004"]

[set-aside]
FINAL = ["1003"]
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from pathlib import Path

from kinegrade.errors import PolicyError, suggest
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import text
from kinegrade.language.message import Fault, Message, Quoted, Text, list_choices
from kinegrade.marks_folder.rows import ClassTotals

_EXCUSED, _SET_ASIDE = "excused", "set-aside"
Excuses = Mapping[str, frozenset[str]]  # for an exam, by its name, the ids of students
FormerIds = Mapping[str, Mapping[str, str]]  # by exam, the students by ids that they had before


def read_excuses(stated: Table, names: Sequence[str]) -> Excuses:
    """The excuses that a plan's table states, for the exams of these names; notes faults."""
    for name in stated:
        if name not in names:
            what = Message("term.unknown-marks", name=Quoted(name), hint=suggest(name, names))
            stated.fault(name, what)
    return {name: frozenset(stated.listing(name, text, '"1002"')) for name in stated}


def find_present_ids(
    excuses: Excuses, exams: Mapping[str, ClassTotals], former_ids: FormerIds
) -> Excuses:
    """The same by the ids that students have in that exam, or else in any, where an id that one had
    before leads to one student alone.
    """
    known = {each.student for totals in exams.values() for each in totals.students}

    def find(name: str, student: str) -> str:
        here = former_ids.get(name, {})
        if student in here or student in known:
            return here.get(student, student)
        owners = _find_owners(student, former_ids)
        return owners[0] if len(owners) == 1 else student

    return {
        name: frozenset(find(name, student) for student in students)
        for name, students in excuses.items()
    }


def _find_owners(student: str, former_ids: FormerIds) -> list[str]:
    """Who had an id before, by the last ids that are known of them."""
    owners = {now[student] for now in former_ids.values() if student in now}
    later = {each: now[each] for now in former_ids.values() for each in owners if each in now}
    return sorted({later.get(owner, owner) for owner in owners})


def require_excusable(
    file: Path,
    excused: Excuses,
    set_aside: Excuses,
    exams: Mapping[str, ClassTotals],
    former_ids: FormerIds,
) -> None:
    """Raises PolicyError with all students who are in no exam, or who sat the exam from which they
    are excused: one that they sat is to be set aside.
    """
    faults = (
        *_find_unknown(f"{file}: {_EXCUSED}", excused, exams, former_ids),
        *_find_present(f"{file}: {_EXCUSED}", excused, exams),
        *_find_unknown(f"{file}: {_SET_ASIDE}", set_aside, exams, former_ids),
    )
    if faults:
        raise PolicyError(*faults)


def _find_unknown(
    where: str, excuses: Excuses, exams: Mapping[str, ClassTotals], former_ids: FormerIds
) -> Iterator[Fault]:
    """A fault for each student who is in no exam."""
    known = {each.student for totals in exams.values() for each in totals.students}
    for name, students in excuses.items():
        for student in sorted(students - known):
            what = Message("term.no-student", student=Quoted(student))
            hint = _hint(student, _find_owners(student, former_ids), known)
            yield Fault(f"{where}.{name}", what, Message("term.a-listed-student"), hint)


def _hint(student: str, owners: Sequence[str], known: Collection[str]) -> Text:
    """Who has that id now, or else whose is written alike."""
    if not owners:
        return suggest(student, known)
    students = list_choices(map(Quoted, owners))
    return Message("term.present-id", student=Quoted(student), students=students)


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
