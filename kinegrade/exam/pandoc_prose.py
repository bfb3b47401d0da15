"""Prose and math into pandoc's document tree: what `kinegrade.exam.markup` does for Typst."""

from __future__ import annotations

from collections.abc import Sequence

from markdown_it.token import Token
from markdown_it.tree import SyntaxTreeNode

from kinegrade.errors import TypesetError
from kinegrade.exam.formula import TEXT, require_known_math, write_unit
from kinegrade.exam.markup import is_between_wide, read_line, read_prose
from kinegrade.exam.pandoc_tree import (
    Node,
    make_bullets,
    make_emphasis,
    make_line_break,
    make_math,
    make_numbered,
    make_paragraph,
    make_plain,
    make_strong,
    make_text,
)


def write_prose_blocks(markdown: str, where: str) -> list[Node]:
    """Several paragraphs. Raises TypesetError with every fault of the text, each naming `where`."""
    return _write_blocks(SyntaxTreeNode(read_prose(markdown, where)), where)


def write_line_inlines(markdown: str, where: str) -> list[Node]:
    """One line of Markdown. Raises TypesetError as `write_prose_blocks` does.

    >>> write_line_inlines("speed of $B$", "q1")
    [{'t': 'Str', 'c': 'speed of '}, {'t': 'Math', 'c': [{'t': 'InlineMath'}, 'B']}]
    """
    return _write_inlines(SyntaxTreeNode(read_line(markdown, where)).children[0], where)


def write_math_inline(latex: str, where: str, display: bool = False) -> Node:
    """A formula. Raises TypesetError where it holds anything but the math that every press
    prints.
    """
    return make_math(
        TEXT.sub(
            lambda match: _write_written(match[1], match[2]),
            require_known_math(latex.strip(), where),
        ),
        display,
    )


def _write_written(words: str | None, comma: str | None) -> str:
    """`\\text{...}` and `\\unit{...}` with raised exponents; a decimal comma as text, with no space
    behind it.
    """
    return f"\\text{{{comma or write_unit(words or '')}}}"


def _write_blocks(parent: SyntaxTreeNode, where: str) -> list[Node]:
    return [block for child in parent.children for block in _write_block(child, where)]


def _write_block(node: SyntaxTreeNode, where: str) -> list[Node]:
    match node.type:
        case "paragraph":
            return [
                (make_plain if node.hidden else make_paragraph)(
                    _write_inlines(node.children[0], where)
                )
            ]
        case "bullet_list":
            return [make_bullets([_write_blocks(item, where) for item in node.children])]
        case "ordered_list":
            return [
                make_numbered(
                    [_write_blocks(item, where) for item in node.children],
                    int(node.attrs.get("start", 1)),
                )
            ]
        case "math_block":
            return [make_paragraph([write_math_inline(node.content, where, display=True)])]
        case _:
            raise TypesetError(f"{where}: {node.type} cannot be shown in Word or HTML")


def _write_inlines(parent: SyntaxTreeNode, where: str) -> list[Node]:
    tokens = [token for child in parent.children if (token := child.token or _find_opening(child))]
    return [
        inline
        for index, child in enumerate(parent.children)
        for inline in _write_inline(child, tokens, index, where)
    ]


def _find_opening(node: SyntaxTreeNode) -> Token | None:
    return node.nester_tokens.opening if node.nester_tokens else None


def _write_inline(
    node: SyntaxTreeNode, siblings: Sequence[Token], index: int, where: str
) -> list[Node]:
    match node.type:
        case "text" | "text_special":
            return [make_text(node.content)] if node.content else []
        case "softbreak":
            return [] if is_between_wide(siblings, index) else [make_text(" ")]
        case "hardbreak":
            return [make_line_break()]
        case "strong":
            return [make_strong(_write_inlines(node, where))]
        case "em":
            return [make_emphasis(_write_inlines(node, where))]
        case "math_inline":
            return [write_math_inline(node.content, where)]
        case "math_inline_double":
            return [write_math_inline(node.content, where, display=True)]
        case _:
            raise TypesetError(f"{where}: {node.type} cannot be shown in Word or HTML")
