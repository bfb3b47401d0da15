"""From a question with several asks to numerical questions that Canvas can hold: one for each ask,
complete in itself.

Each ends with its column of the answer sheet, like [q1.v_B], by which `kinegrade grade --from
canvas` recognises it.
"""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.errors import TypesetError
from kinegrade.exam.quiz.document import QuizAsk, QuizQuestion
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.html_text import write_plain_html
from kinegrade.language.math.plain import write_plain_math
from kinegrade.language.message import Fault, Message
from kinegrade.language.prose.plain import write_line
from kinegrade.lms.quiz.decimals import write_decimal
from kinegrade.lms.quiz.intervals import find_right_intervals
from kinegrade.lms.quiz.packaging import make_stable_name
from kinegrade.lms.quiz.qti12.item import NumericalItem
from kinegrade.lms.quiz.qti12.units import ClassUnits, keeps_edges
from kinegrade.lms.quiz.question_html import (
    write_asked_html,
    write_rules_html,
)
from kinegrade.lms.quiz.remarks import Remarks
from kinegrade.press.html.question import write_description, write_statement

_FILES = "$IMS-CC-FILEBASE$/"  # Canvas puts the address of the course's files here


@dataclass(frozen=True)
class Asking:
    """What holds for all questions of a paper: the language, the class's units, and the remarks."""

    language: Language
    units: ClassUnits
    remarks: Remarks


def make_numerical_items(
    question: QuizQuestion, asking: Asking, *, solution_with_each: bool
) -> list[tuple[QuizAsk, NumericalItem]]:
    """The question's asks, each with its item; what Canvas cannot express is left out and reported
    in the remarks.
    """
    try:
        picture = _FILES + name_picture(question)
        statement = write_statement(question.sheet, picture)
        statement += write_description(question.sheet, asking.language)
        text = statement + write_rules_html(question, "canvas", asking.language)
        found = [(ask, _make_item(question, ask, text, asking)) for ask in question.asks]
    except TypesetError as fault:
        asking.remarks.refuse_texts(fault)
        return []
    items = [(ask, item) for ask, item in found if item is not None]
    last = len(items) - 1
    return [
        (ask, item if place == last or solution_with_each else item.unsolved())
        for place, (ask, item) in enumerate(items)
    ]


def name_picture(question: QuizQuestion) -> str:
    """The name of the question's figure in the package."""
    return f"images/{make_stable_name(question.identifier)}.svg"


def name_solution_picture(question: QuizQuestion, number: int) -> str:
    """The name of a picture of the question's solution in the package."""
    return f"images/{make_stable_name(question.identifier)}-solution-{number}.svg"


def _make_item(
    question: QuizQuestion, ask: QuizAsk, text: str, asking: Asking
) -> NumericalItem | None:
    language, remarks = asking.language, asking.remarks
    now = asking.units.fitted(question.sheet.identifier, ask)
    symbol = write_plain_math(ask.row.symbol, question.sheet.identifier)
    if now is None:
        too_fine = Message(
            "quiz-file.too-fine",
            symbol=symbol,
            value=write_decimal(ask.value),
            unit=ask.row.unit,
            low=write_decimal(ask.low),
            high=write_decimal(ask.high),
        )
        remarks.refuse(Fault(question.identifier, too_fine))
        return None
    _note_remark(f"{question.sheet.identifier}.{ask.identifier}", ask, now, remarks)
    asked = write_asked_html(now, ask, language)
    column = write_plain_html(f"[{question.sheet.identifier}.{ask.identifier}]")
    heading = write_line(question.sheet.title, question.sheet.identifier)
    title = open_catalogue(language).text("quiz.asked", meaning=heading, number=symbol)
    return NumericalItem(
        make_stable_name(f"{question.identifier}-{ask.identifier}"),
        title,
        f"{text}{asked}<p>{column}</p>\n",
        ask.row.points,
        find_right_intervals(now),
        question.solution.write(lambda number: name_solution_picture(question, number)),
    )


def _note_remark(place: str, on_paper: QuizAsk, now: QuizAsk, remarks: Remarks) -> None:
    """Reports what Canvas cannot do, or asks in another unit."""
    if on_paper.mistakes:
        remarks.complain(Message("quiz-file.no-bands"))
    if now.row.unit != on_paper.row.unit:
        remarks.complain(
            Message("quiz-file.unit-changed", ask=place, now=now.row.unit, before=on_paper.row.unit)
        )
    if not keeps_edges(now):
        remarks.complain(Message("quiz-file.edges", ask=place))
