"""Ids that have one name in one exam and another one in another: somebody's marks may be those of
somebody else, as where an id was mistyped in the roster of a make-up exam.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from kinegrade.exam.roster.student_names import are_unlike
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.marks_folder.rows import ClassTotals


def find_unlike_names(exams: Mapping[str, ClassTotals]) -> Iterator[Fault]:
    """A complaint for each student whose name in an exam is not that in the first which has one;
    the exams by what they are called.
    """
    first: dict[str, tuple[str, str]] = {}
    for exam, totals in exams.items():
        for each in totals.students:
            if not each.name:
                continue
            before, name = first.setdefault(each.student, (exam, each.name))
            if are_unlike(name, each.name):
                what = Message(
                    "marks.other-name",
                    student=Quoted(each.student),
                    name=Quoted(each.name),
                    before=Quoted(name),
                    exam=before,
                )
                yield Fault(exam, what, do=Message("marks.check-id"))
