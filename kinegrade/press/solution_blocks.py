"""What every layout asks of a worked solution: what stays together, and how a result is written."""

from __future__ import annotations

from kinegrade.language.message import Message
from kinegrade.press.sheet import WorkedQuestion
from kinegrade.question_numbers import find_other_number
from kinegrade.worked.document import Block, Display, Heading, Prose, TermTable

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


def name_question(question: WorkedQuestion) -> Message:
    """The heading of a question, with its number in the answer sheet where that is another."""
    other = find_other_number(question.identifier, question.number)
    if other is None:
        return Message("solution.question", number=question.number)
    return Message("solution.question-known", number=question.number, known=other)
