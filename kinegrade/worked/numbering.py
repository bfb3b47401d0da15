"""The numbers of steps, which only a chapter of several steps has."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import accumulate

from kinegrade.language.message import Message
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block, Heading


def number_steps(blocks: Sequence[Block], case: Case) -> Iterator[Block]:
    """The blocks with the titles of the steps of each chapter numbered, where it has several."""
    chapters = list(accumulate(_is_heading(block, 1) for block in blocks))
    steps = Counter(
        chapter for chapter, block in zip(chapters, blocks, strict=True) if _is_heading(block, 2)
    )
    numbers: Counter[int] = Counter()
    for chapter, block in zip(chapters, blocks, strict=True):
        if isinstance(block, Heading) and block.level == 2 and steps[chapter] > 1:
            numbers[chapter] += 1
            numbered = Message("solution.step", number=numbers[chapter], title=block.text)
            yield replace(block, text=case.write(numbered))
        else:
            yield block


def _is_heading(block: Block, level: int) -> bool:
    return isinstance(block, Heading) and block.level == level
