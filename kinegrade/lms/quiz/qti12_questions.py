"""From a question with several asks to numerical questions that Canvas can hold: one for each ask,
complete in itself.

Each ends with its column of the answer sheet, like [q1.v_B], by which `kinegrade grade --from
canvas` recognises it.
"""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.errors import TypesetError
from kinegrade.exam.quiz_document import QuizAsk, QuizQuestion
from kinegrade.language import Language
from kinegrade.lms.quiz.canvas_units import ClassUnits, edges_kept
from kinegrade.lms.quiz.decimals import decimal_text
from kinegrade.lms.quiz.html import PLACES, ask_html, plain_html
from kinegrade.lms.quiz.intervals import right_intervals
from kinegrade.lms.quiz.packaging import stable_name
from kinegrade.lms.quiz.plain_math import plain_math
from kinegrade.lms.quiz.plain_prose import plain_prose
from kinegrade.lms.quiz.qti12_item import NumericalItem
from kinegrade.lms.quiz.question_html import question_html, warnings_html
from kinegrade.lms.quiz.question_words import WORDS
from kinegrade.lms.quiz.remarks import Remarks
from kinegrade.lms.quiz.typing_words import CANVAS

FILES = "$IMS-CC-FILEBASE$/"  # Canvas puts the address of the course's files here
NO_BANDS = (
    "qti12: Canvas gives a number all points or none - credit and comments for known mistakes "
    "were left out - give them with kinegrade grade, from the students' responses"
)
CHANGED = (
    "qti12: Canvas keeps four decimals - {} is asked for in {} instead of {}, in the whole class, "
    "because that is too coarse for some answers"
)
TOO_FINE = (
    "{}: {} = {} {}, right from {} to {}, is no longer right with the four decimals that Canvas "
    'keeps - expected an answer that is - set the exam with lms = "canvas" in the bank, which '
    "refuses such draws, or allow a wider tolerance"
)
EDGES = (
    "qti12: Canvas keeps four decimals, too few for {} on some papers: an answer near the limit of "
    "the tolerance may be marked the other way there - mark with kinegrade grade, from the "
    "students' responses"
)


@dataclass(frozen=True)
class Asking:
    """What holds for all questions of a quiz: the language, the class's units, and the remarks."""

    language: Language
    units: ClassUnits
    remarks: Remarks


def numerical_items(
    question: QuizQuestion, asking: Asking, *, solution_with_each: bool
) -> list[tuple[QuizAsk, NumericalItem]]:
    """The question's asks, each with its item; what Canvas cannot express is left out and reported
    in the remarks.
    """
    try:
        text = question_html(question, FILES + picture_name(question), CANVAS, asking.language)
        found = [(ask, _item(question, ask, text, asking)) for ask in question.asks]
    except TypesetError as fault:
        asking.remarks.refuse_texts(fault)
        return []
    items = [(ask, item) for ask, item in found if item is not None]
    last = len(items) - 1
    return [
        (ask, item if place == last or solution_with_each else item.unsolved())
        for place, (ask, item) in enumerate(items)
    ]


def picture_name(question: QuizQuestion) -> str:
    """The name of the question's figure in the package."""
    return f"images/{stable_name(question.identifier)}.svg"


def _item(question: QuizQuestion, ask: QuizAsk, text: str, asking: Asking) -> NumericalItem | None:
    language, remarks = asking.language, asking.remarks
    now = asking.units.fitted(question.question, ask)
    symbol = plain_math(ask.symbol, question.question)
    if now is None:
        numbers = (decimal_text(ask.value), ask.unit, decimal_text(ask.low), decimal_text(ask.high))
        remarks.refuse(TOO_FINE.format(question.identifier, symbol, *numbers))
        return None
    _remark(f"{question.question}.{ask.identifier}", ask, now, remarks)
    asked = ask_html(now, language) + warnings_html(now, ask, WORDS[language])
    column = plain_html(f"[{question.question}.{ask.identifier}]")
    heading = plain_prose(question.title, question.question, inline=True)
    title = f"{heading}{PLACES[language][0]}{symbol}"
    return NumericalItem(
        stable_name(f"{question.identifier}-{ask.identifier}"),
        title,
        f"{text}{asked}<p>{column}</p>\n",
        ask.points,
        right_intervals(now),
        question.solution,
    )


def _remark(place: str, on_paper: QuizAsk, now: QuizAsk, remarks: Remarks) -> None:
    """Reports what Canvas cannot do, or asks in another unit."""
    if on_paper.mistakes:
        remarks.complain(NO_BANDS)
    if now.unit != on_paper.unit:
        remarks.complain(CHANGED.format(place, now.unit, on_paper.unit))
    if not edges_kept(now):
        remarks.complain(EDGES.format(place))
