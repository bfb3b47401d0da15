"""A worked solution in the parts that are shown one after the other, as hints."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinegrade.worked.document import Block, Heading


def split_sections(blocks: Sequence[Block]) -> Iterator[tuple[Block, ...]]:
    """The blocks from each heading, or headings one below the other, to the next."""
    section: list[Block] = []
    for block in blocks:
        if isinstance(block, Heading) and section and not isinstance(section[-1], Heading):
            yield tuple(section)
            section = []
        section.append(block)
    if section:
        yield tuple(section)
