"""A record of a table, as people see it: a line and its cells."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from operator import itemgetter
from typing import NamedTuple


class Row(NamedTuple):
    """One record; `line` is the physical line, counted from 1, on which it begins."""

    line: int
    cells: tuple[str, ...]

    def cell(self, index: int) -> str:
        """The cell of that column, empty where the line is too short."""
        return self.cells[index] if index < len(self.cells) else ""


def choose_cells(places: Sequence[int | None]) -> Callable[[tuple[str, ...]], tuple[str, ...]]:
    """A function that picks these cells of a row; those that it does not have, and those of no
    place, are blank.

    >>> choose_cells([2, None, 0])(("007", "0.5"))
    ('', '', '007')
    """

    def one_by_one(cells: tuple[str, ...]) -> tuple[str, ...]:
        return tuple(
            [cells[place] if place is not None and place < len(cells) else "" for place in places]
        )

    known = [place for place in places if place is not None]
    if len(known) < len(places) or len(known) < 2:
        return one_by_one
    all_at_once, width = itemgetter(*known), max(known) + 1
    return lambda cells: all_at_once(cells) if len(cells) >= width else one_by_one(cells)
