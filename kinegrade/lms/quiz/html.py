"""The figures and asks of a quiz as HTML, for every writer of this package."""

from __future__ import annotations

from kinegrade.exam.quiz_document import QuizAsk, QuizFigure
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.html_text import (
    write_math_html,
    write_plain_html,
    write_unit_html,
)
from kinegrade.language.message import Message, Text
from kinegrade.language.prose.html import write_line
from kinegrade.press.paper_parts import write_points_in_words

_PIXELS = 5.0  # for a millimetre on paper: symbols are then as large as the text around the figure


def write_figure_html(figure: QuizFigure, source: str) -> str:
    """A paragraph with the figure at the address `source`, never wider than the page."""
    return (
        f'<p><img src="{write_plain_html(source)}" alt="{write_plain_html(figure.description)}" '
        f'width="{round(figure.width * _PIXELS)}" style="max-width:100%;height:auto"/></p>\n'
    )


def write_ask_html(ask: QuizAsk, language: Language, field: str = "") -> str:
    r"""A paragraph that asks for one number: what it is, its sense, and where to write it, with the
    unit.

    `field` is the HTML of the box; where the system puts the box elsewhere, a question mark takes
    its place.
    """
    where = f"ask {ask.identifier}"
    catalogue = open_catalogue(language)
    unit = write_unit_html(ask.unit)
    spaced = unit if unit in ("", "°") else f" {unit}"
    symbol = write_math_html(f"{ask.symbol} =", where)
    meaning: Text = write_line(f"{ask.meaning[:1].upper()}{ask.meaning[1:]}", where)
    if ask.sign:
        sign = write_line(ask.sign, where)
        meaning = Message("quiz.meaning-with-sign", meaning=meaning, sign=sign)
    asked = catalogue.text(
        "quiz.asked-for-points",
        meaning=meaning,
        number=f"{symbol} {field or '?'}{spaced}",
        points=write_plain_html(write_points_in_words(ask.points, catalogue)),
    )
    return f"<p>{asked}</p>\n"
