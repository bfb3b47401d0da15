"""Columns of a file of answers that answer nothing: what stands in them, and what they may be."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from kinegrade.exam.folder.sitting import Sitting
from kinegrade.files.cell_text import make_header_key, shorten, trim
from kinegrade.files.tables import Complaint, Table
from kinegrade.grading.sheets.columns import Columns, strip_unit
from kinegrade.grading.sheets.strange_headers import find_meant, find_numbered
from kinegrade.language.message import Message, Quoted


class _Advice(NamedTuple):
    """The ask that a column may be, "" where it is none, and what is said."""

    column: str
    message: Message


def find_extra_columns(table: Table, columns: Columns, exam: Sitting) -> Iterator[Complaint]:
    """One for each, with all that stands in it."""
    asks = [ask.column for ask in exam.asks]
    missing = [ask for ask, index in zip(asks, columns.asks, strict=True) if index is None]
    left = list(missing)  # no two columns are said to be the same ask
    for index in columns.extra:
        title = table.header[index]
        cells = ((row.line, row.cell(index)) for row in table.rows)
        filled = [f"{line}: {shorten(cell)}" for line, cell in cells if trim(cell)]
        if not filled and not trim(title):
            continue
        done = _advise(strip_unit(title), asks, left or missing) if filled else None
        yield Complaint(
            table.file,
            None,
            shorten(title),
            "; ".join(filled),
            Message("marking.no-answer-column-here"),
            done.message if done else Message("marking.ignored"),
        )
        if done and done.column in left:
            left.remove(done.column)


def _advise(title: str, asks: Sequence[str], missing: Sequence[str]) -> _Advice:
    """What to do about a filled column that answers nothing; `missing` are asks without one."""
    numbered = find_numbered(title, asks)
    if numbered is not None and numbered in missing:
        return _Advice(numbered, Message("marking.number-alone", column=Quoted(numbered)))
    alike = [
        each
        for each in missing
        if make_header_key(each.partition(".")[2]) == make_header_key(title)
    ]
    for near in alike or find_meant(title, missing):
        return _Advice(near, Message("marking.head-it", column=Quoted(near)))
    return _Advice("", Message("marking.column-kept"))
