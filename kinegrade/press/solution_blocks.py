"""What every layout asks of a worked solution: what stays together, and what stands beside a
drawing.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import takewhile
from typing import assert_never

from kinegrade.language.message import Message
from kinegrade.press.sheet import WorkedQuestion
from kinegrade.question_numbers import find_other_number
from kinegrade.worked.document import Block, Display, Heading, Pictures, Prose, TermTable

FORMULA_ALONE = r"\$[^$]+\$"
UNKNOWN = "?"


def stays(block: Block, following: Block | None = None, third: Block | None = None) -> bool:
    """Whether a block stays on the page of the next one.

    So do a heading with what it heads, a table of terms with its projection, a sentence with the
    equation it announces.

    >>> stays(Prose("Projected on AB:"), Display(()))
    True
    """
    match block, following, third:
        case [Heading(), _, _] | [Prose(), Display() | TermTable(), _]:
            return True
        case [TermTable(), Display(), _] | [TermTable(), Prose(), Display()]:
            return True
        # Any other neighbours may be parted: what stays together is named, a new block stands alone
        case _:
            return False


@dataclass(frozen=True)
class Placed:
    """A block, and whether it stays on the page of the next one."""

    block: Block
    stays: bool


Chain = tuple[Placed, ...]  # blocks that stay together


@dataclass(frozen=True)
class Passage:
    """Drawings, and the chains of blocks of which as many stand beside them as find room there."""

    pictures: Pictures
    beside: tuple[Chain, ...]


@dataclass(frozen=True)
class Course:
    """The blocks of a solution as they are laid out: those that may stand beside the question's
    figure, and all that follow.
    """

    leading: tuple[Chain, ...]
    following: tuple[Placed | Passage, ...]


def set_course(blocks: Sequence[Block]) -> Course:
    """What of a solution may stand beside which drawing.

    >>> set_course([Prose("So:"), Display(()), Pictures(())]).leading[0][1].stays
    False
    """
    chains = list(_chain_blocks(blocks))
    leading = tuple(takewhile(lambda chain: not _needs_width(chain), chains))
    return Course(leading, tuple(_list_following(chains[len(leading) :])))


def _chain_blocks(blocks: Sequence[Block]) -> Iterator[Chain]:
    chain: Chain = ()
    for place, block in enumerate(blocks):
        placed = Placed(block, stays(*blocks[place : place + 3]))
        chain = (*chain, placed)
        if not placed.stays:
            yield chain
            chain = ()
    if chain:
        yield chain


def _list_following(chains: Sequence[Chain]) -> Iterator[Placed | Passage]:
    """The blocks of the chains; drawings with the narrow chains that follow them."""
    place = 0
    while place < len(chains):
        *before, last = chains[place]
        yield from before
        place += 1
        match last.block:
            case Pictures() as pictures:
                beside = tuple(takewhile(_is_narrow, chains[place:]))
                yield Passage(pictures, beside)
                place += len(beside)
            case Heading() | Prose() | Display() | TermTable():
                yield last
            case _:
                assert_never(last.block)


def _is_narrow(chain: Chain) -> bool:
    """Whether a chain is of sentences and equations alone."""
    return all(isinstance(placed.block, Prose | Display) for placed in chain)


def _needs_width(chain: Chain) -> bool:
    """Whether a chain holds a table or drawings."""
    return any(isinstance(placed.block, TermTable | Pictures) for placed in chain)


def name_question(question: WorkedQuestion) -> Message:
    """The heading of a question, with its number in the answer sheet where that is another."""
    other = find_other_number(question.identifier, question.number)
    if other is None:
        return Message("solution.question", number=question.number)
    return Message("solution.question-known", number=question.number, known=other)
