r"""Prose as HTML: for learning management systems with formulas between `\(` and `\)`, for pages of
our own with MathML.

Every character that comes in is escaped; the only tags are those made here, and they are
well-formed XML too.
"""

from __future__ import annotations

from collections.abc import Sequence

from kinegrade.language.html_text import write_display_html, write_math_html, write_plain_html
from kinegrade.language.math.mathml.formula import write_mathml
from kinegrade.language.math.reading import read_math
from kinegrade.language.message import Location
from kinegrade.language.prose.writing import ProseWriter, TextRenderer


class _HtmlRenderer(TextRenderer):
    """Everything but formulas."""

    def text(self, plain: str, *, follows_formula: bool) -> str:
        return write_plain_html(plain)

    def line_end(self, *, printed: bool) -> str:
        return " " if printed else ""

    def line_break(self) -> str:
        return "<br/>\n"

    def strong(self, content: Sequence[str]) -> str:
        return f"<strong>{''.join(content)}</strong>"

    def emphasis(self, content: Sequence[str]) -> str:
        return f"<em>{''.join(content)}</em>"

    def paragraph(self, content: Sequence[str]) -> str:
        return f"<p>{''.join(content)}</p>\n"

    def short_item(self, content: Sequence[str]) -> str:
        return "".join(content)

    def bullet_list(self, items: Sequence[Sequence[str]]) -> str:
        return f"<ul>\n{_write_items(items)}</ul>\n"

    def numbered_list(self, items: Sequence[Sequence[str]], start: int) -> str:
        return f'<ol start="{start}">\n{_write_items(items)}</ol>\n'


class _MathjaxRenderer(_HtmlRenderer):
    def inline_formula(self, latex: str, where: Location) -> str:
        return write_math_html(latex, where)

    def displayed_formula(self, latex: str, where: Location) -> str:
        return write_display_html(read_math(latex, where))


class _MathmlRenderer(_HtmlRenderer):
    def inline_formula(self, latex: str, where: Location) -> str:
        return write_mathml(latex, where)

    def displayed_formula(self, latex: str, where: Location) -> str:
        return write_mathml(latex, where)


_WRITER = ProseWriter(_MathjaxRenderer)
_PAGE_WRITER = ProseWriter(_MathmlRenderer)


def write_prose(markdown: str, where: Location) -> str:
    r"""HTML of several paragraphs of Markdown.

    Raises TypesetError with every fault of the text, each naming `where`.

    >>> write_prose("The **crank** $OA$ & more", "q1")
    '<p>The <strong>crank</strong> \\(OA\\) &amp; more</p>\n'
    """
    return _WRITER.write_prose(markdown, where)


def write_line(markdown: str, where: Location) -> str:
    r"""HTML of one line of Markdown, which is not set as a paragraph.

    >>> write_line("speed of $B$", "q1")
    'speed of \\(B\\)'
    """
    return _WRITER.write_line(markdown, where)


def write_page_prose(markdown: str, where: Location) -> str:
    """HTML of several paragraphs of Markdown for a page of our own."""
    return _PAGE_WRITER.write_prose(markdown, where)


def write_page_line(markdown: str, where: Location) -> str:
    """HTML of one line of Markdown for a page of our own, which a browser shows without a script.

    >>> write_page_line("**speed** of $B$", "q1")
    '<strong>speed</strong> of <math><mi>B</mi></math>'
    """
    return _PAGE_WRITER.write_line(markdown, where)


def _write_items(items: Sequence[Sequence[str]]) -> str:
    return "".join(f"<li>{''.join(item)}</li>\n" for item in items)
