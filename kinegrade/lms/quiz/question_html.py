"""A question as HTML: the parts that Canvas and QTI 2.1 share."""

from __future__ import annotations

from functools import lru_cache

from kinegrade.exam.quiz_document import QuizAsk, QuizQuestion
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.html_text import write_unit_html
from kinegrade.language.prose.html import write_prose
from kinegrade.lms.quiz.html import write_figure_html
from kinegrade.lms.quiz.typing_words import Typing, write_rules


def write_question_html(
    question: QuizQuestion, picture: str, typing: Typing, language: Language
) -> str:
    """The statement, its figure at the address `picture`, and the rules. Raises TypesetError."""
    figure = write_figure_html(question.figure, picture) if question.figure is not None else ""
    return (
        write_prose(question.statement, question.question)
        + figure
        + write_rules_html(question, typing, language)
    )


def write_rules_html(question: QuizQuestion, typing: Typing, language: Language) -> str:
    """How to type the answers, and when one is right."""
    return _write_rules_html(write_rules(question, typing, language))


@lru_cache(maxsize=64)
def _write_rules_html(text: str) -> str:
    """The rules, which most questions of an exam share."""
    return write_prose(text, "rule")


def write_warnings_html(asked: QuizAsk, on_paper: QuizAsk, language: Language) -> str:
    """What students must note: a unit that differs from the paper's, turns that may be added; ""
    where there is nothing.
    """
    catalogue, lines = open_catalogue(language), []
    if asked.unit != on_paper.unit:
        here, paper = write_unit_html(asked.unit), write_unit_html(on_paper.unit)
        lines.append(catalogue.text("quiz.changed-unit", here=here, paper=paper))
    if asked.period is not None:
        lines.append(catalogue.text("quiz.any-turns"))
    return "".join(f"<p>{line}</p>\n" for line in lines)
