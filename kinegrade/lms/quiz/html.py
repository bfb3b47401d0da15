"""The figures and asks of a quiz as HTML, for every writer of this package."""

from __future__ import annotations

from fractions import Fraction

from kinegrade.exam.quiz_document import QuizAsk, QuizFigure
from kinegrade.exam.quiz_prose import (
    write_math_html,
    write_plain_html,
    write_unit_html,
)
from kinegrade.exam.rules import write_plain
from kinegrade.exam.words import choose_words
from kinegrade.language import Language
from kinegrade.language.prose.html import write_line

_PIXELS = 5.0  # for a millimetre on paper: symbols are then as large as the text around the figure
PLACES = {"en": (": ", " ({})"), "zh": ("：", "（{}）")}


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
    colon, note = PLACES[language]
    sign = note.format(write_line(ask.sign, where)) if ask.sign else ""
    unit = write_unit_html(ask.unit)
    spaced = unit if unit in ("", "°") else f" {unit}"
    points = note.format(_write_points_html(ask.points, language))
    symbol = write_math_html(f"{ask.symbol} =", where)
    meaning = f"{ask.meaning[:1].upper()}{ask.meaning[1:]}"
    return (
        f"<p>{write_line(meaning, where)}{sign}{colon}{symbol} {field or '?'}{spaced}{points}</p>\n"
    )


def _write_points_html(points: Fraction, language: Language) -> str:
    """A number of points in words.

    >>> _write_points_html(Fraction(5, 2), "en")
    '2.5 points'
    """
    words = choose_words(language)
    return write_plain_html(
        (words.point if points == 1 else words.points).format(write_plain(points))
    )
