"""Whose lines a key holds: one for each candidate, and no others; and whose papers were another's
before.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator

from kinegrade.exam.folder.contents import HEAD
from kinegrade.exam.folder.records import ExamHead
from kinegrade.language.message import Message, Quoted


def find_ownership_faults(
    owners: Collection[str], candidates: Collection[str]
) -> Iterator[Message]:
    """What is wrong with the students of the lines: students with several lines, candidates with
    none, and students who are not candidates.
    """
    yield from find_repetitions(owners)
    for student in sorted(set(candidates).difference(owners)):
        yield Message("exam.no-line", student=Quoted(student))
    for student in sorted(set(owners).difference(candidates)):
        yield Message("exam.strange-student", student=Quoted(student), head=HEAD)


def find_repetitions(owners: Collection[str]) -> Iterator[Message]:
    """A fault for each student with several lines."""
    for student, count in Counter(owners).items():
        if count > 1:
            yield Message("exam.repeated-student", student=Quoted(student), count=count)


def list_moved(head: ExamHead, corrections: int) -> Iterator[str]:
    """The students who had other papers than now when the key had that many corrections."""
    then: dict[str, str] = {}
    for each in head.papers_before:
        if each.correction > corrections:
            then.setdefault(each.student, each.paper)
    for before, paper in then.items():
        student = head.former_ids.get(before, before)
        if student in head.candidates and head.candidates[student].paper != paper:
            yield student
