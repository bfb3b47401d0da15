"""A question as a notebook shows it: HTML with formulas in MathML and the figure inside; it needs
no script and no other file.
"""

from __future__ import annotations

from collections.abc import Mapping

from kinegrade.figure.back_ends.svg import to_svg
from kinegrade.figure.scene import Scene
from kinegrade.language import Language
from kinegrade.language.html_text import write_plain_html
from kinegrade.language.message import Message
from kinegrade.language.prose.html import write_page_line, write_page_prose
from kinegrade.press.html.described import write_described
from kinegrade.press.places import locate_part
from kinegrade.press.sheet import QuestionSheet


def write_question(sheet: QuestionSheet, asked: Mapping[str, str], language: Language) -> str:
    """Title, statement, figure, and what is asked by name. Raises TypesetError with the faults of a
    text.
    """
    name = sheet.template
    title = write_page_line(sheet.title, locate_part(name, "title"))
    statement = write_page_prose(sheet.statement, locate_part(name, "statement"))
    figure = "" if sheet.figure is None else f"<p>{_write_figure(sheet, sheet.figure)}</p>\n"
    place = locate_part(name, "statement")
    words = write_described(sheet.described, language, lambda text: write_page_prose(text, place))
    names = "".join(_write_name(ask, means) for ask, means in asked.items())
    return f"<h4>{title}</h4>\n{statement}{figure}{words}<ul>\n{names}</ul>\n"


def _write_figure(sheet: QuestionSheet, figure: Scene) -> str:
    """The figure with the short text that stands for it."""
    return to_svg(figure, sheet.described.short if sheet.described else "")


def _write_name(ask: str, means: str) -> str:
    where = Message("typesetting.place-ask", ask=ask)
    return f"<li><code>{write_plain_html(ask)}</code> {write_page_line(means, where)}</li>\n"
