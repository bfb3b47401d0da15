"""Students who may have two lines in a term: under an id and under that id without its zeros, or
under the id that they had before.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

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


def find_renamed_students(
    exams: Exams, former_ids: Mapping[str, Mapping[str, str]]
) -> Iterator[Fault]:
    """A complaint for each id that another exam has as the former one of somebody; `former_ids`
    are the students by them, by exam.
    """
    for name, now in former_ids.items():
        for formerly, student in now.items():
            old = [
                other
                for other, totals in exams.items()
                if other != name and formerly in totals.by_student
            ]
            if old:
                what = Message(
                    "term.renamed-student",
                    before=Quoted(formerly),
                    names=list_plainly(old),
                    now=Quoted(student),
                    name=name,
                )
                yield Fault(formerly, what, do=Message("term.rename-everywhere"))
