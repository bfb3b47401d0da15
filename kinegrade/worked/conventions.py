"""What signs and letters stand for, said once, before the first of them: as far as it is so in what
follows.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Literal

from kinegrade.language.message import Message
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block, Prose, TermTable

_Tables = Literal["turned", "straight"]  # whether directions are told by a turn


def find_convention(blocks: Sequence[Block], case: Case) -> Prose:
    """The sense in which rotations are positive; the sense of vectors' letters where tables have
    vectors, with the sign of a turn where one has it.
    """
    said = [Message("solution.positive"), *_explain_letters(blocks), Message("solution.rounded")]
    first, *others = said
    for following in others:
        first = Message("solution.sentences", first=first, next=following)
    return case.say(first)


def _explain_letters(blocks: Sequence[Block]) -> Iterator[Message]:
    tables = [block for block in blocks if isinstance(block, TermTable)]
    turned = any(r"\curvearrow" in term.direction for table in tables for term in table.terms)
    if tables:
        told: _Tables = "turned" if turned else "straight"
        yield Message(f"solution.vector-letters-{told}")
