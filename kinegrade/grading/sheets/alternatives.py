"""Cells of questions that a student's paper does not hold, where an exam has alternatives: nothing
is marked by them, and what is typed there is complained of.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.papers import Paper
from kinegrade.files.cell_text import is_answered, shorten, trim
from kinegrade.files.tables import Complaint
from kinegrade.grading.sheets.entries import ListedEntries
from kinegrade.grading.sheets.entry import Entry
from kinegrade.grading.sheets.rows import Rows
from kinegrade.language.message import Message, Quoted
from kinegrade.question_numbers import find_bank_number


def leave_out(rows: Rows) -> Rows:
    """The rows without what is typed for questions that their papers do not hold."""
    lacking = rows.papers.lacking
    if not lacking:
        return rows
    entries = [*rows.entries]
    for row, lacks in lacking.items():
        cells = enumerate(entries[row].responses)
        left = tuple(["" if number in lacks else cell for number, cell in cells])
        entries[row] = entries[row]._replace(responses=left)
    return Rows(rows.papers, ListedEntries(entries))


def find_strange(
    paper: Paper, entry: Entry, asks: Sequence[Ask], columns: Sequence[str]
) -> Iterator[Complaint]:
    """A complaint for each cell that is left out; it quotes the cell."""
    for number in sorted(paper.lacks):
        cell = entry.responses[number]
        if is_answered(cell):
            file, line = entry.place(number)
            question = find_bank_number(asks[number].question)
            problem = Message(
                "marking.not-on-paper", question=question, student=Quoted(paper.student)
            )
            done = Message("marking.not-marked-there")
            yield Complaint(file, line, columns[number], shorten(trim(cell)), problem, done)
