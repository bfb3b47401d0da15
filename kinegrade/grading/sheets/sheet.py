"""The answer sheet: whose answer to which ask each cell is.

`part` reads one file; `class_sheet` makes one sheet from several and is called by `grade`. Nothing
in a file is lost: a cell that does not become an answer becomes a complaint that quotes it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from kinegrade.files.cell_text import shorten
from kinegrade.files.csv_writing import write_csv_text
from kinegrade.files.tables import Complaint
from kinegrade.grading.sheets.entry import Entry
from kinegrade.grading.sheets.grid_entries import GridEntries
from kinegrade.language.message import Message


@dataclass(frozen=True)
class Sheet:
    """Each student's entries by id, one or more in the order of the files; `columns` are the
    headers of the asks' columns.

    `complaints` are those made before it is decided which of several entries counts: see
    `find_repeated`.
    """

    columns: tuple[str, ...]
    entries: Mapping[str, tuple[Entry, ...]]
    complaints: tuple[Complaint, ...]

    @property
    def listed(self) -> Mapping[str, tuple[Entry, ...]]:
        """Those that may be more than a row of a grid: several of a student, or put together."""
        return {} if isinstance(self.entries, GridEntries) else self.entries

    @cached_property
    def repeated(self) -> frozenset[str]:
        """The students who have several."""
        return frozenset(student for student, each in self.listed.items() if len(each) > 1)


@dataclass(frozen=True, slots=True)
class Part:
    """The content of one file: entries only of students who have a row, columns "" where an ask has
    none.
    """

    file: str
    columns: tuple[str, ...]
    entries: Mapping[str, tuple[Entry, ...]]
    complaints: tuple[Complaint, ...]


def quote_cells(cells: Sequence[str]) -> str:
    """Cells as a complaint quotes them, each shortened."""
    return write_csv_text([shorten(cell) for cell in cells], []).rstrip("\n")


def find_repeated(entries: Sequence[Entry], counted: Entry) -> Iterator[Complaint]:
    """A complaint for each entry of a student that does not count; it quotes the row."""
    for entry in entries:
        if entry is counted:
            continue
        where = _name_line(entry, counted)
        problem = Message("marking.another-row", row=where)
        done = Message("marking.row-counts", row=where)
        if entry.repeats(counted):
            done = Message("marking.same-answers")
        yield Complaint(entry.file, entry.line, "", _quote(entry), problem, done)


def _quote(entry: Entry) -> str:
    """The row as it came; its responses where it is the student's only one in its file."""
    return entry.whole or quote_cells(entry.responses)


def _name_line(entry: Entry, counted: Entry) -> Message:
    """The line of the row that counts, with its file where it is another one."""
    line = counted.line or 0
    if entry.file == counted.file:
        return Message("marking.line", line=line)
    return Message("marking.line-of", line=line, file=counted.file)
