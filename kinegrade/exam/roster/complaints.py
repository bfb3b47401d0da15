"""What a person should look at before the papers of a roster are handed out."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from kinegrade.errors import Problem
from kinegrade.exam.roster.students import Student
from kinegrade.language.message import Fault, Message, Text, list_plainly
from kinegrade.press.protocol import Press
from kinegrade.press.typst.press import TypstPress

if TYPE_CHECKING:  # it loads all that reads a roster, which a single paper does not need
    from kinegrade.exam.roster.roster import Roster


def roster_complaints(roster: Roster, press: Press) -> tuple[Problem, ...]:
    """The roster's oddities, and characters of names and ids that no font has."""
    odd = (each.fault for each in roster.complaints)
    return (*odd, *find_unprintable(roster.students, roster.file, press))


def find_unprintable(students: Iterable[Student], file: str, press: Press) -> Iterator[Problem]:
    """The characters of names and ids that no font has; `file` is that of the roster."""
    listed = list(students)
    missing = press.unprintable(text for each in listed for text in (each.name, each.student))
    # The usual typesetter has more letters than the fonts of LaTeX
    always = TypstPress().unprintable(missing) if missing else frozenset()
    for student in listed:
        if lacks := missing & set(student.name):
            do: Text = "" if lacks & always else Message("roster.typst-prints")
            yield Fault(student.student, Message("roster.unprintable-name"), do=do)
        odd = {each for each in student.student if each in missing or not each.isprintable()}
        if odd:
            yield _explain_unprintable_id(file, student, odd)


def _explain_unprintable_id(file: str, student: Student, characters: Iterable[str]) -> Fault:
    """Characters of an id that do not print: it cannot be typed as it stands on the paper."""
    codes = list_plainly(f"U+{ord(character):04X}" for character in sorted(set(characters)))
    whose = student.name or Message("roster.nameless")
    problem = Message("roster.unprintable-id", whose=whose, codes=codes)
    place = f"{file}:{student.line}" if student.line else file
    where = ": ".join((place, "student"))
    return Fault(where, problem, do=Message("roster.unprintable-id-done"))
