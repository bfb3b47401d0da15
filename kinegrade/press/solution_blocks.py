"""What every layout asks of a worked solution: what stays together, and how a result is written."""

from __future__ import annotations

from fractions import Fraction
from re import fullmatch

from kinegrade.language.message import Message
from kinegrade.press.sheet import WorkedQuestion
from kinegrade.question_numbers import find_other_number
from kinegrade.worked.document import Block, Display, Heading, Prose, Result, TermTable

FORMULA_ALONE = r"\$[^$]+\$"
UNKNOWN = "?"


def stays(block: Block, following: Block | None = None, third: Block | None = None) -> bool:
    """Whether a block stays on the page of the next one.

    So do a heading with what it heads, a table of terms with its projection, a sentence with the
    equation it announces.

    >>> stays(Prose("Projected on AB:"), Display(("v_A = v_B",)))
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


def has_exact_decimal(result: Result) -> bool:
    r"""Whether the decimal is the exact value, as it is of a short decimal fraction.

    >>> has_exact_decimal(Result("v", r"\frac{1}{4}", "0.25", "m", ""))
    True
    >>> has_exact_decimal(Result("v", r"\frac{1}{3}", "0.333333", "m", ""))
    False
    """
    found = fullmatch(r"(-?)(?:\\frac\{(\d+)\}\{(\d+)\}|(\d+(?:\.\d+)?))", result.exact or "")
    if not found or not fullmatch(r"-?\d+(\.\d+)?", result.decimal):
        return False
    sign, upper, lower, plain = found.groups()
    exact = Fraction(plain) if plain else Fraction(int(upper), int(lower)) if int(lower) else None
    return exact is not None and Fraction(result.decimal) == (-exact if sign else exact)
