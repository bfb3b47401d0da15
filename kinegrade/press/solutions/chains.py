"""What every layout asks of a worked solution: what stays together on a page."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import takewhile, zip_longest
from typing import assert_never

from kinegrade.language.math.printed_size import FIRST_CHINESE
from kinegrade.language.message import Message
from kinegrade.press.sheet import WorkedQuestion
from kinegrade.press.solutions.equations import MeasuredDisplay, measure_display
from kinegrade.question_numbers import find_other_number
from kinegrade.worked.document import Block, Display, Heading, Pictures, Prose, TermTable

FORMULA_ALONE = r"\$[^$]+\$"
UNKNOWN = "?"
_GIVENS = 3  # equations before the first step of a chapter that stay with it


def stays(block: Block, following: Block | None = None, third: Block | None = None) -> bool:
    """Whether a block stays on the page of the next one.

    So do a heading with what it heads, a table of terms with its drawings and its projection, a
    sentence with the equation it announces.

    >>> stays(Prose("Projected on AB:"), Display(()))
    True
    """
    match block, following, third:
        case [Heading(), _, _] | [Prose(), Display() | TermTable(), _]:
            return True
        case [TermTable(), Display() | Pictures(), _] | [TermTable(), Prose(), Display()]:
            return True
        # Any other neighbours may be parted: what stays together is named, a new block stands alone
        case _:
            return False


TextBlock = Heading | Prose | MeasuredDisplay | TermTable


@dataclass(frozen=True, eq=False)  # one is itself alone: quick to look up
class Placed:
    """A block of text, and whether it stays on the page of the next block."""

    block: TextBlock
    stays: bool


Chain = tuple[Placed, ...]  # blocks that stay together


def join_sentences(blocks: Sequence[Block]) -> Iterator[Block]:
    """The blocks with sentences that follow one another as one paragraph; a sentence that announces
    a single equation stays by itself, as both may have room on one line.

    >>> list(join_sentences([Prose("So."), Prose("Then.")]))
    [Prose(text='So. Then.')]
    """
    said = ""
    for block, following in zip_longest(blocks, blocks[1:]):
        alone = isinstance(following, Display) and len(following.lines) == 1
        joined = block.text if isinstance(block, Prose) and not block.compact else None
        if said and (alone or joined is None):
            yield Prose(said)
            said = ""
        if joined is not None:
            said = _join_texts(said, joined)
        elif block is not None:
            yield block
    if said:
        yield Prose(said)


def _join_texts(said: str, more: str) -> str:
    """Two sentences, with a space between them unless the first ends with a Chinese full stop."""
    return f"{said} {more}" if said and said[-1] < FIRST_CHINESE else said + more


def chain_blocks(blocks: Sequence[Block]) -> Iterator[Chain | Pictures]:
    """The blocks of a solution in chains that stay together, and the drawings between them.

    >>> [type(part).__name__ for part in chain_blocks([Prose("So:"), Display(()), Pictures(())])]
    ['tuple', 'Pictures']
    """
    chain: Chain = ()
    for place, block in enumerate(blocks):
        match block:
            case Pictures():
                yield from filter(None, [chain])
                yield block
                chain = ()
                continue
            case Heading() | Prose() | TermTable():
                measured: TextBlock = block
            case Display():
                measured = measure_display(block)
            case _:
                assert_never(block)
        together = stays(*blocks[place : place + 3]) or _leads_to_step(blocks, place)
        chain = (*chain, Placed(measured, together))
        if not chain[-1].stays:
            yield chain
            chain = ()
    yield from filter(None, [chain])


def _leads_to_step(blocks: Sequence[Block], place: int) -> bool:
    """Whether an equation is a given with which a chapter opens, before the first of its steps: the
    heading of the chapter would else stand at the foot of a page with nothing but givens.
    """
    if not isinstance(blocks[place], Display):
        return False
    opening = list(takewhile(_is_told, reversed(blocks[:place])))
    rest = list(takewhile(_is_told, blocks[place:]))
    before, after = blocks[: place - len(opening)], blocks[place + len(rest) :]
    given = sum(isinstance(one, Display) for one in (*opening, *rest))
    return _ends_with_heading(before, 1) and _ends_with_heading(after[:1], 2) and given <= _GIVENS


def _is_told(block: Block) -> bool:
    return isinstance(block, Prose | Display)


def _ends_with_heading(blocks: Sequence[Block], level: int) -> bool:
    return any(isinstance(one, Heading) and one.level == level for one in blocks[-1:])


def name_question(question: WorkedQuestion) -> Message:
    """The heading of a question, with its number in the answer sheet where that is another."""
    other = find_other_number(question.identifier, question.number)
    if other is None:
        return Message("solution.question", number=question.number)
    return Message("solution.question-known", number=question.number, known=other)
