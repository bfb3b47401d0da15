"""What signs and letters stand for, said once, before the first of them: as far as it is so in what
follows.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Literal

from kinegrade.language import Language
from kinegrade.language.message import Message
from kinegrade.mechanics.rates import make_turning
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block, Prose, TermTable, say

_Tables = Literal["turned", "straight"]  # whether directions are told by a turn


def find_conventions(
    blocks: Sequence[Block], case: Case, *, accelerated: bool
) -> tuple[Prose, Prose]:
    """The sense in which rotations are positive, with the sense of vectors' letters where tables
    have vectors, and the sign of a turn where one has it; and that values are rounded.
    """
    first, *others = (_state_senses(case, accelerated), *_explain_letters(blocks))
    for following in others:
        first = Message("solution.sentences", first=first, next=following)
    return case.say(first), state_rounding(case.language)


def _state_senses(case: Case, accelerated: bool) -> Message:
    """The sense in which rotations are positive, and where bodies have angular accelerations what
    their letters stand for.
    """
    bodies = case.motion.frames.mechanism.bodies
    turns = any(make_turning(body.name) in case.motion.rates for body in bodies)
    if accelerated and turns:
        return Message("solution.positive-accelerated")
    return Message("solution.positive")


def state_rounding(language: Language) -> Prose:
    """That values are rounded in print alone: the same for all questions of a paper."""
    return say(Message("solution.rounded"), language)


def _explain_letters(blocks: Sequence[Block]) -> Iterator[Message]:
    tables = [block for block in blocks if isinstance(block, TermTable)]
    turned = any(r"\curvearrow" in term.direction for table in tables for term in table.terms)
    if tables:
        told: _Tables = "turned" if turned else "straight"
        yield Message(f"solution.vector-letters-{told}")
