"""Prose into Typst: Markdown with `$...$` LaTeX math becomes a Typst code block that yields
content.

Text leaves here only as string literals and formulas only through `kinegrade.exam.formula`, so
nothing in a statement or title can become Typst code. Paragraphs, emphasis, lists and math are what
an exam needs; anything else is refused by name. `kinegrade.exam.typst_source` puts the pieces of a
paper together.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import lru_cache
from itertools import chain
from unicodedata import east_asian_width

from markdown_it import MarkdownIt
from markdown_it.token import Token
from mdit_py_plugins.dollarmath import dollarmath_plugin

from kinegrade.errors import TypesetError, write_message
from kinegrade.exam.formula import convert_formula, write_literal

_BRACKETS = {
    "paragraph_open": "",
    "paragraph_close": "parbreak()",
    "strong_open": "strong({",
    "strong_close": "})",
    "em_open": "emph({",
    "em_close": "})",
    "bullet_list_open": "list(",
    "bullet_list_close": ")",
    "ordered_list_close": ")",
    "list_item_open": "{",
    "list_item_close": "},",
    "hardbreak": "linebreak()",
}
_REFUSED = {
    "image": "an image",
    "html_inline": "raw HTML",
    "html_block": "raw HTML",
    "link_open": "a link",
    "heading_open": "a heading",
    "blockquote_open": "a quotation",
    "code_inline": "code",
    "code_block": "code (a line indented by four blanks)",
    "fence": "code",
    "hr": "a rule across the page",
    "math_block_label": "a labelled formula",
}
_MATH = re.compile(r"\$([^$\n]+)\$")
_ANY_FORMULA = "0"  # stands for each while the words are read
_EXPECTED = "text, **bold**, *emphasis*, lists and $math$"


@lru_cache(maxsize=1024)
def write_prose(markdown: str, where: str) -> str:
    """Typst code (an expression yielding content) for several paragraphs of Markdown.

    Raises TypesetError with every fault of the text, each naming `where`.

    >>> print(write_prose("The crank $OA$ turns.", "q1"))
    {"The crank ";box($O A$);" turns.";}
    """
    code = _write_around_formulas(markdown) or _join(
        read_prose(markdown, where), where
    ).removesuffix("parbreak();")
    return "{" + code + "}"


def _write_around_formulas(markdown: str) -> str | None:
    """The code of a text that differs from one already converted in its formulas alone; None if it
    must be read as a whole, for instance to report its faults.
    """
    separated = _separate_formulas(markdown)
    if separated is None:
        return None
    words, formulas = separated
    try:
        between = _write_between_formulas(words)
        inserted = [_write_boxed(latex, "") for latex in formulas]
    except TypesetError:
        return None
    return "".join(chain.from_iterable(zip(between, [*inserted, ""], strict=True)))


@lru_cache(maxsize=1024)
def _write_between_formulas(words: str) -> tuple[str, ...]:
    """The code between the formulas of `words`. Dollar signs stand only around formulas there, so
    that no text can look like a formula's code.
    """
    code = _join(read_prose(words, ""), "").removesuffix("parbreak();")
    return tuple(code.split(_write_boxed(_ANY_FORMULA, "")))


def write_line(markdown: str, where: str) -> str:
    """Typst code for one line of Markdown: a title, the meaning of a symbol, a sign convention.

    >>> print(write_line("speed of $B$", "q1"))
    {"speed of ";box($B$);}
    """
    try:
        return _write_line(markdown)
    except TypesetError:
        read_line(markdown, where)
        raise


@lru_cache(maxsize=4096)
def _write_line(markdown: str) -> str:
    """The same wherever it is used, so that the papers of a class share it."""
    return "{" + _join(read_line(markdown, ""), "") + "}"


def read_prose(markdown: str, where: str) -> list[Token]:
    """The tokens of several paragraphs, none of them in `_REFUSED`. Raises TypesetError as
    `write_prose` does.
    """
    tokens = _insert_math(markdown) or _make_reader().parse(markdown)
    _refuse_faults(tokens, where)
    return tokens


def _insert_math(markdown: str) -> list[Token] | None:
    """The tokens of a text, whose words are read once for all its formulas: papers differ only in
    these. None if what is between dollar signs may not be a formula.
    """
    separated = _separate_formulas(markdown)
    if separated is None:
        return None
    words, formulas = separated
    following = iter(formulas)
    tokens = [token.copy() for token in _read_words(words)[0]]
    for token in tokens:
        token.children = token.children and [
            leaf.copy(content=next(following)) if leaf.type == "math_inline" else leaf
            for leaf in token.children
        ]
    return tokens


def _separate_formulas(markdown: str) -> tuple[str, list[str]] | None:
    """The text with the same short formula in the place of each, and the formulas; None as for
    `_insert_math`.
    """
    parts = _MATH.split(markdown)
    words, formulas = f"${_ANY_FORMULA}$".join(parts[::2]), parts[1::2]
    if markdown.count("$") != 2 * len(formulas) or "\\$" in markdown or "`" in markdown:
        return None
    return (words, formulas) if _read_words(words)[1] == len(formulas) else None


@lru_cache(maxsize=1024)
def _read_words(words: str) -> tuple[tuple[Token, ...], int]:
    """The tokens of a text, and how many formulas in a line are among them."""
    tokens = tuple(_make_reader().parse(words))
    return tokens, sum(
        leaf.type == "math_inline" for token in tokens for leaf in token.children or ()
    )


def read_line(markdown: str, where: str) -> list[Token]:
    """The tokens of one line, none of them in `_REFUSED`. Raises TypesetError as `write_line`
    does.
    """
    tokens = _make_reader().parseInline(markdown)
    _refuse_faults(tokens, where)
    return tokens


@lru_cache(maxsize=1)
def _make_reader() -> MarkdownIt:
    reader = MarkdownIt("commonmark", {"typographer": True}).enable("smartquotes")
    return reader.use(dollarmath_plugin, double_inline=True)


def _refuse_faults(tokens: Sequence[Token], where: str) -> None:
    problems = [problem for token in find_leaves(tokens) for problem in _find_faults(token, where)]
    if problems:
        raise TypesetError(*problems)


def find_leaves(tokens: Sequence[Token]) -> list[Token]:
    """The tokens in the order of the text, inline ones instead of their container."""
    groups = (token.children or [] if token.type == "inline" else [token] for token in tokens)
    return [leaf for group in groups for leaf in group]


def _find_faults(token: Token, where: str) -> tuple[str, ...]:
    if token.type in _REFUSED:
        shown = f" ({token.content.strip()})" if token.content.strip() else ""
        what = f"{_REFUSED[token.type]}{shown} cannot be printed"
        return (write_message(where, what, _EXPECTED, "take it out"),)
    if token.type.startswith("math_"):
        try:
            convert_formula(token.content.strip(), where)
        except TypesetError as error:
            return error.problems
    return ()


def _join(tokens: Sequence[Token], where: str) -> str:
    """One Typst statement after another; semicolons keep them apart on one line."""
    leaves = find_leaves(tokens)
    return "".join(_write_statement(leaves, index, where) for index in range(len(leaves)))


def _write_statement(leaves: Sequence[Token], index: int, where: str) -> str:
    token = leaves[index]
    match token.type:
        case "text" | "text_special":
            return (
                f"{write_literal(_write_glue(leaves, index) + token.content)};"
                if token.content
                else ""
            )
        case "softbreak":
            return "" if is_between_wide(leaves, index) else '" ";'
        case "math_inline":
            return _write_boxed(token.content, where)
        case "math_inline_double" | "math_block":
            return f"$ {convert_formula(token.content.strip(), where)} $;"
        case "ordered_list_open":
            return f"enum(start: {int(token.attrs.get('start', 1))}, "
        case "paragraph_close" if token.hidden:
            return ""
    code = _BRACKETS[token.type]
    return code if not code or code[-1] in "({," else f"{code};"


def _write_boxed(latex: str, where: str) -> str:
    """A formula in its line, in a box, so that a value is not separated from its symbol."""
    return f"box(${convert_formula(latex.strip(), where)}$);"


def _write_glue(leaves: Sequence[Token], index: int) -> str:
    """A word joiner between a formula and a Chinese colon or semicolon, which by Unicode's rules
    could otherwise begin a line.
    """
    after_math = index > 0 and leaves[index - 1].type == "math_inline"
    return "\u2060" if after_math and leaves[index].content[0] in "：；" else ""


def is_between_wide(leaves: Sequence[Token], index: int) -> bool:
    """Whether a line end stands between two Chinese characters, where it must not print a blank."""
    before = leaves[index - 1].content[-1:] if index else ""
    after = leaves[index + 1].content[:1] if index + 1 < len(leaves) else ""
    return all(character and east_asian_width(character) in "WF" for character in (before, after))
