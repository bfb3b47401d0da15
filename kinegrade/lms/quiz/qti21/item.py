"""A question as an assessment item of QTI 2.1: a box for every ask, tolerance and credit as the
exam has them.
"""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.exam.quiz.document import QuizAsk, QuizQuestion
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.html_text import write_plain_html
from kinegrade.language.prose.plain import write_line
from kinegrade.lms.quiz.packaging import make_stable_name
from kinegrade.lms.quiz.qti21.body import write_flow
from kinegrade.lms.quiz.qti21.scoring import (
    SOLUTION,
    name_mistake,
    name_response,
    write_declarations,
    write_processing,
)
from kinegrade.lms.quiz.question_html import (
    write_asked_html,
    write_rules_html,
)
from kinegrade.lms.quiz.xml_text import Xml, write_document, write_element, write_on_lines
from kinegrade.press.html.question import write_statement

_QTI = "http://www.imsglobal.org/xsd/imsqti_v2p1"
NAMES = {
    "xmlns": _QTI,
    "xmlns:xsi": "http://www.w3.org/2001/XMLSchema-instance",
    "xsi:schemaLocation": f"{_QTI} http://www.imsglobal.org/xsd/qti/qtiv2p1/imsqti_v2p1.xsd",
}
_BOX = '<textEntryInteraction responseIdentifier="{}" expectedLength="16"/>'


def write_item_document(
    question: QuizQuestion, language: Language, folder: str, paper: str
) -> bytes:
    """The item's file; `folder` is where pictures are from it, `paper` the code of the paper of
    the question, "" where it is pooled. Raises TypesetError.
    """
    picture = f"{folder}{name_picture(question)}"
    heading = write_line(question.sheet.title, question.sheet.identifier)
    title = " · ".join(filter(None, (heading, paper)))
    parts = write_on_lines(
        (
            *write_declarations(question.asks),
            write_element("itemBody", write_flow(_write_body(question, language, picture))),
            write_processing(question.asks, solved=bool(question.solution.parts)),
            *_write_feedback(question, folder),
        )
    )
    return write_document(
        write_element(
            "assessmentItem",
            parts,
            identifier=make_stable_name(question.identifier),
            title=title,
            adaptive="false",
            timeDependent="false",
            **NAMES,
            **{"xml:lang": open_catalogue(language).text("language.tag")},
        )
    )


def name_picture(question: QuizQuestion, number: int | None = None) -> str:
    """The name of the question's figure in the package, or of a picture of its solution."""
    name = make_stable_name(question.identifier)
    return f"images/{name}.svg" if number is None else f"images/{name}-solution-{number}.svg"


def _write_body(question: QuizQuestion, language: Language, picture: str) -> str:
    """Statement and figure, then the asks, each with its box before the unit."""
    statement = write_statement(question.sheet, picture)
    boxes = (_write_asked(place, ask, language) for place, ask in enumerate(question.asks, start=1))
    return "".join((statement, write_rules_html(question, "qti21", language), *boxes))


def _write_asked(place: int, ask: QuizAsk, language: Language) -> str:
    return write_asked_html(ask, ask, language, _BOX.format(name_response(place)))


def _write_feedback(question: QuizQuestion, folder: str) -> Iterator[Xml]:
    for place, ask in enumerate(question.asks, start=1):
        for number, mistake in enumerate(ask.mistakes, start=1):
            yield _write_shown(
                name_mistake(place, number), f"<p>{write_plain_html(mistake.sentence)}</p>"
            )
    if question.solution.parts:
        solution = question.solution.write(
            lambda number: f"{folder}{name_picture(question, number)}"
        )
        yield _write_shown(SOLUTION, solution)


def _write_shown(name: str, html: str) -> Xml:
    return write_element(
        "modalFeedback",
        write_flow(html),
        outcomeIdentifier="FEEDBACK",
        identifier=name,
        showHide="show",
    )
