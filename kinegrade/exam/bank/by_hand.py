"""The questions of a bank that have no mechanism: texts, whose answers are marked by hand.

[[questions]]  # the third: a translation beside the bank has its texts in the table [q3]
text = { en = "What is an instantaneous centre?", zh = "什么是速度瞬心？" }
points = 5
space = "6 cm"
"""

from __future__ import annotations

from fractions import Fraction

from msgspec import Struct

from kinegrade.exam.bank.keys import BY_HAND, COUNTED, TEXT
from kinegrade.exam.bank.terms import read_points, read_room
from kinegrade.files.fields.place import Place
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import flag
from kinegrade.problem.template.translated import Translated
from kinegrade.problem.template.translations import translated

_NO_TITLE = Translated(plain="")


class HandQuestion(Struct, frozen=True):
    """A question to be marked by hand: its title, empty for none, and its text, both Markdown with
    LaTeX math; `space` is the millimetres left for the answer, `bonus` whether its points come on
    top of the maximum.
    """

    identifier: str
    title: Translated
    text: Translated
    points: Fraction
    space: float
    bonus: bool = False

    @property
    def number(self) -> int:
        """Its number on every paper, shuffled or not: that of its place in the bank."""
        return int(self.identifier.removeprefix("q"))


def find_hand_places(questions: object) -> dict[Place, Place]:
    """Where a translation may have texts of questions to be marked by hand, by their identifiers,
    and where they go.
    """
    places: dict[Place, Place] = {}
    number = 1
    for index, entry in enumerate(questions if isinstance(questions, list) else ()):
        stated = entry if isinstance(entry, dict) else {}
        for key in ("title", "text") if "text" in stated else ():
            if key in stated:
                places[f"q{number}", key] = ("questions", index, key)
        count = stated.get("number", 1)
        number += count if isinstance(count, int) else 1
    return places


def read_hand_question(entry: Table, identifier: str, space: float) -> HandQuestion | None:
    """The question of an entry `[[questions]]` with a text; `space` where it states none. None
    after a fault.
    """
    known = entry.only(*TEXT, *BY_HAND, *COUNTED)
    text = known.required("text", translated)
    points = known.required("points", read_points)
    title = known.with_default("title", translated, _NO_TITLE)
    room = known.with_default("space", read_room, space)
    bonus = known.with_default("bonus", flag, False)
    if text is None or points is None:
        return None
    return HandQuestion(identifier, title, text, points, room, bonus)
