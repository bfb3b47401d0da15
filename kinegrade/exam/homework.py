"""What a bank states of homework: that it is some, which sheet of a series, and when it is due.

kind = "homework"
sheet = 3
due = 2026-12-01T18:00:00
"""

from __future__ import annotations

from dataclasses import dataclass
from datetime import datetime
from typing import Literal, assert_never, get_args

from kinegrade.deadlines.moment import read_moment
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import choice, whole
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.known import known_languages
from kinegrade.language.message import Message
from kinegrade.problem.template.translated import Translated

Kind = Literal["exam", "homework"]
KINDS: tuple[Kind, ...] = get_args(Kind)
MOST_SHEETS = 60


@dataclass(frozen=True, slots=True)
class Homework:
    """What is set, None where that is not stated; the number of the sheet in its series, 0 for
    none; and when it is due, None where that is not stated.
    """

    stated: Kind | None = None
    sheet: int = 0
    due: datetime | None = None

    @property
    def kind(self) -> Kind:
        """What is set: an exam unless the bank says otherwise."""
        return self.stated or "exam"


AN_EXAM = Homework()


def read_homework(table: Table) -> Homework:
    """What a bank states; after a fault, what holds where nothing is stated."""
    return Homework(
        table.optional("kind", choice(KINDS)),
        table.with_default("sheet", whole(1, MOST_SHEETS), 0),
        table.optional("due", read_moment),
    )


def number_title(title: Translated, homework: Homework) -> Translated:
    """The title of a sheet of a series in every language that it has: "Homework 3: Velocities"."""
    if not homework.sheet:
        return title
    spoken = [language for language in known_languages() if title.has(language)]
    numbered = (
        open_catalogue(language).write(_say_number(title.in_language(language), homework))
        for language in spoken
    )
    return Translated(tuple(zip(spoken, numbered, strict=True)))


def _say_number(title: str, homework: Homework) -> Message:
    """A title with the number of the sheet."""
    match homework.kind:
        case "homework":
            return Message("exam.homework-title", number=homework.sheet, title=title)
        case "exam":
            return Message("exam.exam-title", number=homework.sheet, title=title)
        case _:
            assert_never(homework.kind)
