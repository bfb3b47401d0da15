"""What the tables under vector equations say."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinegrade.worked.case import write_row
from kinegrade.worked.document import Block, TermTable


def find_without_sense(blocks: Sequence[Block]) -> Iterator[str]:
    """The vectors of which a table says along or across which line they lie, not to which side."""
    for block in blocks:
        for term in block.terms if isinstance(block, TermTable) else ():
            across = r"\perp" in term.direction and r"\curvearrow" not in term.direction
            if across or r"\parallel" in term.direction:
                yield f"{write_row(term.symbol)}: {term.direction}"
