"""How a number is typed, system by system: what each of them reads differently from what a paper
allows.

Tested in the systems themselves. Moodle: a comma, a superscript, a typographic minus or a
full-width digit earns nothing, a unit is ignored; the decimal point is right in all its languages.
Canvas reads numbers in the user's locale, in which 1.293 may be 1293, keeps four decimals, and
shows no unit beside its box.
"""

from __future__ import annotations

from typing import Literal, assert_never

from kinegrade.exam.printing.rules import make_carrying_rule, spell_out, write_example
from kinegrade.exam.quiz.document import QuizQuestion
from kinegrade.exam.quiz.words import write_sentences
from kinegrade.language import Language
from kinegrade.language.message import Message

Typing = Literal["moodle", "canvas", "qti21", "blackboard"]  # what reads the numbers


def write_rules(question: QuizQuestion, typing: Typing, language: Language) -> str:
    """How to work out and type the answers of a question, and when one is right: prose."""
    carrying = make_carrying_rule(question.digits)
    typed = make_typing_rule(typing, question.digits)
    return write_sentences((carrying, typed, question.rule), language)


def make_typing_rule(typing: Typing, figures: int) -> Message:
    """How to type a number, with at least so many significant digits; Canvas keeps four decimals,
    whatever the digits.
    """
    digits = spell_out(figures)
    example, small = f"-{write_example(figures)}", f"{5 / 4:.{figures - 1}f}e-3"
    match typing:
        case "moodle":
            return Message("quiz.type-in-moodle", digits=digits, example=example, small=small)
        case "canvas":
            return Message("quiz.type-in-canvas")
        case "qti21":
            return Message("quiz.type-in-qti21", digits=digits, example=example, small=small)
        case "blackboard":
            return Message("quiz.type-in-blackboard", digits=digits, example=example)
        case _:
            assert_never(typing)
