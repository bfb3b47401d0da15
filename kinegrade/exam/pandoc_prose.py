"""Prose and math into pandoc's document tree: what `kinegrade.exam.markup` does for Typst."""

from __future__ import annotations

from collections.abc import Sequence

from markdown_it.token import Token
from markdown_it.tree import SyntaxTreeNode

from kinegrade.errors import TypesetError
from kinegrade.exam.formula import TEXT, checked, unit_text
from kinegrade.exam.markup import between_wide, read_line, read_prose
from kinegrade.exam.pandoc_tree import (
    Node,
    bullets,
    emphasis,
    line_break,
    math,
    numbered,
    paragraph,
    plain,
    strong,
    text,
)


def prose_blocks(markdown: str, where: str) -> list[Node]:
    """Several paragraphs. Raises TypesetError with every fault of the text, each naming `where`."""
    return _blocks(SyntaxTreeNode(read_prose(markdown, where)), where)


def line_inlines(markdown: str, where: str) -> list[Node]:
    """One line of Markdown. Raises TypesetError as `prose_blocks` does.

    >>> line_inlines("speed of $B$", "q1")
    [{'t': 'Str', 'c': 'speed of '}, {'t': 'Math', 'c': [{'t': 'InlineMath'}, 'B']}]
    """
    return _inlines(SyntaxTreeNode(read_line(markdown, where)).children[0], where)


def math_inline(latex: str, where: str, display: bool = False) -> Node:
    """A formula. Raises TypesetError where it holds anything but the math that every press
    prints.
    """
    return math(
        TEXT.sub(lambda match: _written(match[1], match[2]), checked(latex.strip(), where)), display
    )


def _written(words: str | None, comma: str | None) -> str:
    """`\\text{...}` and `\\unit{...}` with raised exponents; a decimal comma as text, with no space
    behind it.
    """
    return f"\\text{{{comma or unit_text(words or '')}}}"


def _blocks(parent: SyntaxTreeNode, where: str) -> list[Node]:
    return [block for child in parent.children for block in _block(child, where)]


def _block(node: SyntaxTreeNode, where: str) -> list[Node]:
    match node.type:
        case "paragraph":
            return [(plain if node.hidden else paragraph)(_inlines(node.children[0], where))]
        case "bullet_list":
            return [bullets([_blocks(item, where) for item in node.children])]
        case "ordered_list":
            return [
                numbered(
                    [_blocks(item, where) for item in node.children],
                    int(node.attrs.get("start", 1)),
                )
            ]
        case "math_block":
            return [paragraph([math_inline(node.content, where, display=True)])]
        case _:
            raise TypesetError(f"{where}: {node.type} cannot be shown in Word or HTML")


def _inlines(parent: SyntaxTreeNode, where: str) -> list[Node]:
    tokens = [token for child in parent.children if (token := child.token or _opening(child))]
    return [
        inline
        for index, child in enumerate(parent.children)
        for inline in _inline(child, tokens, index, where)
    ]


def _opening(node: SyntaxTreeNode) -> Token | None:
    return node.nester_tokens.opening if node.nester_tokens else None


def _inline(node: SyntaxTreeNode, siblings: Sequence[Token], index: int, where: str) -> list[Node]:
    match node.type:
        case "text" | "text_special":
            return [text(node.content)] if node.content else []
        case "softbreak":
            return [] if between_wide(siblings, index) else [text(" ")]
        case "hardbreak":
            return [line_break()]
        case "strong":
            return [strong(_inlines(node, where))]
        case "em":
            return [emphasis(_inlines(node, where))]
        case "math_inline":
            return [math_inline(node.content, where)]
        case "math_inline_double":
            return [math_inline(node.content, where, display=True)]
        case _:
            raise TypesetError(f"{where}: {node.type} cannot be shown in Word or HTML")
