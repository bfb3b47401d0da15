"""What the tables under vector equations say."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from kinegrade.problem.solution import Solution
from kinegrade.worked.case import write_row
from kinegrade.worked.document import Block, Display, Heading, Pictures, Prose, TermTable
from tests.worked.reader.givens import read_givens

_POINT = r"[A-Z](?:'|_\{\w+\})*"
_ARM = re.compile(rf"(?<![A-Za-z}}])({_POINT}{_POINT}) \\cdot")
_DEFINED = re.compile(rf"\$({_POINT}{_POINT}) = ")


def find_without_sense(blocks: Sequence[Block]) -> Iterator[str]:
    """The vectors of which a table says along or across which line they lie, not to which side."""
    for block in blocks:
        for term in block.terms if isinstance(block, TermTable) else ():
            across = r"\perp" in term.direction and r"\curvearrow" not in term.direction
            if across or r"\parallel" in term.direction:
                yield f"{write_row(term.symbol)}: {term.direction}"


def find_early(blocks: Sequence[Block], solution: Solution) -> Iterator[str]:
    """The distances of points that a table takes before they have been given or found."""
    known = {re.sub(r"_(\w)(?=\w)", r"_{\1}", symbol) for symbol, _ in read_givens(solution)}
    for block in blocks:
        match block:
            case Prose(text):
                known.update(_DEFINED.findall(text))
            case Display(lines):
                known.update(write_row(row).split(" &=")[0] for row in lines)
            case TermTable(terms):
                for term in terms:
                    lengths = _ARM.findall(term.magnitude)
                    yield from (f"{one} in {term.magnitude}" for one in lengths if one not in known)
            case Heading() | Pictures():
                continue
