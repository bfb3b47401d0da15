"""What in a block a person should look at: cells that could not be read or have a wrong unit, or
that were read with a remark, and answers that are right on another paper.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache, partial
from itertools import groupby
from typing import NamedTuple

import numpy as np

from kinegrade.exam.folder.asks import Ask
from kinegrade.files.cell_text import shorten
from kinegrade.files.tables import Complaint
from kinegrade.grading.fast.another_paper import PapersAnswered
from kinegrade.grading.fast.judged_block import JudgedBlock
from kinegrade.grading.verdict_names import name_verdict
from kinegrade.language.message import Message, Quoted, Text, list_all


class Doubt(NamedTuple):
    """A complaint about a cell; `why` is the reason for which the number was read as it was, where
    that alone is remarked on, else "".
    """

    complaint: Complaint
    why: Text = ""


def find_doubts(
    judged: JudgedBlock, asks: Sequence[Ask], columns: Sequence[str]
) -> Iterator[Doubt]:
    """The doubts, cell by cell; `columns` are the headers of the asks' columns."""
    yield from _find_shared(judged, asks, columns)
    for place, reading in judged.cells.readings.items():
        amiss = reading.kind in ("unreadable", "wrong unit")
        if not amiss and not reading.remark:  # as most are; the rest takes its time
            continue
        row, number = divmod(place, len(asks))
        file, line = judged.rows.entries.place(row, number)
        verdict = name_verdict(judged.kind(place))
        complain = partial(Complaint, file, line, columns[number], shorten(reading.typed))
        if amiss:
            points = judged.credits[judged.shares[place]] * asks[number].points
            yield Doubt(complain(reading.reason, _tell_points(verdict, any_points=bool(points))))
        if reading.remark:
            done = Message("marking.judged", verdict=verdict)
            yield Doubt(complain(reading.remark, done), _find_reason(reading.remark))


@cache
def _tell_points(verdict: Text, *, any_points: bool) -> Message:
    """What was done with an answer that could not be read as it should be."""
    if any_points:
        return Message("marking.some-points", verdict=verdict)
    return Message("marking.no-points", verdict=verdict)


def find_rows_of_others(
    judged: JudgedBlock, papers: PapersAnswered, columns: Sequence[str]
) -> Iterator[Complaint]:
    """A complaint for each row whose numbers are all right on the paper of one other student, as
    where a typist slipped by a line; no credit hides it, and it changes none.
    """
    shape = len(judged.rows), len(columns)
    numbers = np.where(judged.are("void"), np.nan, judged.cells.values).reshape(shape)
    wrong = ~judged.are("right").reshape(shape) & ~np.isnan(numbers)
    for row in papers.list_suspect(numbers, wrong):
        paper, entry = judged.rows[row]
        owner = papers.find_owner(paper, numbers[row], wrong[row])
        if owner:
            first = int(np.flatnonzero(wrong[row])[0])
            file, line = entry.place(first)
            typed = judged.cells.typed[row * len(columns) + first]
            student = Quoted(paper.student)
            problem = Message("marking.row-of-another", student=student, other=Quoted(owner))
            done = Message("marking.check-whose", student=student)
            yield Complaint(file, line, columns[first], shorten(typed), problem, done)


def _find_shared(
    judged: JudgedBlock, asks: Sequence[Ask], columns: Sequence[str]
) -> Iterator[Doubt]:
    """One doubt for each student whose answers are right on another paper."""
    places = np.flatnonzero(judged.are("another paper")).tolist()
    for row, group in groupby(places, lambda place: place // len(columns)):
        numbers = [place % len(columns) for place in group]
        file, line = judged.rows.entries.place(row, numbers[0])
        questions = list_all(dict.fromkeys(asks[number].question for number in numbers))
        problem = Message("marking.of-another-paper", questions=questions)
        done = Message("marking.nothing-followed")
        typed = judged.cells.typed[row * len(columns) + numbers[0]]
        yield Doubt(Complaint(file, line, columns[numbers[0]], shorten(typed), problem, done))


def _find_reason(remark: Text) -> Text:
    """Why a number was read as it was, where that alone is remarked on; "" otherwise."""
    reason = remark.parts.get("reason") if isinstance(remark, Message) else None
    return reason if isinstance(reason, str | Message) else ""
