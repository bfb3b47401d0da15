"""Papers without a student, for those who come unannounced: named `spare-1`, `spare-2` ... until
they are assigned.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import replace
from itertools import count, islice

from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.roster.students import Student, choose_places, make_file_names, make_student_key

_NAME = "spare-{}"


def name_spares() -> Iterator[str]:
    """The names of spare papers, as many as are wanted."""
    return map(_NAME.format, count(1))


def add_spare_papers(
    roster: Roster, wanted: int, existing: Collection[str], *, files: int = 1
) -> Roster:
    """The roster with as many spare papers behind its students; those that exist stay, whatever is
    wanted. All have the places of their files, so many for each paper.
    """
    taken = {make_student_key(each.student) for each in roster.students}
    free = (name for name in name_spares() if name not in taken and name not in existing)
    spares = [*existing, *islice(free, max(wanted - len(existing), 0))]
    stems = make_file_names([*(each.student for each in roster.students), *spares])
    places = dict(zip(stems, choose_places(list(stems.values()), each=files), strict=True))
    students = tuple(replace(each, file_name=places[each.student]) for each in roster.students)
    papers = (Student(name, "", "", places[name], spare=True) for name in spares)
    return replace(roster, students=(*students, *papers))
