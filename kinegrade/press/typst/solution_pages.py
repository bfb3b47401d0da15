"""How a student's worked solutions take few pages: with more or less room between blocks and lines,
and without pictures that can be spared where a solution would take more than two pages.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from kinegrade.press.binding.part import count_pages
from kinegrade.press.sheet import PaperSize, SolutionSheet
from kinegrade.press.solutions.settings import TIGHT, USUAL
from kinegrade.press.solutions.shortening import MOST_PAGES, list_shorter, shorten
from kinegrade.press.typst.solution import SolutionLayouts
from kinegrade.press.typst.solution_area import find_area

Typeset = Callable[[str], bytes]  # a PDF of Typst source


def set_short(sheet: SolutionSheet, size: PaperSize, typeset: Typeset) -> bytes:
    """The sheet as PDF, at most two pages for each solution where pictures that can be spared allow
    it; with the pictures where it does not become short without them.
    """
    shorter = _list_shorter_sheets(sheet, size)
    first = fewest = _set_evenly(next(shorter), size, typeset)
    while count_pages(fewest) > MOST_PAGES * len(sheet.questions):
        following = next(shorter, None)
        if following is None:
            return first
        fewest = _set_evenly(following, size, typeset)
    return fewest


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
    would hold a few lines only. What saves a page by far is typeset tight at once.
    """
    layouts = SolutionLayouts(sheet, size)
    spread, foreseen = layouts.choose_spread(), layouts.foresee_pages()
    if spread == USUAL and foreseen is not None and layouts.may_take_fewer(foreseen):
        tight = typeset(layouts.write(TIGHT))
        if count_pages(tight) < foreseen:
            return tight
    usual = typeset(layouts.write(spread))
    pages = count_pages(usual)
    if pages == 1 or spread != USUAL or not layouts.may_take_fewer(pages):
        return usual
    tight = typeset(layouts.write(TIGHT))
    return tight if count_pages(tight) < pages else usual
