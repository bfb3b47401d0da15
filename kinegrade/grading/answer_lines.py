"""The marks of a class as lines of marks.csv, block by block while the class is being marked.

Called by `grade`. A response longer than a thousand characters is cut.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import chain

from kinegrade.files.cell_text import shorten
from kinegrade.files.csv_writing import neutralise, write_csv_cell
from kinegrade.grading.fast.judged_block import JudgedBlock
from kinegrade.grading.fast.typed_cells import TypedCells
from kinegrade.grading.marks import MarkedBlock
from kinegrade.grading.sheets.pool import list_put_rows
from kinegrade.grading.typed.answers import Reading
from kinegrade.language.catalogue import Catalogue, open_catalogue
from kinegrade.language.message import Text
from kinegrade.marks_folder.layout import BY_POLICY, NAMES_BETWEEN, AnswerCells
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
            write(_write_answer_cells(block, words))
            for paper, _ in block.judged.rows:
                put += list_put_rows(block.asks, paper)
            yield block
    folder.put(put)


def _write_answer_cells(block: MarkedBlock, words: Catalogue) -> AnswerCells:
    """A line for each answer, assembled column by column; none for what a paper does not ask."""
    cells = _write_all_cells(block, words)
    width = len(block.asks)
    lacking = {
        row * width + number
        for row, (paper, _) in enumerate(block.judged.rows)
        for number in paper.lacks
    }
    if not lacking:
        return cells
    held = [place for place in range(len(block.judged.kinds)) if place not in lacking]
    return AnswerCells(*([column[place] for place in held] for column in cells))


def _write_all_cells(block: MarkedBlock, words: Catalogue) -> AnswerCells:
    judged, asks, count = block.judged, block.asks, len(block.judged.rows)
    points = [[write_amount(share * ask.points) for share in judged.credits] for ask in asks]
    students = ([write_csv_cell(paper.student)] * len(asks) for paper, _ in judged.rows)
    cells = judged.cells
    return AnswerCells(
        student=[*chain.from_iterable(students)],
        question=[write_csv_cell(ask.question) for ask in asks] * count,
        ask=[write_csv_cell(ask.ask) for ask in asks] * count,
        response=_with_odd(cells.typed, cells, _show_response),
        read_as=_with_odd(cells.read_as, cells, lambda reading: reading.read_as),
        unit=[write_csv_cell(ask.unit) for ask in asks] * count,
        verdict=judged.kinds,
        points=[texts[share] for texts, share in zip(points * count, judged.shares, strict=True)],
        out_of=[write_amount(ask.points) for ask in asks] * count,
        reason=_write_reasons(judged.reasons, words),
        mistakes=_list_mistakes(judged),
        rule=[BY_POLICY if place in judged.by_policy else "" for place in range(len(judged.kinds))],
    )


def _show_response(reading: Reading) -> str:
    return neutralise(shorten(reading.typed))


def _write_reasons(reasons: Sequence[Text], words: Catalogue) -> list[str]:
    """Most reasons are comparisons, in words with a comma: they need quotation marks, and nothing
    else.
    """
    return [
        f'"{reason}"'
        if isinstance(reason, str) and reason[:1].isalpha() and "," in reason and '"' not in reason
        else write_csv_cell(neutralise(words.write(reason)))
        for reason in reasons
    ]


def _list_mistakes(judged: JudgedBlock) -> list[str]:
    column = [""] * len(judged.kinds)
    for place, mistakes in judged.mistakes.items():
        column[place] = write_csv_cell(neutralise(NAMES_BETWEEN.join(mistakes)))
    return column


def _with_odd(
    texts: Sequence[str], cells: TypedCells, text_of: Callable[[Reading], str]
) -> list[str]:
    """A column of cells made safe for a CSV file; plain numbers, which most cells are, are safe as
    they stand.
    """
    column = list(texts)
    for place, reading in cells.readings.items():
        column[place] = write_csv_cell(text_of(reading))
    return column
