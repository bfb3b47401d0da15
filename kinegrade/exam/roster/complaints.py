"""What a person should look at before the papers of a roster are handed out."""

from __future__ import annotations

from kinegrade.errors import Problem
from kinegrade.exam.roster.roster import Roster, complain_of_unprintable_id
from kinegrade.language.message import Fault, Message
from kinegrade.press.protocol import Press


def roster_complaints(roster: Roster, press: Press) -> tuple[Problem, ...]:
    """The roster's oddities, and characters of names and ids that no font has."""
    owners = (text for student in roster.students for text in (student.name, student.student))
    missing = press.unprintable(owners)
    said: list[Problem] = [each.fault for each in roster.complaints]
    for student in roster.students:
        if missing & set(student.name):
            said.append(Fault(student.student, Message("roster.unprintable-name")))
        odd = {each for each in student.student if each in missing or not each.isprintable()}
        if odd:
            said.append(complain_of_unprintable_id(roster.file, student, odd).fault)
    return tuple(said)
