"""One ask as a line of Blackboard's text upload: `NUM`, the whole question, the right number, the
tolerance.
"""

from __future__ import annotations

from fractions import Fraction

from kinegrade.exam.quiz.document import QuizAsk, QuizQuestion
from kinegrade.exam.quiz.words import write_sentences
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.math.plain import write_plain_math
from kinegrade.language.math.units import write_unit
from kinegrade.language.message import Message, Text
from kinegrade.language.prose.plain import write_line, write_prose
from kinegrade.lms.quiz.decimals import write_decimal
from kinegrade.lms.quiz.intervals import RightInterval, turn_next_to_zero
from kinegrade.lms.quiz.remarks import Remarks
from kinegrade.lms.quiz.typing_words import write_rules


def write_question_line(
    question: QuizQuestion, ask: QuizAsk, language: Language, remarks: Remarks, paper: str
) -> str:
    """The line, without its end; `paper` is the code of the printed paper that has the question and
    its figure, "" where it is pooled. Raises TypesetError.
    """
    where, column = question.sheet.identifier, f"{question.sheet.identifier}.{ask.identifier}"
    shown = bool(paper) and question.sheet.figure is not None
    rule = write_prose(write_rules(question, "blackboard", language), where)
    parts: tuple[Text, ...] = (
        write_prose(question.sheet.statement, where),
        Message("quiz.figure-on-paper", number=question.sheet.number) if shown else "",
        rule,
        _write_asked(ask, language, where),
        Message("quiz.half-turn") if ask.period is not None else "",
    )
    interval = turn_next_to_zero(ask)
    if not interval.symmetric:
        remarks.complain(Message("quiz-file.middle", ask=column))
    if ask.period is not None:
        remarks.complain(Message("quiz-file.turns", ask=column))
    text = write_sentences(parts, language)
    text = f"[{paper}] {text}" if paper else text  # a line has no title
    return "\t".join(("NUM", text, *_write_number(interval)))


def _write_asked(ask: QuizAsk, language: Language, where: str) -> str:
    unit = {"1": "", "deg": "°"}.get(ask.row.unit, f" {write_unit(ask.row.unit)}")
    meaning: Text = write_line(ask.row.meaning, where)
    if ask.row.sign:
        sign = write_line(ask.row.sign, where)
        meaning = Message("quiz.meaning-with-sign", meaning=meaning, sign=sign)
    number = f"{write_plain_math(ask.row.symbol, where)} = ?{unit}"
    return open_catalogue(language).text("quiz.asked", meaning=meaning, number=number)


def _write_number(interval: RightInterval) -> tuple[str, ...]:
    """The right number and its tolerance, if it has one."""
    middle = interval.value if interval.symmetric else (interval.low + interval.high) / 2
    written = write_decimal(middle)
    margin = max(interval.high - Fraction(written), Fraction(written) - interval.low)
    return (written, write_decimal(margin, "up")) if margin else (written,)
