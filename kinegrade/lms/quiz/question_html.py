"""What a quiz adds to the sheet of a paper's question, as HTML."""

from __future__ import annotations

from functools import lru_cache

from kinegrade.exam.quiz.document import QuizAsk, QuizQuestion
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.html_text import write_unit_html
from kinegrade.language.message import Message
from kinegrade.language.prose.html import write_prose
from kinegrade.lms.quiz.typing_words import Typing, write_rules
from kinegrade.press.html.question import write_row


def write_rules_html(question: QuizQuestion, typing: Typing, language: Language) -> str:
    """How to type the answers, and when one is right."""
    return _write_rules(write_rules(question, typing, language))


def write_asked_html(asked: QuizAsk, on_paper: QuizAsk, language: Language, field: str = "") -> str:
    """What is asked for, with its box as in `write_row`, and what students must note: a unit that
    differs from the paper's, turns that may be added. Raises TypesetError.
    """
    words, unit, printed = open_catalogue(language), asked.row.unit, on_paper.row.unit
    where = Message("typesetting.place-ask", ask=asked.identifier)
    lines = [write_row(asked.row, where, language, field)]
    if unit != printed:
        here, paper = write_unit_html(unit), write_unit_html(printed)
        changed = words.text("quiz.changed-unit", here=here, paper=paper)
        lines.append(f"<p>{changed}</p>\n")
    if asked.period is not None:
        lines.append(f"<p>{words.text('quiz.any-turns')}</p>\n")
    return "".join(lines)


@lru_cache(maxsize=64)
def _write_rules(text: str) -> str:
    """The rules, which most questions of an exam share."""
    return write_prose(text, "rule")
