"""Prose as Typst code that yields content.

Text leaves here only as string literals and formulas only through the writer of math, so nothing in
a statement or title can become Typst code.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache, lru_cache
from typing import ClassVar

from kinegrade.language import ENGLISH, Language
from kinegrade.language.math.equation_line import begins_with_relation, split_equation_line
from kinegrade.language.math.printed_size import measure_printed
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.tree import Row
from kinegrade.language.math.typst.equation import write_display, write_equation
from kinegrade.language.math.typst.formula import write_typst_row
from kinegrade.language.message import Location
from kinegrade.language.prose.writing import ProseWriter, TextRenderer
from kinegrade.language.typst_text import write_literal

_PARAGRAPH_END = "parbreak();"
# In em: a longer formula may have no room on one line, in the narrowest column beside a drawing
_LONGEST_UNBROKEN = 18.0
_BEFORE_RELATION = "h(0.2778em,weak:true);"  # TeX's thick space; none where a line begins
_NO_OPERAND = '""'  # before a sign, so that it is set as between two terms


class _TypstRenderer(TextRenderer):
    """Statements of Typst; semicolons keep them apart on one line. Formulas are said in a
    language.
    """

    language: ClassVar[Language] = ENGLISH

    def text(self, plain: str, *, follows_formula: bool) -> str:
        # By Unicode's rules a Chinese colon or semicolon after a formula could begin a line
        glue = "\u2060" if follows_formula and plain[0] in "：；" else ""
        return f"{write_literal(glue + plain)};"

    def inline_formula(self, latex: str, where: Location) -> str:
        read_math(latex, where)
        return _write_boxes(latex, self.language)

    def displayed_formula(self, latex: str, where: Location) -> str:
        return f"{write_display((read_math(latex, where),), self.language)};"

    def line_end(self, *, printed: bool) -> str:
        return '" ";' if printed else ""

    def line_break(self) -> str:
        return "linebreak();"

    def strong(self, content: Sequence[str]) -> str:
        return f"strong({{{''.join(content)}}});"

    def emphasis(self, content: Sequence[str]) -> str:
        return f"emph({{{''.join(content)}}});"

    def paragraph(self, content: Sequence[str]) -> str:
        return "".join(content) + _PARAGRAPH_END

    def short_item(self, content: Sequence[str]) -> str:
        return "".join(content)

    def bullet_list(self, items: Sequence[Sequence[str]]) -> str:
        return f"list({_write_items(items)});"

    def numbered_list(self, items: Sequence[Sequence[str]], start: int) -> str:
        return f"enum(start: {start}, {_write_items(items)});"


@lru_cache(maxsize=8192)
def _write_boxes(latex: str, language: Language) -> str:
    """A formula in its line: in one box, so that a value is not separated from its symbol; a long
    one in several, between which the line may end.
    """
    row = read_math(latex, "")
    if measure_printed(row).width <= _LONGEST_UNBROKEN:
        return f"box({write_equation(row, language)});"
    first, *others = split_equation_line(row).pieces
    continued = "".join(_write_continuation(piece, language) for piece in others)
    return f"box({write_equation(first, language)});{continued}"


def _write_continuation(piece: Row, language: Language) -> str:
    """The box of a relation or a sign with what follows it."""
    if begins_with_relation(piece):
        return f"{_BEFORE_RELATION}box({write_equation(piece, language)});"
    math = f"{_NO_OPERAND}{write_typst_row(piece)}"
    return f"box({write_equation(piece, language, math)});"


@cache
def _open_writer(spoken: Language) -> ProseWriter:
    """The writer for a language, which says formulas in it."""

    class Renderer(_TypstRenderer):
        language = spoken

    return ProseWriter(Renderer)


def write_prose(markdown: str, where: Location, language: Language) -> str:
    """Typst code (an expression yielding content) for several paragraphs of Markdown.

    Raises TypesetError with every fault of the text, each naming `where`.

    >>> print(write_prose("The crank $OA$ turns.", "q1", ENGLISH))
    {"The crank ";box(math.equation(alt:"O A",$O A$.body));" turns.";}
    """
    written = _open_writer(language).write_prose(markdown, where)
    return f"{{{written.removesuffix(_PARAGRAPH_END)}}}"


def write_line(markdown: str, where: Location, language: Language) -> str:
    """Typst code for one line of Markdown: a title, the meaning of a symbol, a sign convention.

    >>> print(write_line("speed of $B$", "q1", ENGLISH))
    {"speed of ";box(math.equation(alt:"B",$B$.body));}
    """
    return f"{{{_open_writer(language).write_line(markdown, where)}}}"


def _write_items(items: Sequence[Sequence[str]]) -> str:
    return "".join(f"{{{''.join(item)}}}," for item in items)
