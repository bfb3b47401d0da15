"""What a person should look at before the papers of a roster are handed out."""

from __future__ import annotations

from kinegrade.exam.roster import Roster, complain_of_unprintable_id
from kinegrade.press.protocol import Press


def roster_complaints(roster: Roster, press: Press) -> tuple[str, ...]:
    """The roster's oddities, and characters of names and ids that no font has."""
    owners = (text for student in roster.students for text in (student.name, student.student))
    missing = press.unprintable(owners)
    said = [*map(str, roster.complaints)]
    for student in roster.students:
        if missing & set(student.name):
            said.append(
                f"{student.student}: the name has characters that no font prints, they stand as "
                "code points"
            )
        odd = {each for each in student.student if each in missing or not each.isprintable()}
        if odd:
            said.append(str(complain_of_unprintable_id(roster.file, student, odd)))
    return tuple(said)
