"""What signs and letters stand for, said once, before the first of them: as far as it is so in what
follows.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import cache
from typing import Literal

from kinegrade.language import Language
from kinegrade.language.message import Message
from kinegrade.mechanics.rates import make_turning
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block, Prose, TermTable, say
from kinegrade.worked.formulas.equation import Equation
from kinegrade.worked.formulas.notation import DIGITS, PLACES, Notation
from kinegrade.worked.formulas.precision import MOST_MORE_DIGITS

# Whether directions are told by turns, and in which senses
_Tables = Literal["straight", "turned", "turned-clockwise", "turned-both-ways"]


def find_conventions(blocks: Sequence[Block], case: Case, *, accelerated: bool) -> Prose:
    """The sense in which rotations are positive, with the sense of vectors' letters where tables
    have vectors, and the sign of a turn where one has it.
    """
    first, *others = (
        _state_senses(case, accelerated),
        *_explain_letters(blocks),
        *_explain_words(case.findings.printed),
    )
    for following in others:
        first = Message("solution.sentences", first=first, next=following)
    return case.say(first)


def _state_senses(case: Case, accelerated: bool) -> Message:
    """The sense in which rotations are positive, and where bodies have angular accelerations what
    their letters stand for.
    """
    bodies = case.motion.frames.mechanism.bodies
    turns = any(make_turning(body.name) in case.motion.rates for body in bodies)
    if accelerated and turns:
        return Message("solution.positive-accelerated")
    return Message("solution.positive")


def state_rounding(language: Language, notation: Notation) -> Prose:
    """That values are rounded in print alone, and how: the same for all questions of a paper that
    have as many digits.
    """
    digits, places = DIGITS + notation.more_digits, PLACES + notation.more_digits
    return say(Message("solution.rounded", digits=digits, places=places), language)


def states_rounding(block: Block, language: Language) -> bool:
    """Whether a block says how values are rounded."""
    return isinstance(block, Prose) and block.text in _list_roundings(language)


@cache
def _list_roundings(language: Language) -> frozenset[str]:
    """What a solution may say of how values are rounded."""
    notations = (Notation(more_digits=more) for more in range(MOST_MORE_DIGITS + 1))
    return frozenset(state_rounding(language, notation).text for notation in notations)


def _explain_letters(blocks: Sequence[Block]) -> Iterator[Message]:
    tables = [block for block in blocks if isinstance(block, TermTable)]
    if tables:
        yield Message(f"solution.vector-letters-{_find_turns(tables)}")


def _find_turns(tables: Sequence[TermTable]) -> _Tables:
    """The senses in which the directions of tables are turned from what they name."""
    directions = [term.direction for table in tables for term in table.terms]
    against = any(r"\curvearrowleft" in direction for direction in directions)
    clockwise = any(r"\curvearrowright" in direction for direction in directions)
    match against, clockwise:
        case True, True:
            return "turned-both-ways"
        case True, False:
            return "turned"
        case False, True:
            return "turned-clockwise"
        case _:
            return "straight"


def _explain_words(equations: Iterable[Equation]) -> Iterator[Message]:
    """What words beside a negative value say, where there are such."""
    if any(one.aside and one.links and one.links[-1].right.sign < 0 for one in equations):
        yield Message("solution.true-senses")
