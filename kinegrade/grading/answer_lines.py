"""The marks of a class as lines of marks.csv, block by block while the class is being marked.

Called by `grade`. A response longer than a thousand characters is cut.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import chain

from kinegrade.amounts import amount_text
from kinegrade.csv_writing import csv_cell, neutralised
from kinegrade.grading.answers import Reading
from kinegrade.grading.marks import MarkedBlock
from kinegrade.grading.pool import put_rows
from kinegrade.grading.typed_cells import TypedCells
from kinegrade.marks_folder.layout import AnswerCells
from kinegrade.marks_folder.writing import MarksWriter
from kinegrade.tables import shortened


def write_marks(folder: MarksWriter, blocks: Iterable[MarkedBlock]) -> Iterator[MarkedBlock]:
    """Writes the answers block by block, and passes each block on once it is written.

    Also writes whose lines of the key were used, where they were not the student's own.
    """
    put: list[tuple[str, str, str, str]] = []
    with folder.answers() as write:
        for block in blocks:
            write(_answer_cells(block))
            for paper, _ in block.judged.rows:
                put += put_rows(block.asks, paper)
            yield block
    folder.put(put)


def _answer_cells(block: MarkedBlock) -> AnswerCells:
    """A line for each answer, assembled column by column."""
    judged, asks, count = block.judged, block.asks, len(block.judged.rows)
    points = [[amount_text(share * ask.points) for share in judged.credits] for ask in asks]
    students = ([csv_cell(paper.student)] * len(asks) for paper, _ in judged.rows)
    cells = judged.cells
    return AnswerCells(
        student=[*chain.from_iterable(students)],
        question=[csv_cell(ask.question) for ask in asks] * count,
        ask=[csv_cell(ask.ask) for ask in asks] * count,
        response=_with_odd(cells.typed, cells, _shown_response),
        read_as=_with_odd(cells.read_as, cells, lambda reading: reading.read_as),
        unit=[csv_cell(ask.unit) for ask in asks] * count,
        verdict=judged.kinds,
        points=[texts[share] for texts, share in zip(points * count, judged.shares, strict=True)],
        out_of=[amount_text(ask.points) for ask in asks] * count,
        reason=[_reason_cell(reason) for reason in judged.reasons],
    )


def _shown_response(reading: Reading) -> str:
    return neutralised(shortened(reading.typed))


def _reason_cell(reason: str) -> str:
    """Most reasons are comparisons with the key, which are quickly recognised as harmless."""
    if reason[:4] == "key " and '"' not in reason:
        return f'"{reason}"'
    return csv_cell(neutralised(reason))


def _with_odd(
    texts: Sequence[str], cells: TypedCells, text_of: Callable[[Reading], str]
) -> list[str]:
    """A column of cells made safe for a CSV file; plain numbers, which most cells are, are safe as
    they stand.
    """
    column = list(texts)
    for place, reading in cells.readings.items():
        column[place] = csv_cell(text_of(reading))
    return column
