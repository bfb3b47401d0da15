"""A worked solution takes at most two pages where it does so without pictures that it can spare,
and one where little would stand on the second: polygons go first, whose vectors stand in tables and
are found by projections, then sketches of velocities after the first, then this. Where no picture
saves a page, the second check goes.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import ceil, floor

from kinegrade.press.sheet import WorkedQuestion
from kinegrade.press.solutions.course import TextArea, arrange_courses
from kinegrade.worked.document import Block, Pictures, Prose

MOST_PAGES = 2
_NEARLY_EMPTY = 0.25  # of a last page: what it holds is less than that


def shorten(question: WorkedQuestion, area: TextArea) -> WorkedQuestion:
    """The question with as many of its pictures as have room on two pages, by the heights of its
    parts, or on the fewest that it takes without them; on one less where the last would be nearly
    empty.
    """
    pages = _measure(question, area)
    if pages <= MOST_PAGES and pages - floor(pages) >= _NEARLY_EMPTY:
        return question
    choices = [(one, ceil(_measure(one, area))) for one in list_shorter(question)]
    fewest = min((count for _, count in choices), default=ceil(pages))
    most = max(MOST_PAGES, fewest) if pages > MOST_PAGES else floor(pages)
    shorter = (one for one, count in choices if count <= most < pages)
    return next(shorter, question)


def list_shorter(question: WorkedQuestion) -> Iterator[WorkedQuestion]:
    """What is left of the question with fewer and fewer pictures, then without its second check."""
    yield from _list_less_drawn(question)
    unchecked = replace(question, blocks=tuple(_leave_out_second_check(question.blocks)))
    if unchecked.blocks != question.blocks:
        yield unchecked
        yield from _list_less_drawn(unchecked)


def _list_less_drawn(question: WorkedQuestion) -> Iterator[WorkedQuestion]:
    without = tuple(_leave_out_polygons(question.blocks))
    if without != question.blocks:
        yield replace(question, blocks=without)
    for most in (1, 0):
        left = tuple(_leave_out_sketches(without, most))
        if left != without:
            yield replace(question, blocks=left)


def _measure(question: WorkedQuestion, area: TextArea) -> float:
    """About how many pages a question takes by itself."""
    return arrange_courses([question], area).pages


def _leave_out_polygons(blocks: Sequence[Block]) -> Iterator[Block]:
    """The blocks without polygons, and without what is said of their corners."""
    for block in blocks:
        match block:
            case Pictures(pictures):
                left = tuple(one for one in pictures if one.kind != "polygon")
                yield from [Pictures(left)] if left else []
            case Prose(on_polygon=True):
                continue
            case _:
                yield block


def _leave_out_sketches(blocks: Sequence[Block], most: int) -> Iterator[Block]:
    """The blocks with so many of the sketches of velocities, the first ones."""
    sketched = 0
    for block in blocks:
        if not isinstance(block, Pictures):
            yield block
            continue
        left = tuple(one for one in block.pictures if one.kind != "velocities" or sketched < most)
        sketched += sum(one.kind == "velocities" for one in block.pictures)
        yield from [Pictures(left)] if left else []


def _leave_out_second_check(blocks: Sequence[Block]) -> Iterator[Block]:
    """The blocks with the first of the checks alone, and what that needs."""
    checked = 0
    for block in blocks:
        if isinstance(block, Prose) and block.on_check:
            if checked:
                continue
            checked += block.compact
        yield block
