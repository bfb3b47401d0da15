"""The marks of a class as lines of marks.csv, block by block while the class is being marked.

Called by `grade`. A response longer than a thousand characters is cut.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import lru_cache
from itertools import chain

import numpy as np

from kinegrade.files.cell_text import shorten
from kinegrade.files.csv_writing import neutralise, write_csv_cell
from kinegrade.grading.fast.judged_block import KINDS, JudgedBlock
from kinegrade.grading.fast.typed_cells import TypedCells
from kinegrade.grading.marks import MarkedBlock
from kinegrade.grading.sheets.pool import list_put_rows
from kinegrade.grading.typed.answers import Reading
from kinegrade.language.catalogue import Catalogue, open_catalogue
from kinegrade.language.message import Text
from kinegrade.marks_folder.layout import BY_POLICY, NAMES_BETWEEN
from kinegrade.marks_folder.writing import MarksWriter
from kinegrade.numbers.amounts import write_amount


def write_marks(folder: MarksWriter, blocks: Iterable[MarkedBlock]) -> Iterator[MarkedBlock]:
    """Writes the answers block by block, and passes each block on once it is written.

    Also writes whose lines of the key were used, where they were not the student's own.
    """
    put: list[tuple[str, str, str, str]] = []
    words = open_catalogue(folder.language)
    with folder.answers() as write:
        for block in blocks:
            write(_write_lines(block, words))
            for paper, _ in block.judged.rows:
                if paper.put:
                    put += list_put_rows(block.asks, paper)
            yield block
    folder.put(put)


def _write_lines(block: MarkedBlock, words: Catalogue) -> str:
    """A line for each answer, assembled column by column; none for what a paper does not ask.

    Columns that repeat are joined beforehand, and each part ends with its comma or line break.
    """
    count, cells = len(block.judged.rows), block.judged.cells
    students = ([write_csv_cell(paper.student)] * len(block.asks) for paper, _ in block.judged.rows)
    columns: tuple[Sequence[str], ...] = (
        [*chain.from_iterable(students)],
        [_join("", ask.question, ask.ask, "") for ask in block.asks] * count,
        _with_odd(cells.typed, cells, _show_response),
        [","] * len(cells.typed),
        _with_odd(cells.read_as, cells, lambda reading: reading.read_as),
        _write_verdicts(block),
        _write_reasons(block.judged, words),
        _write_ends(block.judged),
    )
    if any(paper.lacks for paper, _ in block.judged.rows):
        held = _list_held(block)
        columns = tuple([column[place] for place in held] for column in columns)
    parts = [""] * (len(columns) * len(columns[0]))
    for place, column in enumerate(columns):
        parts[place :: len(columns)] = column
    return "".join(parts)


def _list_held(block: MarkedBlock) -> list[int]:
    """The places of what papers ask."""
    asks = range(len(block.asks))
    return [
        row * len(asks) + number
        for row, (paper, _) in enumerate(block.judged.rows)
        for number in asks
        if number not in paper.lacks
    ]


def _join(*cells: str) -> str:
    return ",".join(map(write_csv_cell, cells))


def _show_response(reading: Reading) -> str:
    return neutralise(shorten(reading.typed))


def _write_verdicts(block: MarkedBlock) -> list[str]:
    """Unit, verdict, points and maximum: few ways for each ask, looked up by all three."""
    judged, shape = block.judged, (len(block.asks), len(block.judged.credits), len(KINDS))
    asks = np.arange(len(judged.kinds)) % len(block.asks)
    ways = np.ravel_multi_index((asks, judged.shares, judged.kinds), shape)
    texts = np.full(shape, "", dtype=object).ravel()
    for way in np.flatnonzero(np.bincount(ways)).tolist():
        number, share, kind = map(int, np.unravel_index(way, shape))
        ask = block.asks[number]
        points = write_amount(judged.credits[share] * ask.points), write_amount(ask.points)
        texts[way] = _join("", ask.unit, KINDS[kind], *points, "")
    listed: list[str] = texts[ways].tolist()
    return listed


def _write_reasons(judged: JudgedBlock, words: Catalogue) -> list[str]:
    """Most reasons are comparisons, and are written all at once."""
    column = np.full(len(judged.kinds), "", dtype=object)
    column[judged.compared] = judged.write_compared()
    for place, reason in judged.reasons.items():
        column[place] = _write_reason(reason, words)
    listed: list[str] = column.tolist()
    return listed


def _write_reason(reason: Text, words: Catalogue) -> str:
    """Most are sentences of letters with a comma: they need quotation marks, and nothing else."""
    if isinstance(reason, str) and reason[:1].isalpha() and "," in reason and '"' not in reason:
        return f'"{reason}"'
    return write_csv_cell(neutralise(words.write(reason)))


def _write_ends(judged: JudgedBlock) -> list[str]:
    """Mistakes and rule, and the end of the line."""
    column = [",,\n"] * len(judged.kinds)
    for place in np.flatnonzero(judged.by_policy).tolist():
        column[place] = f",,{BY_POLICY}\n"
    for place, mistakes in judged.mistakes.items():
        rule = BY_POLICY if judged.by_policy[place] else ""
        column[place] = f",{_write_names(mistakes)},{rule}\n"
    return column


@lru_cache(maxsize=1024)
def _write_names(mistakes: tuple[str, ...]) -> str:
    return write_csv_cell(neutralise(NAMES_BETWEEN.join(mistakes)))


def _with_odd(
    texts: Sequence[str], cells: TypedCells, text_of: Callable[[Reading], str]
) -> Sequence[str]:
    """A column of cells made safe for a CSV file; plain numbers, which most cells are, are safe as
    they stand.
    """
    if not cells.readings:
        return texts
    column = list(texts)
    for place, reading in cells.readings.items():
        column[place] = write_csv_cell(text_of(reading))
    return column
