"""The texts of a quiz as HTML, for every writer of this package: prose, math, units, plain text,
figures, asks.

Prose and math come from `kinegrade.exam.quiz_prose`, which writes the worked solutions too.
"""

from __future__ import annotations

from fractions import Fraction

from kinegrade.exam.quiz_document import QuizAsk, QuizFigure
from kinegrade.exam.quiz_prose import math_html, plain_html, prose_html, unit_html
from kinegrade.exam.rules import plain
from kinegrade.exam.words import words_of
from kinegrade.language import Language

PIXELS = 5.0  # for a millimetre on paper: symbols are then as large as the text around the figure
PLACES = {"en": (": ", " ({})"), "zh": ("：", "（{}）")}

__all__ = [
    "ask_html",
    "figure_html",
    "math_html",
    "plain_html",
    "points_html",
    "prose_html",
    "unit_html",
]


def figure_html(figure: QuizFigure, source: str) -> str:
    """A paragraph with the figure at the address `source`, never wider than the page."""
    return (
        f'<p><img src="{plain_html(source)}" alt="{plain_html(figure.description)}" '
        f'width="{round(figure.width * PIXELS)}" style="max-width:100%;height:auto"/></p>\n'
    )


def ask_html(ask: QuizAsk, language: Language, field: str = "") -> str:
    r"""A paragraph that asks for one number: what it is, its sense, and where to write it, with the
    unit.

    `field` is the HTML of the box; where the system puts the box elsewhere, a question mark takes
    its place.
    """
    where = f"ask {ask.identifier}"
    colon, note = PLACES[language]
    sign = note.format(prose_html(ask.sign, where, inline=True)) if ask.sign else ""
    unit = unit_html(ask.unit)
    spaced = unit if unit in ("", "°") else f" {unit}"
    points = note.format(points_html(ask.points, language))
    symbol = math_html(f"{ask.symbol} =", where)
    meaning = f"{ask.meaning[:1].upper()}{ask.meaning[1:]}"
    return (
        f"<p>{prose_html(meaning, where, inline=True)}{sign}{colon}{symbol} {field or '?'}{spaced}"
        f"{points}</p>\n"
    )


def points_html(points: Fraction, language: Language) -> str:
    """A number of points in words.

    >>> points_html(Fraction(5, 2), "en")
    '2.5 points'
    """
    words = words_of(language)
    return plain_html((words.point if points == 1 else words.points).format(plain(points)))
