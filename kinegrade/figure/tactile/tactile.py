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
from kinegrade.figure.scene import Box, Disc, Primitive, Scene, find_common_box
from kinegrade.figure.tactile.braille import measure_label
from kinegrade.figure.tactile.labels import Named
from kinegrade.figure.tactile.named import (
    Cells,
    list_body_names,
    list_given_pieces,
    list_letters,
    list_right_angles,
)
from kinegrade.figure.tactile.parts import Skeleton, list_parts
from kinegrade.figure.tactile.piece import Piece
from kinegrade.figure.tactile.sheet import Sheet
from kinegrade.figure.tactile.sizes import EDGE_OF_PAGE, PAGE_HEIGHT, PAGE_WIDTH
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
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
    filling = _Filling(page, number, parts, letters)
    shown, lost_parts, lost_names = filling.fill_parts(names)
    given, lost = filling.fill_givens(givens, len(shown))
    sheets = [_finish(sheet, False, [*letters, *names]) for sheet in shown]
    sheets += [_finish(sheet, True, [*letters, *names, *givens]) for sheet in given]
    return TactileFigure(tuple(sheets), (*lost_names, *lost), len(lost_parts))


def _finish(sheet: Sheet, given: bool, everything: Sequence[Named]) -> TactileSheet:
    named = tuple(each for each in everything if each.piece in sheet.pieces)
    return TactileSheet(sheet.draw(), given, named)


@dataclass(frozen=True)
class _Filling:
    """The pages of one figure, and what may stand on each of them."""

    page: Box
    number: Callable[[int], str]
    parts: Sequence[Piece]
    letters: Sequence[Named]

    def fill_parts(self, names: Sequence[Named]) -> tuple[list[Sheet], list[Piece], list[Named]]:
        """Sheets of parts with letters and names; then the parts and names without room."""
        sheets: list[Sheet] = []
        waiting, unnamed = list(self.parts), [*self.letters, *names]
        while waiting or unnamed:
            sheet = self._begin(len(sheets) + 1)
            if sheets:
                sheet = self._with_letters(self._with_dots(sheet, unnamed))
            sheet = sheet.with_pieces(waiting)
            if sheets:
                sheet = sheet.with_pieces(self._list_neighbours(sheet.pieces))
            sheet = self._with_letters(sheet)
            sheet = sheet.with_pieces(named.piece for named in names if named in unnamed)
            left = [part for part in waiting if part not in sheet.pieces]
            still = [named for named in unnamed if named.piece not in sheet.pieces]
            if (left, still) == (waiting, unnamed):
                break
            sheets.append(sheet)
            waiting, unnamed = left, still
        return sheets, waiting, unnamed

    def fill_givens(self, givens: list[Named], before: int) -> tuple[list[Sheet], list[Named]]:
        """Sheets of what is given, and what has no room on any."""
        sheets: list[Sheet] = []
        lost: list[Named] = []
        waiting = givens
        while waiting:
            begun = self._begin(before + len(sheets) + 1)
            sheet = self._with_givens(begun.with_pieces(self.parts), waiting)
            if not _holds_any(sheet, waiting):
                sheet = self._with_givens(self._with_dots(begun, waiting[:1]), waiting[:1])
                sheet = self._with_letters(sheet.with_pieces(self.parts))
            if _holds_any(sheet, waiting):
                sheets.append(sheet)
            else:
                lost.append(waiting[0])
            waiting = [
                named for named in waiting if named.piece not in sheet.pieces and named not in lost
            ]
        return sheets, lost

    def _begin(self, place: int) -> Sheet:
        """A page with its number in the corner."""
        cells = self.number(place)
        width, height = measure_label(cells)
        corner = Vector(self.page.left + EDGE_OF_PAGE, self.page.top - EDGE_OF_PAGE)
        middle = corner + Vector(width / 2, -height / 2)
        return Sheet(self.page, labels=((cells, middle),))

    def _with_letters(self, sheet: Sheet) -> Sheet:
        """The sheet with the letters of its dots."""
        shown = [each.piece for each in self.letters if _has_dots(sheet, each.piece)]
        return sheet.with_pieces(shown)

    def _with_dots(self, sheet: Sheet, named: Sequence[Named]) -> Sheet:
        """The sheet with the dots of the points that things need."""
        wanted = [at for each in named for at in each.piece.at]
        dots = [part for part in self.parts if len(part.at) == 1 and part.at[0] in wanted]
        bare = [dot for dot in dots if len(dot.ways) == 1 and len(dot.ways[0].primitives) == 1]
        return sheet.with_pieces(bare)

    def _list_neighbours(self, pieces: Sequence[Piece]) -> list[Piece]:
        """The parts on which points of these lie; all, beside what is at no point."""
        shared = {at for piece in pieces for at in piece.at}
        return [part for part in self.parts if not shared or shared & set(part.at)]

    def _with_givens(self, sheet: Sheet, givens: Sequence[Named]) -> Sheet:
        """The sheet with letters and those of the givens whose points have dots and letters."""
        for piece in (each.piece for each in givens):
            if _has_dots(sheet, piece):
                own = [each.piece for each in self.letters if each.piece.at[0] in piece.at]
                sheet = sheet.with_piece(piece, own)
        return self._with_letters(sheet)


def _holds_any(sheet: Sheet, named: Sequence[Named]) -> bool:
    return any(each.piece in sheet.pieces for each in named)


def _has_dots(sheet: Sheet, piece: Piece) -> bool:
    """Whether a dot is at each of the points of a piece."""
    dots = {line.centre for line in sheet.lines if isinstance(line, Disc) and line.fill == "black"}
    return set(piece.at) <= dots


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
