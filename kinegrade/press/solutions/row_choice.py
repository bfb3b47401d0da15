"""Which drawings of a worked solution stand side by side, and how much text beside them: what takes
least of the page.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import lru_cache
from itertools import pairwise

from kinegrade.press.solutions.chains import Chain
from kinegrade.press.solutions.drawing_rows import GAP, Drawing, DrawingRow
from kinegrade.press.solutions.settings import Column, add_heights, fits

_NARROWEST = 72.0  # millimetres that text beside drawings has at least
_WORTH_IT = 0.75  # of the height below, which blocks beside a drawing may add at most


def measure_passage(drawings: tuple[Drawing, ...], chains: Sequence[Chain], page: Column) -> float:
    """How high drawings are with the chains beside and below them."""
    height, taken = 0.0, 0
    while drawings:
        row, beside = choose_row(drawings, chains[taken:], page)
        height += row.height
        drawings = drawings[len(row.drawings) :]
        taken += beside
    return height + sum(add_heights(page.set_chain(chain)) for chain in chains[taken:])


def choose_row(
    drawings: tuple[Drawing, ...], chains: Sequence[Chain], page: Column
) -> tuple[DrawingRow, int]:
    """The first row of drawings one by one or side by side, whichever takes least of the page, and
    how many of the chains stand beside it. Where none would, captions are narrow, then equations
    are folded.
    """
    return _choose_row(drawings, tuple(chains), page)


@lru_cache(
    maxsize=512
)  # it is asked whether a table saves room beside drawings, then how they stand
def _choose_row(
    drawings: tuple[Drawing, ...], chains: tuple[Chain, ...], page: Column
) -> tuple[DrawingRow, int]:
    narrow = tuple(replace(drawing, narrow=True) for drawing in drawings)
    for shown, folds in ((drawings, False), (narrow, False), (narrow, True)):
        row, taken = _choose_lowest(shown, chains, page, folds=folds)
        if taken:
            return row, taken
    return _choose_lowest(drawings, chains, page, folds=False)


def _choose_lowest(
    drawings: tuple[Drawing, ...], chains: Sequence[Chain], page: Column, *, folds: bool
) -> tuple[DrawingRow, int]:
    choices = [_fill(rows, chains, page, folds=folds) for rows in _list_rows(drawings, page)]
    most = max(sum(taken for _, taken in choice) for choice in choices)

    def find_height(choice: Sequence[tuple[DrawingRow, int]]) -> float:
        taken = sum(taken for _, taken in choice)
        rest = (page.set_chain(chain) for chain in chains[taken:most])
        return sum(row.height for row, _ in choice) + sum(map(add_heights, rest))

    return min(choices, key=find_height)[0]


def _list_rows(
    drawings: tuple[Drawing, ...], page: Column
) -> Iterator[tuple[tuple[Drawing, ...], ...]]:
    """The ways of setting drawings in rows that are not too wide."""
    count = len(drawings)
    for cuts in range(2 ** (count - 1)):
        ends = [0, *(place for place in range(1, count) if cuts >> (place - 1) & 1), count]
        rows = tuple(drawings[begin:end] for begin, end in pairwise(ends))
        if len(rows) == count or all(DrawingRow(row, ()).width <= page.width for row in rows):
            yield rows


def _fill(
    rows: Sequence[tuple[Drawing, ...]], chains: Sequence[Chain], page: Column, *, folds: bool
) -> list[tuple[DrawingRow, int]]:
    """Each row with the next chains beside it, and how many they are."""
    filled: list[tuple[DrawingRow, int]] = []
    for drawings in rows:
        taken = sum(taken for _, taken in filled)
        row = DrawingRow(drawings, (), page.spread)
        filled.append(_fill_row(row, chains[taken:], page, folds=folds))
    return filled


def _fill_row(
    row: DrawingRow, chains: Sequence[Chain], page: Column, *, folds: bool
) -> tuple[DrawingRow, int]:
    """A row with chains beside it, as long as that takes less of the page than to set them below,
    and how many they are.
    """
    column = replace(page, width=page.width - row.width - GAP, folds=folds)
    chains = chains if column.width >= _NARROWEST else ()
    for taken, chain in enumerate(chains):
        if not column.has_width_for(chain):
            return row, taken
        settings = column.set_chain(chain)
        longer = replace(row, beside=(*row.beside, *settings))
        below = add_heights(page.set_chain(chain))
        if not all(map(fits, settings)) or longer.height - row.height > _WORTH_IT * below:
            return row, taken
        row = longer
    return row, len(chains)
