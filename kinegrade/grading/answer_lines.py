"""The marks of a class as lines of marks.csv, block by block while the class is being marked.

Called by `grade`. A response longer than a thousand characters is cut.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import assert_never

import numpy as np

from kinegrade.files.cell_text import shorten
from kinegrade.files.csv_writing import encode, neutralise_cells, write_csv_cell, write_csv_cells
from kinegrade.grading.fast.bounds import Places
from kinegrade.grading.fast.judged_block import KINDS
from kinegrade.grading.fast.line_columns import LineColumns
from kinegrade.grading.marks import MarkedBlock
from kinegrade.grading.reason_columns import add_reasons
from kinegrade.grading.sheets.pool import list_put_rows
from kinegrade.grading.typed.parted_cells import PartedCells
from kinegrade.language.catalogue import Catalogue, open_catalogue
from kinegrade.marks_folder.writing import MarksWriter
from kinegrade.numbers.amounts import write_amount

_TYPED = 2  # the column of what was typed


def write_marks(folder: MarksWriter, blocks: Iterable[MarkedBlock]) -> Iterator[MarkedBlock]:
    """Writes the answers block by block, and passes each block on once it is written.

    Also writes whose lines of the key were used, where they were not the student's own.
    """
    put: list[tuple[str, str, str, str]] = []
    words = open_catalogue(folder.language)
    with folder.answers() as write:
        for block in blocks:
            write(_write_lines(block, words))
            for paper in block.judged.rows.papers.put_together:
                put += list_put_rows(block.asks, paper)
            yield block
            del block  # so that the next takes its place
    folder.put(put)


def _write_lines(block: MarkedBlock, words: Catalogue) -> bytes:
    """A line for each answer, assembled column by column; none for what a paper does not ask.

    Columns that repeat are joined beforehand, and each part ends with its comma or line break.
    """
    rows, asks, cells = block.judged.rows, block.asks, block.judged.cells
    lines = LineColumns(len(cells.typed))
    ids = write_csv_cells(rows.papers.students)
    students = [encode(f"{each},") for each in ids]
    lines.add(students, np.repeat(np.arange(len(rows)), len(asks)))
    named = [encode(_join(ask.question, ask.ask, "")) for ask in asks]
    lines.add(named, np.tile(np.arange(len(asks)), len(rows)))
    _add_cells(lines, cells.typed, _show_responses)
    lines.add([b","], np.zeros(lines.count, dtype=np.intp))
    if cells.are_plain:
        lines.add_again(_TYPED)
    else:
        _add_cells(lines, cells.read_as, write_csv_cells)
    lines.add(*_list_verdicts(block))
    add_reasons(lines, block.judged, words)
    return lines.write(_list_held(block))


def _list_held(block: MarkedBlock) -> Places:
    """The places of what papers ask."""
    held = np.ones((len(block.judged.rows), len(block.asks)), dtype=np.bool_)
    for row, lacks in block.judged.rows.papers.lacking.items():
        held[row, [*lacks]] = False
    return np.flatnonzero(held)


def _join(*cells: str) -> str:
    return ",".join(map(write_csv_cell, cells))


def _show_responses(typed: Sequence[str]) -> Sequence[str]:
    return write_csv_cells(neutralise_cells([*map(shorten, typed)]))


def _list_verdicts(block: MarkedBlock) -> tuple[list[bytes], Places]:
    """Unit, verdict, points and maximum: the few ways in which these stand together, and the number
    of that of each answer.
    """
    judged, shape = block.judged, (len(block.asks), len(block.judged.credits), len(KINDS))
    asks = np.arange(len(judged.kinds)) % len(block.asks)
    ways = np.ravel_multi_index((asks, judged.shares, judged.kinds), shape)
    texts = [b""] * int(np.prod(shape))
    for way in np.flatnonzero(np.bincount(ways)).tolist():
        number, share, kind = map(int, np.unravel_index(way, shape))
        ask = block.asks[number]
        points = write_amount(judged.credits[share] * ask.points), write_amount(ask.points)
        texts[way] = encode(_join("", ask.unit, KINDS[kind], *points, ""))
    return texts, ways


def _add_cells(
    lines: LineColumns, texts: Sequence[str], make_safe: Callable[[Sequence[str]], Sequence[str]]
) -> None:
    """Adds a column of cells made safe for a CSV file; plain numbers, which most cells are, are
    safe as they stand.
    """
    match texts:
        case PartedCells(plain=plain, others=others):
            safe = map(encode, make_safe([*others.values()]))
            lines.add_plain(plain.letters.texts, dict(zip(others, safe, strict=True)))
        case Sequence():
            lines.add([*map(encode, make_safe(texts))])
        case _:
            assert_never(texts)
