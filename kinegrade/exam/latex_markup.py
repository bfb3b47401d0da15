"""Prose into LaTeX: Markdown with `$...$` LaTeX math, read token by token as
`kinegrade.exam.markup` reads it.

Text leaves here only through `plain` and formulas only through `math`, so nothing in a statement or
title can become a TeX command.
"""

from __future__ import annotations

from collections.abc import Sequence

from markdown_it.token import Token

from kinegrade.exam.latex_math import write_math
from kinegrade.exam.latex_text import write_plain
from kinegrade.exam.markup import find_leaves, is_between_wide, read_line, read_prose

_WRITTEN = {
    "paragraph_open": "",
    "paragraph_close": "\n\n",
    "strong_open": r"\textbf{",
    "strong_close": "}",
    "em_open": r"\emph{",
    "em_close": "}",
    "bullet_list_open": "\\begin{itemize}\n",
    "bullet_list_close": "\\end{itemize}\n\n",
    "ordered_list_close": "\\end{enumerate}\n\n",
    "list_item_open": r"\item{} ",
    "list_item_close": "\n",
    "hardbreak": "\\newline\n",
}


def write_prose(markdown: str, where: str) -> str:
    r"""LaTeX for several paragraphs of Markdown.

    Raises TypesetError with every fault of the text, each naming `where`.

    >>> print(write_prose("The crank $OA$ **turns**.", "q1"))
    The crank $OA$ \textbf{turns}.
    """
    return _join(read_prose(markdown, where), where).rstrip("\n")


def write_line(markdown: str, where: str) -> str:
    r"""LaTeX for one line of Markdown: a title, the meaning of a symbol, a sign convention.

    >>> print(write_line("speed of $B$ & more", "q1"))
    speed of $B$ \& more
    """
    return _join(read_line(markdown, where), where)


def _join(tokens: Sequence[Token], where: str) -> str:
    leaves = find_leaves(tokens)
    return "".join(_write_written(leaves, index, where) for index in range(len(leaves)))


def _write_written(leaves: Sequence[Token], index: int, where: str) -> str:
    token = leaves[index]
    match token.type:
        case "text" | "text_special":
            return write_plain(token.content)
        case "softbreak":
            return "%\n" if is_between_wide(leaves, index) else "\n"
        case "math_inline":
            return f"${write_math(token.content.strip(), where)}$"
        case "math_inline_double" | "math_block":
            return f"\\[{write_math(token.content.strip(), where)}\\]"
        case "ordered_list_open":
            start = int(token.attrs.get("start", 1))
            return f"\\begin{{enumerate}}\\startat{{{start}}}\n"
        case "paragraph_close" if token.hidden:
            return ""
    return _WRITTEN[token.type]
