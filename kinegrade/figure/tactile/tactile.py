"""A figure for the fingers: sheets for swell paper, on each of which everything keeps its distance.

The first sheets show bodies, joints and points, the next ones what is given, with the mechanism as
far as there is room for both. What has no room on a sheet goes to the next one; where something has
none on any, the whole figure is drawn smaller, upright or across.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from kinegrade.figure.marks.imposed import drop_still
from kinegrade.figure.mechanism.anatomy import Anatomy
from kinegrade.figure.mechanism.fitting import measure_span
from kinegrade.figure.mechanism.layers import draw
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.mechanism.view import crop_to_view
from kinegrade.figure.scene import Box, Primitive, Scene, find_common_box
from kinegrade.figure.tactile.filling import Filling
from kinegrade.figure.tactile.labels import Named
from kinegrade.figure.tactile.named import (
    Cells,
    list_body_names,
    list_given_pieces,
    list_letters,
    list_right_angles,
)
from kinegrade.figure.tactile.parts import Skeleton, list_parts
from kinegrade.figure.tactile.sheet import Sheet
from kinegrade.figure.tactile.sizes import EDGE_OF_PAGE, PAGE_HEIGHT, PAGE_WIDTH
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.problem.template.hints import FigureHints

_BESIDE = 36.0  # millimetres beside a mechanism in which labels stand
_SMALLER, _TRIALS, _ATTEMPTS = 0.9, 12, 5


@dataclass(frozen=True)
class TactileSheet:
    """One sheet of A4: its drawing, whether it shows what is `given`, and what its labels name."""

    scene: Scene
    given: bool
    named: tuple[Named, ...]


@dataclass(frozen=True)
class TactileFigure:
    """The sheets of a figure, and what has no room on any: named things, and a number of parts."""

    sheets: tuple[TactileSheet, ...]
    missing: tuple[Named, ...]
    missing_parts: int = 0

    @property
    def is_whole(self) -> bool:
        """Whether everything has room."""
        return not self.missing and self.missing_parts == 0


def draw_tactile(
    mechanism: Mechanism, hints: FigureHints, cells: Cells, number: Callable[[int], str]
) -> TactileFigure:
    """The tactile figure of a mechanism (floats, metres); `cells` writes a symbol in Braille,
    `number` what stands in the corner of a sheet, by its place.

    Raises TemplateError as `sketch` does.
    """
    figures = (
        _fill(skeleton, page, cells, number) for skeleton, page in _list_layouts(mechanism, hints)
    )
    tried: list[TactileFigure] = []
    for figure in figures:
        if figure.is_whole:
            return figure
        tried.append(figure)
    return min(tried, key=_count_missing)


def _count_missing(figure: TactileFigure) -> tuple[int, int]:
    return figure.missing_parts, len(figure.missing)


def _fill(
    skeleton: Skeleton, page: Box, cells: Cells, number: Callable[[int], str]
) -> TactileFigure:
    """The sheets of a mechanism that is as large as this."""
    parts = [*list_parts(skeleton), *list_right_angles(skeleton)]
    letters = list(list_letters(skeleton, cells))
    names = list(list_body_names(skeleton, cells))
    givens = list(list_given_pieces(skeleton, page, cells))
    filling = Filling(page, number, parts, letters)
    shown, lost_parts, lost_names = filling.fill_parts(names)
    given, lost = filling.fill_givens(givens, len(shown))
    sheets = [_finish(sheet, False, [*letters, *names]) for sheet in shown]
    sheets += [_finish(sheet, True, [*letters, *names, *givens]) for sheet in given]
    return TactileFigure(tuple(sheets), (*lost_names, *lost), len(lost_parts))


def _finish(sheet: Sheet, given: bool, everything: Sequence[Named]) -> TactileSheet:
    named = tuple(each for each in everything if each.piece in sheet.pieces)
    return TactileSheet(sheet.draw(), given, named)


def _list_layouts(mechanism: Mechanism, hints: FigureHints) -> Iterator[tuple[Skeleton, Box]]:
    """The mechanism in millimetres and the page about it: as large as a page has room for, then
    smaller, each time on the better side of the page before the other.
    """
    shown = crop_to_view(mechanism, hints)
    marked = drop_still(shown, hints)
    across, upward = measure_span(shown, marked)
    pages = [(PAGE_WIDTH, PAGE_HEIGHT), (PAGE_HEIGHT, PAGE_WIDTH)]
    if across * PAGE_HEIGHT > upward * PAGE_WIDTH * 1.2:
        pages.reverse()
    largest = [_fit(shown, marked, page, (across, upward)) for page in pages]
    for number in range(_ATTEMPTS):
        for page, scale in zip(pages, largest, strict=True):
            skeleton = _make_skeleton(shown, marked, scale * _SMALLER**number)
            yield skeleton, _centre(skeleton, page)


def _fit(
    shown: Mechanism, marked: FigureHints, page: tuple[float, float], span: tuple[float, float]
) -> float:
    """The scale at which the lines of a mechanism of that span lie within the page."""
    rooms = [(side - 2 * _BESIDE) / max(size, 1e-9) for side, size in zip(page, span, strict=True)]
    scale = min(rooms)
    for _ in range(_TRIALS):
        box = find_common_box(_list_lines(_make_skeleton(shown, marked, scale)))
        if max(box.width - page[0], box.height - page[1]) <= -2 * EDGE_OF_PAGE:
            break
        scale *= _SMALLER
    return scale


def _centre(skeleton: Skeleton, page: tuple[float, float]) -> Box:
    """A page with the lines of a mechanism in its middle."""
    width, height = page
    box = find_common_box(_list_lines(skeleton))
    left = (box.left + box.right - width) / 2
    bottom = (box.bottom + box.top - height) / 2
    return Box(left, bottom, left + width, bottom + height)


def _make_skeleton(mechanism: Mechanism, hints: FigureHints, scale: float) -> Skeleton:
    paper = scale_to_paper(mechanism, scale)
    return Skeleton(Anatomy.of(paper, hints), draw(paper, hints))


def _list_lines(skeleton: Skeleton) -> Iterator[Primitive]:
    for part in list_parts(skeleton):
        yield from part.ways[0].primitives
