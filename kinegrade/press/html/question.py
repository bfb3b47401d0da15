"""A question as HTML for a screen: its statement and figure, and what is asked for."""

from __future__ import annotations

from kinegrade.figure.back_ends.svg import to_svg
from kinegrade.figure.scene import Scene
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.html_text import (
    write_math_html,
    write_plain_html,
    write_unit_html,
)
from kinegrade.language.message import Location, Message, Text
from kinegrade.language.prose.html import write_line, write_prose
from kinegrade.press.html.described import write_described
from kinegrade.press.paper_parts import write_points_in_words
from kinegrade.press.places import locate_part
from kinegrade.press.sheet import AnswerRow, QuestionSheet

_PIXELS = 5.0  # for a millimetre on paper: symbols are then as large as the text around the figure


def write_statement(sheet: QuestionSheet, picture: str) -> str:
    """The statement, and its figure at the address `picture`, never wider than the page, with a
    short text for those who cannot see it. Raises TypesetError.
    """
    statement = write_prose(sheet.statement, locate_part(sheet.identifier, "statement"))
    if sheet.figure is None:
        return statement
    description = sheet.described.short if sheet.described else ""
    return (
        f'{statement}<p><img src="{write_plain_html(picture)}" '
        f'alt="{write_plain_html(description)}" width="{round(sheet.figure.width * _PIXELS)}" '
        'style="max-width:100%;height:auto"/></p>\n'
    )


def write_description(sheet: QuestionSheet, language: Language) -> str:
    """The figure in words; "" where there are none. Formulas as in the statement. Raises
    TypesetError.
    """
    where = locate_part(sheet.identifier, "statement")
    return write_described(sheet.described, language, lambda text: write_prose(text, where))


def draw_picture(figure: Scene) -> bytes:
    """The figure as an SVG file."""
    return to_svg(figure).encode()


def write_row(row: AnswerRow, where: Location, language: Language, field: str = "") -> str:
    r"""A paragraph that asks for one number: what it is, its sense, and where to write it, with the
    unit. Raises TypesetError.

    `field` is the HTML of the box; where the system puts the box elsewhere, a question mark takes
    its place.
    """
    catalogue = open_catalogue(language)
    unit = write_unit_html(row.unit)
    spaced = unit if unit in ("", "°") else f" {unit}"
    symbol = write_math_html(f"{row.symbol} =", where)
    meaning: Text = write_line(f"{row.meaning[:1].upper()}{row.meaning[1:]}", where)
    if row.sign:
        sign = write_line(row.sign, where)
        meaning = Message("quiz.meaning-with-sign", meaning=meaning, sign=sign)
    asked = catalogue.text(
        "quiz.asked-for-points",
        meaning=meaning,
        number=f"{symbol} {field or '?'}{spaced}",
        points=write_plain_html(write_points_in_words(row.points, catalogue)),
    )
    return f"<p>{asked}</p>\n"
