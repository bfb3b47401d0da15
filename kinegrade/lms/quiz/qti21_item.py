"""A question as an assessment item of QTI 2.1: a box for every ask, tolerance and credit as the
exam has them.
"""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.exam.quiz_document import QuizAsk, QuizQuestion
from kinegrade.language import Language
from kinegrade.lms.quiz.html import ask_html, plain_html
from kinegrade.lms.quiz.packaging import stable_name
from kinegrade.lms.quiz.plain_prose import plain_prose
from kinegrade.lms.quiz.qti21_body import flow
from kinegrade.lms.quiz.qti21_scoring import (
    SOLUTION,
    declarations,
    mistake_name,
    processing,
    response_name,
)
from kinegrade.lms.quiz.question_html import question_html, warnings_html
from kinegrade.lms.quiz.question_words import WORDS
from kinegrade.lms.quiz.typing_words import QTI21
from kinegrade.lms.quiz.xml_text import Xml, document, element, on_lines

QTI = "http://www.imsglobal.org/xsd/imsqti_v2p1"
NAMES = {
    "xmlns": QTI,
    "xmlns:xsi": "http://www.w3.org/2001/XMLSchema-instance",
    "xsi:schemaLocation": f"{QTI} http://www.imsglobal.org/xsd/qti/qtiv2p1/imsqti_v2p1.xsd",
}
BOX = '<textEntryInteraction responseIdentifier="{}" expectedLength="16"/>'


def item_document(question: QuizQuestion, language: Language, picture: str) -> bytes:
    """The item's file; `picture` is the address of the figure. Raises TypesetError."""
    title = plain_prose(question.title, question.question, inline=True)
    parts = on_lines(
        (
            *declarations(question.asks),
            element("itemBody", flow(_body(question, language, picture))),
            processing(question.asks, solved=bool(question.solution)),
            *_feedback(question),
        )
    )
    return document(
        element(
            "assessmentItem",
            parts,
            identifier=stable_name(question.identifier),
            title=title,
            adaptive="false",
            timeDependent="false",
            **NAMES,
            **{"xml:lang": WORDS[language].tag},
        )
    )


def _body(question: QuizQuestion, language: Language, picture: str) -> str:
    """Statement and figure, then the asks, each with its box before the unit."""
    boxes = (_asked(place, ask, language) for place, ask in enumerate(question.asks, start=1))
    return question_html(question, picture, QTI21, language) + "".join(boxes)


def _asked(place: int, ask: QuizAsk, language: Language) -> str:
    return ask_html(ask, language, BOX.format(response_name(place))) + warnings_html(
        ask, ask, WORDS[language]
    )


def _feedback(question: QuizQuestion) -> Iterator[Xml]:
    for place, ask in enumerate(question.asks, start=1):
        for number, mistake in enumerate(ask.mistakes, start=1):
            yield _shown(mistake_name(place, number), f"<p>{plain_html(mistake.sentence)}</p>")
    if question.solution:
        yield _shown(SOLUTION, question.solution)


def _shown(name: str, html: str) -> Xml:
    return element(
        "modalFeedback", flow(html), outcomeIdentifier="FEEDBACK", identifier=name, showHide="show"
    )
