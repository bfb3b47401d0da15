r"""Prose as HTML, as learning management systems show it: formulas between `\(` and `\)`.

Every character that comes in is escaped; the only tags are those made here, and they are
well-formed XML too.
"""

from __future__ import annotations

from collections.abc import Sequence

from kinegrade.language.html_text import write_math_html, write_plain_html
from kinegrade.language.prose.writing import ProseWriter, TextRenderer


class _HtmlRenderer(TextRenderer):
    def text(self, plain: str, *, follows_formula: bool) -> str:
        return write_plain_html(plain)

    def inline_formula(self, latex: str, where: str) -> str:
        return write_math_html(latex, where)

    def displayed_formula(self, latex: str, where: str) -> str:
        return write_math_html(latex, where, display=True)

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


_WRITER = ProseWriter(_HtmlRenderer)


def write_prose(markdown: str, where: str) -> str:
    r"""HTML of several paragraphs of Markdown.

    Raises TypesetError with every fault of the text, each naming `where`.

    >>> write_prose("The **crank** $OA$ & more", "q1")
    '<p>The <strong>crank</strong> \\(OA\\) &amp; more</p>\n'
    """
    return _WRITER.write_prose(markdown, where)


def write_line(markdown: str, where: str) -> str:
    r"""HTML of one line of Markdown, which is not set as a paragraph.

    >>> write_line("speed of $B$", "q1")
    'speed of \\(B\\)'
    """
    return _WRITER.write_line(markdown, where)


def _write_items(items: Sequence[Sequence[str]]) -> str:
    return "".join(f"<li>{''.join(item)}</li>\n" for item in items)
