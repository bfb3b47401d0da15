"""`kinegrade roster`: how a roster is read, before an exam is made of it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator

from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.roster.students import Student
from kinegrade.language.message import Message, Quoted, list_plainly

_MOST_VALUES = 30  # groups or rooms in a line


def describe_roster(roster: Roster) -> Iterator[Message]:
    """How many students there are, the first of them, how the file is read, and how
    many students are in each group, room and language, have extra time or large print.
    """
    students = roster.students
    first = _name(students[0])
    yield _say(roster, Message("roster.count", count=len(students), first=first))
    if roster.way is not None:
        yield from roster.way.notes()
    for what, values in (
        (Message("roster.groups"), (each.group for each in students)),
        (Message("roster.rooms"), (each.room for each in students)),
        (Message("roster.languages"), (each.language for each in students)),
        (Message("roster.extra-times"), (each.extra_time for each in students)),
        (Message("roster.formats"), (each.print_format for each in students)),
    ):
        counted = Counter(filter(None, values))
        if counted:
            listed = list_plainly(_list_counts(counted.items()))
            yield _say(roster, Message("roster.counts", what=what, counts=listed))


def _say(roster: Roster, what: Message) -> Message:
    return Message("terminal.of", where=roster.file, what=what)


def _name(student: Student) -> Message:
    return Message("roster.person", student=Quoted(student.student), name=student.name)


def _list_counts(counted: Iterable[tuple[str, int]]) -> Iterator[Message | str]:
    for place, (text, count) in enumerate(sorted(counted)):
        if place == _MOST_VALUES:
            yield "…"
            return
        yield Message("roster.with-count", text=text, count=count)
