"""Students who may have two lines in a term: under an id, and under that id without its zeros."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.exam.roster.student_ids import find_zero_twins
from kinegrade.language.message import Fault, Message, Quoted, list_all, list_plainly
from kinegrade.reports.term.results import Exams


def find_split_students(exams: Exams) -> Iterator[Fault]:
    """A complaint for each; ids that one exam has both are those of two people."""
    listed = {name: {each.student for each in totals.students} for name, totals in exams.items()}
    everybody = [each.student for totals in exams.values() for each in totals.students]
    for twins in find_zero_twins(everybody):
        if any(len(students & {*twins}) > 1 for students in listed.values()):
            continue
        shown = [
            Message("term.listed-in", student=Quoted(twin), names=list_plainly(names))
            for twin in twins
            if (names := [name for name, students in listed.items() if twin in students])
        ]
        what = Message("term.split-student", students=list_all(shown))
        yield Fault(twins[0], what, do=Message("term.split-lines"))
