"""Prose as LaTeX.

Text leaves here only through `write_plain` and formulas only through the writer of math, so nothing
in a statement or title can become a TeX command.
"""

from __future__ import annotations

from collections.abc import Sequence

from kinegrade.language.math.latex import write_latex_math
from kinegrade.language.math.latex_text import write_plain
from kinegrade.language.message import Location
from kinegrade.language.prose.writing import ProseWriter, TextRenderer


class _LatexRenderer(TextRenderer):
    def text(self, plain: str, *, follows_formula: bool) -> str:
        return write_plain(plain)

    def inline_formula(self, latex: str, where: Location) -> str:
        return f"${write_latex_math(latex, where)}$"

    def displayed_formula(self, latex: str, where: Location) -> str:
        return f"\\[{write_latex_math(latex, where)}\\]"

    def line_end(self, *, printed: bool) -> str:
        return "\n" if printed else "%\n"

    def line_break(self) -> str:
        return "\\newline\n"

    def strong(self, content: Sequence[str]) -> str:
        return rf"\textbf{{{''.join(content)}}}"

    def emphasis(self, content: Sequence[str]) -> str:
        return rf"\emph{{{''.join(content)}}}"

    def paragraph(self, content: Sequence[str]) -> str:
        return "".join(content) + "\n\n"

    def short_item(self, content: Sequence[str]) -> str:
        return "".join(content)

    def bullet_list(self, items: Sequence[Sequence[str]]) -> str:
        return f"\\begin{{itemize}}\n{_write_items(items)}\\end{{itemize}}\n\n"

    def numbered_list(self, items: Sequence[Sequence[str]], start: int) -> str:
        beginning = f"\\begin{{enumerate}}\\startat{{{start}}}\n"
        return f"{beginning}{_write_items(items)}\\end{{enumerate}}\n\n"


_WRITER = ProseWriter(_LatexRenderer)


def write_prose(markdown: str, where: Location) -> str:
    r"""LaTeX for several paragraphs of Markdown.

    Raises TypesetError with every fault of the text, each naming `where`.

    >>> print(write_prose("The crank $OA$ **turns**.", "q1"))
    The crank $OA$ \textbf{turns}.
    """
    return _WRITER.write_prose(markdown, where).rstrip("\n")


def write_line(markdown: str, where: Location) -> str:
    r"""LaTeX for one line of Markdown: a title, the meaning of a symbol, a sign convention.

    >>> print(write_line("speed of $B$ & more", "q1"))
    speed of $B$ \& more
    """
    return _WRITER.write_line(markdown, where)


def _write_items(items: Sequence[Sequence[str]]) -> str:
    return "".join(f"\\item{{}} {''.join(item)}\n" for item in items)
