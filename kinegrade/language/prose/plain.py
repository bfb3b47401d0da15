"""Prose as one line of plain text, for titles and for systems that take no HTML."""

from __future__ import annotations

import re
from collections.abc import Sequence

from kinegrade.language.math.plain import write_plain_math
from kinegrade.language.message import Location
from kinegrade.language.prose.writing import ProseWriter, TextRenderer

_UNPRINTED = re.compile("[\x00-\x1f\x7f-\x9f\u2028\u2029\ufffe\uffff\ud800-\udfff]+")
_BLANKS = re.compile(r"[\s\u2028\u2029]+")


class _PlainRenderer(TextRenderer):
    def text(self, plain: str, *, follows_formula: bool) -> str:
        return plain

    def inline_formula(self, latex: str, where: Location) -> str:
        return write_plain_math(latex, where)

    def displayed_formula(self, latex: str, where: Location) -> str:
        return write_plain_math(latex, where)

    def line_end(self, *, printed: bool) -> str:
        return " " if printed else ""

    def line_break(self) -> str:
        return " "

    def strong(self, content: Sequence[str]) -> str:
        return "".join(content)

    def emphasis(self, content: Sequence[str]) -> str:
        return "".join(content)

    def paragraph(self, content: Sequence[str]) -> str:
        return "".join(content) + " "

    def short_item(self, content: Sequence[str]) -> str:
        return "".join(content) + " "

    def bullet_list(self, items: Sequence[Sequence[str]]) -> str:
        return _write_items(items)

    def numbered_list(self, items: Sequence[Sequence[str]], start: int) -> str:
        return _write_items(items)


_WRITER = ProseWriter(_PlainRenderer)


def write_prose(markdown: str, where: Location) -> str:
    r"""Several paragraphs of Markdown in one line of plain text.

    Raises TypesetError with every fault of the text, each naming `where`.

    >>> write_prose("The **crank** $OA$ turns.\n\nFind $v_B$.", "q1")
    'The crank OA turns. Find v_B.'
    """
    return write_one_plain_line(_WRITER.write_prose(markdown, where))


def write_line(markdown: str, where: Location) -> str:
    """One line of Markdown as plain text.

    >>> write_line("speed of $B$", "q1")
    'speed of B'
    """
    return write_one_plain_line(_WRITER.write_line(markdown, where))


def write_one_plain_line(text: str) -> str:
    r"""Plain text without line breaks, tabs and characters that XML does not allow.

    >>> write_one_plain_line("a\tb\n\x00c")
    'a b c'
    """
    return _BLANKS.sub(" ", _UNPRINTED.sub(" ", text)).strip()


def _write_items(items: Sequence[Sequence[str]]) -> str:
    return "".join(f" - {''.join(item)}" for item in items)
