"""A tactile sheet that is being filled: a piece is taken in the first way that keeps clear."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

from kinegrade.figure.scene import Bow, Box, Disc, Primitive, Scene, find_box, move
from kinegrade.figure.tactile.braille import draw_label, find_label_box
from kinegrade.figure.tactile.clearance import list_box_rows, list_rows, measure_gap
from kinegrade.figure.tactile.piece import Piece
from kinegrade.figure.tactile.sizes import CLEAR, EDGE_OF_PAGE
from kinegrade.mechanics.vector import Vector

_WORD = 8.0  # millimetres between two labels that are not read as one


@dataclass(frozen=True)
class Sheet:
    """What is on a page so far: the pieces, their lines, among these those of `marks`, and their
    labels, each with its cells and its middle.
    """

    page: Box
    pieces: tuple[Piece, ...] = ()
    lines: tuple[Primitive, ...] = ()
    marks: tuple[Primitive, ...] = ()
    labels: tuple[tuple[str, Vector], ...] = ()

    def with_pieces(self, pieces: Iterable[Piece]) -> Sheet:
        """The sheet with those of the pieces that it takes, in order, each once."""
        sheet = self
        for piece in pieces:
            if piece not in sheet.pieces:
                sheet = sheet.with_piece(piece)
        return sheet

    def with_piece(self, piece: Piece, letters: Sequence[Piece] = ()) -> Sheet:
        """The sheet with a piece and letters of its points, in the first way in which all of them
        keep clear, or as it is; letters come before labels, which have more places.
        """
        for way in piece.ways:
            new = tuple(each for each in way.primitives if each not in self.lines)
            drawn = self._with_lines(new, piece.is_mark)
            lettered = drawn and drawn.with_pieces(letters)
            if lettered and set(letters) <= set(lettered.pieces):
                for place in way.places:
                    grown = lettered._with_labels(zip(piece.cells, place, strict=True))
                    if grown:
                        return replace(grown, pieces=(*grown.pieces, piece))
        return self

    def draw(self) -> Scene:
        """The page as a drawing."""
        dots = [dot for cells, middle in self.labels for dot in draw_label(cells, middle)]
        home = Vector(-self.page.left, -self.page.bottom)
        drawn = tuple(move(primitive, home) for primitive in (*self.lines, *dots))
        return Scene(self.page.width, self.page.height, 1.0, drawn)

    def _with_lines(self, lines: Sequence[Primitive], is_mark: bool) -> Sheet | None:
        """The sheet with more lines; None where one neither meets what is there nor keeps clear."""
        sheet = self
        for line in lines:
            meets = is_mark and (
                any(_measure(line, mark) < CLEAR for mark in self.marks)
                or any(_lies_along(line, other) for other in self.lines)
            )
            if meets or not (self._holds(_find_box(line)) and sheet._keeps_clear(line)):
                return None
            sheet = replace(sheet, lines=(*sheet.lines, line))
        return replace(sheet, marks=(*self.marks, *lines)) if is_mark else sheet

    def _with_labels(self, labels: Iterable[tuple[str, Vector]]) -> Sheet | None:
        """The sheet with more labels; None where one is too close to anything."""
        sheet = self
        for cells, middle in labels:
            if not sheet._has_room(find_label_box(cells, middle)):
                return None
            sheet = replace(sheet, labels=(*sheet.labels, (cells, middle)))
        return sheet

    def _holds(self, box: Box) -> bool:
        page = self.page
        return (
            box.left >= page.left + EDGE_OF_PAGE
            and box.right <= page.right - EDGE_OF_PAGE
            and box.bottom >= page.bottom + EDGE_OF_PAGE
            and box.top <= page.top - EDGE_OF_PAGE
        )

    def _keeps_clear(self, line: Primitive) -> bool:
        rows, box = list_rows(line), _find_box(line)
        if any(0 < _measure(line, each) < CLEAR for each in self.lines):
            return False
        boxes = (find_label_box(*label) for label in self.labels)
        near_labels = (each for each in boxes if _are_near(box, each, CLEAR))
        return all(measure_gap(rows, list_box_rows(each)) >= CLEAR for each in near_labels)

    def _has_room(self, box: Box) -> bool:
        rows = list_box_rows(box)
        near = (line for line in self.lines if _are_near(box, _find_box(line), CLEAR))
        others = (find_label_box(*label) for label in self.labels)
        return (
            self._holds(box)
            and not any(_are_near(box, each, _WORD) for each in others)
            and all(measure_gap(rows, list_rows(line)) >= CLEAR for line in near)
        )


_find_box = lru_cache(maxsize=4096)(find_box)


def _measure(one: Primitive, other: Primitive) -> float:
    """How far apart two lines are; CLEAR where they are at least that far apart."""
    if not _are_near(_find_box(one), _find_box(other), CLEAR):
        return CLEAR
    return measure_gap(list_rows(one), list_rows(other))


def _lies_along(one: Primitive, other: Primitive) -> bool:
    """Whether an arc runs along a circle or another arc about its centre."""
    if not (isinstance(one, Bow) and isinstance(other, Bow | Disc)):
        return False
    apart = one.centre - other.centre
    return apart.squared() < CLEAR**2 and abs(one.radius - other.radius) < 2 * CLEAR


def _are_near(one: Box, other: Box, least: float) -> bool:
    """Whether two boxes are less than that apart, across and upward."""
    return (
        one.left - other.right < least
        and other.left - one.right < least
        and one.bottom - other.top < least
        and other.bottom - one.top < least
    )
