"""The places of a class: each student has one, and gets what the exam deals to it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from kinegrade.draws.keyed_order import address
from kinegrade.exam.roster.students import make_student_key


def assign_places(students: Iterable[str], secret: str, kept: Mapping[str, int]) -> dict[str, int]:
    """The place of each student, counted from zero, no two alike, in the order of the places.

    A place depends on who is in the class and on the secret, and not on the order of the roster.
    `kept` are the places of an exam that exists: they stay, even those of students who have left,
    and all others come after them.
    """
    new = sorted(
        (student for student in students if student not in kept),
        key=lambda student: address(secret, "place", make_student_key(student)),
    )
    first = max(kept.values(), default=-1) + 1
    places = {**kept, **{student: place for place, student in enumerate(new, first)}}
    return dict(sorted(places.items(), key=lambda entry: entry[1]))
