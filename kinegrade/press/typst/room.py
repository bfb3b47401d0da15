"""How much room texts take at most, without measuring them: Typst need measure only what is large,
as that makes typesetting several times as long.
"""

from __future__ import annotations

import re
from unicodedata import east_asian_width

from kinegrade.language.math.reading import read_math
from kinegrade.language.math.width import measure_row
from kinegrade.language.message import Location
from kinegrade.press.paper_parts import fits_beside
from kinegrade.press.sheet import AnswerRow, QuestionSheet

_PAGE = 225.0  # millimetres: a little less than any page holds between its margins
_MEASURE = 123.0  # millimetres: the width of a line of text, without a figure beside it
_LINE_OF_ROW = 30  # Latin characters that surely fit a line of what is asked for
_PARAGRAPH = re.compile(r"\n\s*\n|\n(?=\s*(?:[-*+]|\d+[.)])\s)")  # or item of a list
_PLAIN_SYMBOL = 7  # letters: the width of a symbol that surely fits its column


def fits_page(question: QuestionSheet) -> bool:
    """Whether a question surely fits one page."""
    return _bound_height(question) <= _PAGE


def fit_space(question: QuestionSheet) -> float:
    """The room for working that surely fits a page beside the question, in millimetres; a question
    alone on its page has more.
    """
    return min(question.space, max(_PAGE - _bound_height(question), 0.0))


def is_wide_symbol(symbol: str, where: Location) -> bool:
    """Whether a symbol (math) may be too wide for its column. Raises TypesetError."""
    return measure_row(read_math(symbol, where)) > _PLAIN_SYMBOL


def _bound_height(question: QuestionSheet) -> float:
    """Millimetres that a question's block does not exceed, with wide characters and tall lines
    throughout.
    """
    figure = question.figure
    beside = figure is not None and fits_beside(figure)
    measure = _MEASURE - figure.width + 40 if figure and beside else _MEASURE
    paragraphs = _PARAGRAPH.split(question.statement)
    text = sum(
        6 + 6 * _count_columns(_reduce_to_seen(paragraph)) / (measure / 2)
        for paragraph in paragraphs
    )
    text += 8 * question.statement.count("frac") + 8 * question.statement.count("$$")
    rows = sum(10 + 5 * _bound_lines(row) for row in question.rows)
    height = figure.height if figure else 0.0
    return 30 + (max(text, height) if beside else text + height) + rows


def _reduce_to_seen(text: str) -> str:
    """A text with each LaTeX command as one letter and without braces and dollar signs: what
    takes up room.
    """
    return re.sub(r"[{}$_^]", "", re.sub(r"\\[A-Za-z]+", "x", text))


def _count_columns(text: str) -> int:
    """The width of `text`, a Chinese character counting as two Latin ones."""
    if text.isascii():
        return len(text)
    return sum(2 if east_asian_width(character) in "WF" else 1 for character in text)


def _bound_lines(row: AnswerRow) -> int:
    """The lines that what is asked for, and its sign convention below it, surely fit."""
    return sum(
        1 + (_count_columns(text) - 1) // _LINE_OF_ROW for text in (row.meaning, row.sign) if text
    )
