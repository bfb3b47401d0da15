"""What signs and letters stand for, said once, before the first of them: as far as it is so in what
follows.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Literal

from kinegrade.language import Language
from kinegrade.language.message import Message
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block, Prose, TermTable, say

_Tables = Literal["turned", "straight"]  # whether directions are told by a turn


def find_conventions(blocks: Sequence[Block], case: Case) -> tuple[Prose, Prose]:
    """The sense in which rotations are positive, with the sense of vectors' letters where tables
    have vectors, and the sign of a turn where one has it; and that values are rounded.
    """
    first, *others = (Message("solution.positive"), *_explain_letters(blocks))
    for following in others:
        first = Message("solution.sentences", first=first, next=following)
    return case.say(first), state_rounding(case.language)


def state_rounding(language: Language) -> Prose:
    """That values are rounded in print alone: the same for all questions of a paper."""
    return say(Message("solution.rounded"), language)


def _explain_letters(blocks: Sequence[Block]) -> Iterator[Message]:
    tables = [block for block in blocks if isinstance(block, TermTable)]
    turned = any(r"\curvearrow" in term.direction for table in tables for term in table.terms)
    if tables:
        told: _Tables = "turned" if turned else "straight"
        yield Message(f"solution.vector-letters-{told}")
