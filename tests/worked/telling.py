"""A worked solution as plain text, one line for each thing told, for golden files and for looking
at.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import Literal

from kinegrade.language.math.reading import read_math
from kinegrade.language.math.tree import Row
from kinegrade.worked.case import write_row
from kinegrade.worked.document import (
    Block,
    Display,
    Heading,
    Pictures,
    Prose,
    Results,
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
    """The lines of all displays, in LaTeX math."""
    shown: list[Row] = [
        line for block in blocks if isinstance(block, Display) for line in block.lines
    ]
    return [write_row(line) for line in shown]


def lines(blocks: Iterable[Block]) -> Iterator[str]:
    """The lines of the blocks."""
    for block in blocks:
        match block:
            case Heading(text, level):
                yield f"{'#' * level} {text}"
            case Prose(text):
                yield text
            case Display(equations):
                yield from (f"    {write_row(equation)}" for equation in equations)
            case TermTable(terms):
                for term in terms:
                    yield (
                        f"    [{term.sign or ' '}] {write_row(term.symbol)} | {term.magnitude} | "
                        f"{term.direction}"
                    )
            case Pictures(pictures):
                yield from (f"    [picture: {picture.caption}]" for picture in pictures)
            case Results(results):
                for result in results:
                    exact = result.decimal if result.is_settled else result.exact
                    exact = result.exact or exact
                    if not result.decimal:
                        yield f"    {result.symbol} = {exact}"
                        continue
                    yield (
                        f"    {result.symbol} = {exact} = {result.decimal} {result.unit} "
                        f"({result.sense})"
                    )


def mathematics(blocks: Iterable[Block]) -> Iterator[str]:
    """Every formula that the blocks hold, in LaTeX math."""
    for block in blocks:
        match block:
            case Display(equations):
                yield from (write_row(equation).replace("&", "") for equation in equations)
            case TermTable(terms):
                yield from (write_row(term.symbol) for term in terms)
            case Results(results):
                for result in results:
                    yield result.symbol
                    yield result.exact or "0"


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
            case Results(results):
                yield from (result.sense for result in results)
