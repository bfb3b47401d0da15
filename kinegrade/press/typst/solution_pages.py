"""How a student's worked solutions take few pages: with more or less room between blocks and lines,
and without pictures that can be spared where a solution would take more than two pages; then with
the least room.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from itertools import chain

from kinegrade.press.binding.part import count_pages
from kinegrade.press.sheet import PaperSize, SolutionSheet
from kinegrade.press.solutions.settings import DENSE, TIGHT, USUAL
from kinegrade.press.solutions.shortening import MOST_PAGES, list_shorter, shorten
from kinegrade.press.typst.solution import SolutionLayouts
from kinegrade.press.typst.solution_area import find_area

Typeset = Callable[[str], bytes]  # a PDF of Typst source


def set_short(sheet: SolutionSheet, size: PaperSize, typeset: Typeset) -> bytes:
    """The sheet as PDF, at most two pages for each solution where pictures that can be spared, or
    else lines close together, allow it; with the pictures where it does not become short so.
    """
    shorter, most = tuple(_list_shorter_sheets(sheet, size)), MOST_PAGES * len(sheet.questions)
    set_evenly = (_set_evenly(one, size, typeset) for one in shorter)
    first = next(set_evenly)
    every = chain((first,), set_evenly, _set_densely(shorter, most, size, typeset))
    return next((pdf for pdf in every if count_pages(pdf) <= most), first)


def _set_densely(
    sheets: Iterable[SolutionSheet], most: int, size: PaperSize, typeset: Typeset
) -> Iterator[bytes]:
    """The sheets that may so take the fewest pages, with their lines close together."""
    for sheet in sheets:
        layouts = SolutionLayouts(sheet, size)
        if layouts.may_take_fewer(most + 1, DENSE):
            yield typeset(layouts.write(DENSE))


def _list_shorter_sheets(sheet: SolutionSheet, size: PaperSize) -> Iterator[SolutionSheet]:
    """The sheet with solutions that take at most two pages each by the heights of their parts, then
    with fewer and fewer pictures. Large print has all of them.
    """
    if sheet.large:
        yield sheet
        return
    area = find_area(sheet, size, TIGHT)
    questions = [shorten(question, area) for question in sheet.questions]
    yield replace(sheet, questions=tuple(questions))
    shorter = [(question, *list_shorter(question)) for question in questions]
    for stage in range(1, max(map(len, shorter), default=0)):
        yield replace(sheet, questions=tuple(one[min(stage, len(one) - 1)] for one in shorter))


def _set_evenly(sheet: SolutionSheet, size: PaperSize, typeset: Typeset) -> bytes:
    """A sheet set tighter where that saves a page, and looser where it does not and the last page
    would not be half full; with its lines close together where less than a third of a page is
    saved so. What saves a page by far is typeset tight at once.
    """
    layouts = SolutionLayouts(sheet, size)
    spread, foreseen = layouts.choose_spread(), layouts.foresee_pages()
    if spread == USUAL and foreseen is not None and layouts.may_take_fewer(foreseen):
        tight = typeset(layouts.write(TIGHT))
        if count_pages(tight) < foreseen:
            return tight
    usual = typeset(layouts.write(spread))
    pages = count_pages(usual)
    if pages > 1 and spread == USUAL and layouts.may_take_fewer(pages):
        tight = typeset(layouts.write(TIGHT))
        usual = tight if count_pages(tight) < pages else usual
    if count_pages(usual) == pages > 1 and layouts.may_spill():
        dense = typeset(layouts.write(DENSE))
        usual = dense if count_pages(dense) < pages else usual
    return usual
