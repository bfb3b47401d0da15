"""Prose as nodes of pandoc's document tree, for Word and HTML."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from markdown_it import MarkdownIt

from kinegrade.language.math.latex import PANDOC, write_latex_math
from kinegrade.language.message import Location
from kinegrade.language.prose.pandoc_tree import (
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
from kinegrade.language.prose.rendering import ProseRenderer, make_reader


class _PandocRenderer(ProseRenderer[Node]):
    def text(self, plain: str, *, follows_formula: bool) -> Node:
        return make_text(plain)

    def formula(self, latex: str, where: Location) -> Node:
        return make_formula(latex, where)

    def displayed_formula(self, latex: str, where: Location) -> Node:
        return make_formula(latex, where, display=True)

    def formula_block(self, latex: str, where: Location) -> Node:
        return make_paragraph([self.displayed_formula(latex, where)])

    def line_end(self, *, printed: bool) -> Node:
        return make_text(" " if printed else "")

    def line_break(self) -> Node:
        return make_line_break()

    def strong(self, content: Sequence[Node]) -> Node:
        return make_strong(content)

    def emphasis(self, content: Sequence[Node]) -> Node:
        return make_emphasis(content)

    def paragraph(self, content: Sequence[Node]) -> Node:
        return make_paragraph(content)

    def short_item(self, content: Sequence[Node]) -> Node:
        return make_plain(content)

    def bullet_list(self, items: Sequence[Sequence[Node]]) -> Node:
        return make_bullets(items)

    def numbered_list(self, items: Sequence[Sequence[Node]], start: int) -> Node:
        return make_numbered(items, start)


def write_prose(markdown: str, where: Location) -> list[Node]:
    """Several paragraphs. Raises TypesetError with every fault of the text, each naming `where`."""
    nodes: list[Node] = _make_reader().render(markdown, {"where": where})
    return nodes


def write_line(markdown: str, where: Location) -> list[Node]:
    """One line of Markdown. Raises TypesetError as `write_prose` does.

    >>> write_line("speed of $B$", "q1")
    [{'t': 'Str', 'c': 'speed of '}, {'t': 'Math', 'c': [{'t': 'InlineMath'}, 'B']}]
    """
    nodes: list[Node] = _make_reader().renderInline(markdown, {"where": where})
    return nodes


def make_formula(latex: str, where: Location, *, display: bool = False) -> Node:
    """A formula. Raises TypesetError where it holds anything but the math that every press
    prints.
    """
    return make_math(write_latex_math(latex, where, PANDOC), display)


@lru_cache(maxsize=1)
def _make_reader() -> MarkdownIt:
    return make_reader(_PandocRenderer)
