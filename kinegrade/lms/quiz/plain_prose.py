"""Prose as one line of plain text, for titles and for systems that take no HTML."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import lru_cache

from markdown_it.token import Token

from kinegrade.exam.markup import find_leaves, is_between_wide, read_line, read_prose
from kinegrade.lms.quiz.plain_math import write_plain_math

_UNPRINTED = re.compile("[\x00-\x1f\x7f-\x9f\u2028\u2029\ufffe\uffff\ud800-\udfff]+")
_BLANKS = re.compile(r"[\s\u2028\u2029]+")


def write_one_plain_line(text: str) -> str:
    r"""Plain text without line breaks, tabs and characters that XML does not allow.

    >>> write_one_plain_line("a\tb\n\x00c")
    'a b c'
    """
    return _BLANKS.sub(" ", _UNPRINTED.sub(" ", text)).strip()


@lru_cache(maxsize=256)
def write_plain_prose(markdown: str, where: str = "text", *, inline: bool = False) -> str:
    """Markdown with `$...$` math in one line of plain text; `inline` where it is one line already.
    Raises TypesetError.

    >>> write_plain_prose("The **crank** $OA$ turns.\\n\\nFind $v_B$.")
    'The crank OA turns. Find v_B.'
    """
    leaves = find_leaves((read_line if inline else read_prose)(markdown, where))
    return write_one_plain_line(
        "".join(_write_written(leaves, index, where) for index in range(len(leaves)))
    )


def _write_written(leaves: Sequence[Token], index: int, where: str) -> str:
    token = leaves[index]
    match token.type:
        case "text" | "text_special":
            return token.content
        case "softbreak":
            return "" if is_between_wide(leaves, index) else " "
        case "math_inline" | "math_inline_double" | "math_block":
            return write_plain_math(token.content.strip(), where)
        case "list_item_open":
            return " - "
        case "paragraph_close" | "hardbreak":
            return " "
        case _:
            return ""  # an opening or closing mark, which has no text
