"""A worked solution as plain text, one line for each thing told, for golden files and for looking
at.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import Literal

from typing_extensions import TypeIs

from kinegrade.language.math.reading import read_math
from kinegrade.language.math.tree import Accent, Node, Row
from kinegrade.worked.case import write_row
from kinegrade.worked.document import (
    Block,
    Display,
    Heading,
    Pictures,
    Prose,
    Term,
    TermTable,
)


def tidy(latex: str) -> str:
    """A formula with blanks where a tree is written with them."""
    return write_row(read_math(latex, "test"))


def tidy_prose(text: str) -> str:
    """Prose with its formulas written so."""
    return re.sub(r"\$([^$]*)\$", lambda formula: f"${tidy(formula[1])}$", text)


def read_display(lines: Iterable[str]) -> Display:
    """A display of lines in LaTeX math."""
    return Display(tuple(read_math(line, "test") for line in lines))


def read_term(
    sign: Literal["", "+", "-", "="], symbol: str, magnitude: str, direction: str
) -> Term:
    """A column of a table with its symbol in LaTeX math."""
    return Term(sign, read_math(symbol, "test"), magnitude, direction)


def displayed(blocks: Iterable[Block]) -> list[str]:
    """The lines of all displays, in LaTeX math, without the boxes around answers."""
    return [write_row(unbox(line)) for line in _list_lines(blocks)]


def boxed(blocks: Iterable[Block]) -> list[str]:
    """What stands in boxes, in LaTeX math."""
    nodes = (node for line in _list_lines(blocks) for node in line)
    return [write_row(node.row) for node in nodes if is_box(node)]


def _list_lines(blocks: Iterable[Block]) -> Iterator[Row]:
    for block in blocks:
        if isinstance(block, Display):
            yield from block.lines


def is_box(node: Node) -> TypeIs[Accent]:
    """Whether a node is a box."""
    return isinstance(node, Accent) and node.name == "boxed"


def unbox(line: Row) -> Row:
    """A line with what stands in boxes, but without these."""
    return tuple(inner for node in line for inner in (node.row if is_box(node) else (node,)))


def lines(blocks: Iterable[Block], *, boxes: bool = True) -> Iterator[str]:
    """The lines of the blocks, with or without the boxes around answers."""
    for block in blocks:
        match block:
            case Heading(text, level):
                yield f"{'#' * level} {text}"
            case Prose(text):
                yield text
            case Display(equations):
                shown = equations if boxes else map(unbox, equations)
                yield from (f"    {write_row(equation)}" for equation in shown)
            case TermTable(terms):
                for term in terms:
                    yield (
                        f"    [{term.sign or ' '}] {write_row(term.symbol)} | {term.magnitude} | "
                        f"{term.direction}"
                    )
            case Pictures(pictures):
                yield from (f"    [picture: {picture.caption}]" for picture in pictures)


def mathematics(blocks: Iterable[Block]) -> Iterator[str]:
    """Every formula that the blocks hold, in LaTeX math."""
    for block in blocks:
        match block:
            case Display(equations):
                yield from (write_row(equation).replace("&", "") for equation in equations)
            case TermTable(terms):
                yield from (write_row(term.symbol) for term in terms)


def proses(blocks: Iterable[Block]) -> Iterator[str]:
    """Every prose text that the blocks hold."""
    for block in blocks:
        match block:
            case Heading(text, _) | Prose(text):
                yield text
            case TermTable(terms):
                for term in terms:
                    yield from (term.magnitude, term.direction)
            case Pictures(pictures):
                yield from (picture.caption for picture in pictures)
