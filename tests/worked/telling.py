"""A worked solution as plain text, one line for each thing told, for golden files and for looking
at.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from kinegrade.worked.document import Block, Display, Heading, Pictures, Prose, Results, TermTable


def lines(blocks: Iterable[Block]) -> Iterator[str]:
    """The lines of the blocks."""
    for block in blocks:
        match block:
            case Heading(text, level):
                yield f"{'#' * level} {text}"
            case Prose(text):
                yield text
            case Display(equations):
                yield from (f"    {equation}" for equation in equations)
            case TermTable(terms):
                for term in terms:
                    yield (
                        f"    [{term.sign or ' '}] {term.symbol} | {term.magnitude} | "
                        f"{term.direction}"
                    )
            case Pictures(pictures):
                yield from (f"    [picture: {picture.caption}]" for picture in pictures)
            case Results(results):
                for result in results:
                    exact = result.decimal if result.is_settled else result.exact
                    exact = result.exact or exact
                    yield (
                        f"    {result.symbol} = {exact} = {result.decimal} {result.unit} "
                        f"({result.sense})"
                    )


def mathematics(blocks: Iterable[Block]) -> Iterator[str]:
    """Every formula that the blocks hold, in LaTeX math."""
    for block in blocks:
        match block:
            case Display(equations):
                yield from (equation.replace("&", "") for equation in equations)
            case TermTable(terms):
                yield from (term.symbol for term in terms)
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
