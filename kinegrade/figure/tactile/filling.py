"""The sheets of a tactile figure, filled one after the other: parts with letters and names first,
then what is given, with as much of the mechanism as there is room for. A point stands on a part
that carries it wherever one has room beside it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from kinegrade.figure.scene import Box, Disc
from kinegrade.figure.tactile.braille import measure_label
from kinegrade.figure.tactile.labels import Named
from kinegrade.figure.tactile.piece import Piece
from kinegrade.figure.tactile.sheet import Sheet
from kinegrade.figure.tactile.sizes import EDGE_OF_PAGE
from kinegrade.mechanics.vector import Vector


@dataclass(frozen=True)
class Filling:
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
                sheet = self._with_points(sheet, unnamed)
            sheet = self._with_parts(sheet, waiting)
            if sheets:
                sheet = self._with_parts(sheet, self._list_neighbours(sheet.pieces))
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
            sheet = self._with_givens(self._with_parts(begun, self.parts), waiting)
            if not _holds_any(sheet, waiting):
                sheet = self._with_given(begun, waiting[0])
            if _holds_any(sheet, waiting):
                sheets.append(sheet)
            else:
                lost.append(waiting[0])
            waiting = [
                named for named in waiting if named.piece not in sheet.pieces and named not in lost
            ]
        return sheets, lost

    def _with_given(self, begun: Sheet, given: Named) -> Sheet:
        """A page with one given, its points, and as much of the mechanism as has room: first what
        carries the points; where the given has no room with that, the points by themselves.
        """
        for carried in (True, False):
            dotted = self._with_dots(begun, given.piece.at, carried)
            sheet = self._with_givens(dotted, [given])
            if _holds_any(sheet, [given]):
                return self._with_letters(self._with_parts(sheet, self.parts))
        return begun

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

    def _with_points(self, sheet: Sheet, unnamed: Sequence[Named]) -> Sheet:
        """The sheet with those of the points without a letter that have room on it, with a part on
        which they lie and the letter; where none has, they stand by themselves.
        """
        begun = sheet
        for named in unnamed:
            grown = self._with_letters(self._with_dots(sheet, named.piece.at, True))
            sheet = grown if named.piece in grown.pieces else sheet
        if sheet.pieces:
            return sheet
        bare = self._with_dots(begun, [at for named in unnamed for at in named.piece.at], False)
        return self._with_letters(bare)

    def _with_dots(self, sheet: Sheet, points: Sequence[Vector], carried: bool) -> Sheet:
        """The sheet with the dots of points, those that parts carry only with one of these."""
        for at in points:
            dot = [part for part in self.parts if _is_dot(part) and part.at[0] == at]
            grown = sheet.with_pieces(dot)
            carrying = [part for part in self.parts if _carries(part, at)] if carried else []
            with_parts = (grown.with_piece(part) for part in carrying if part not in grown.pieces)
            if carrying and not _holds_carrier(grown, at):
                grown = next((each for each in with_parts if _holds_carrier(each, at)), sheet)
            sheet = grown
        return sheet

    def _with_parts(self, sheet: Sheet, parts: Sequence[Piece]) -> Sheet:
        """The sheet with those of the parts that it takes, and dots on what carries them."""
        for part in parts:
            if _is_dot(part) and not _holds_carrier(sheet, part.at[0]):
                carried = any(_carries(each, part.at[0]) for each in self.parts)
                sheet = sheet if carried else sheet.with_pieces([part])
            else:
                sheet = sheet.with_pieces([part])
        return sheet

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


def _is_dot(part: Piece) -> bool:
    """Whether a part is a point's dot alone."""
    return len(part.at) == 1 and len(part.ways) == 1 and len(part.ways[0].primitives) == 1


def _carries(part: Piece, at: Vector) -> bool:
    """Whether a point lies on a part."""
    return at in part.at and not _is_dot(part)


def _holds_carrier(sheet: Sheet, at: Vector) -> bool:
    return any(_carries(part, at) for part in sheet.pieces)


def _has_dots(sheet: Sheet, piece: Piece) -> bool:
    """Whether a dot is at each of the points of a piece."""
    dots = {line.centre for line in sheet.lines if isinstance(line, Disc) and line.fill == "black"}
    return set(piece.at) <= dots
