"""One ask as a line of Blackboard's text upload: `NUM`, the whole question, the right number, the
tolerance.
"""

from __future__ import annotations

from fractions import Fraction

from kinegrade.exam.formula import unit_text
from kinegrade.exam.quiz_document import QuizAsk, QuizQuestion
from kinegrade.exam.quiz_words import BETWEEN
from kinegrade.language import Language
from kinegrade.lms.quiz.decimals import decimal_text
from kinegrade.lms.quiz.html import PLACES
from kinegrade.lms.quiz.intervals import RightInterval, within_half_a_turn
from kinegrade.lms.quiz.plain_math import plain_math
from kinegrade.lms.quiz.plain_prose import plain_prose
from kinegrade.lms.quiz.question_words import WORDS
from kinegrade.lms.quiz.remarks import Remarks
from kinegrade.lms.quiz.typing_words import BLACKBOARD, rules

MIDDLE = (
    "blackboard: {} is not in the middle of what counts as right - the middle is given there as "
    "the answer, so that the tolerance is exactly the exam's - tell the students the answer from "
    "the key"
)
TURNS = (
    "blackboard: {} is an angle, and Blackboard takes one right number - it is asked for within "
    "half a turn of zero - check answers near half a turn by hand"
)


def question_line(
    question: QuizQuestion, ask: QuizAsk, language: Language, remarks: Remarks, *, on_paper: bool
) -> str:
    """The line, without its end; `on_paper` where the students have the figure in print. Raises
    TypesetError.
    """
    where, column = question.question, f"{question.question}.{ask.identifier}"
    figure = WORDS[language].figure_on_paper if on_paper and question.figure is not None else ""
    turns = WORDS[language].half_turn if ask.period is not None else ""
    rule = plain_prose(rules(question, BLACKBOARD, language), where)
    parts = (
        plain_prose(question.statement, where),
        figure,
        rule,
        _asked(ask, language, where),
        turns,
    )
    interval = within_half_a_turn(ask)
    if not interval.symmetric:
        remarks.complain(MIDDLE.format(column))
    if ask.period is not None:
        remarks.complain(TURNS.format(column))
    return "\t".join(("NUM", BETWEEN[language].join(filter(None, parts)), *_number(interval)))


def _asked(ask: QuizAsk, language: Language, where: str) -> str:
    colon, note = PLACES[language]
    sign = note.format(plain_prose(ask.sign, where, inline=True)) if ask.sign else ""
    unit = {"1": "", "deg": "°"}.get(ask.unit, f" {unit_text(ask.unit)}")
    meaning = plain_prose(ask.meaning, where, inline=True)
    return f"{meaning}{sign}{colon}{plain_math(ask.symbol, where)} = ?{unit}"


def _number(interval: RightInterval) -> tuple[str, ...]:
    """The right number and its tolerance, if it has one."""
    middle = interval.value if interval.symmetric else (interval.low + interval.high) / 2
    written = decimal_text(middle)
    margin = max(interval.high - Fraction(written), Fraction(written) - interval.low)
    return (written, decimal_text(margin, "up")) if margin else (written,)
