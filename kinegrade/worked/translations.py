"""What follows for the points of bodies that translate, of each body said once."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.language.message import Message
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block


def say_translation(body: str, level: Level, case: Case) -> Iterator[Block]:
    """That the points of a body have one velocity or acceleration; of a further body that it
    translates, too.
    """
    said = case.findings.translated[level]
    if body not in said:
        name = case.naming.body(body)
        too = Message("solution.same-too", body=name)
        yield case.say(too if said else Message(f"solution.same-{level}", body=name))
        said.add(body)
