"""The answers of a class, typed twice: where two files differ, cell by cell.

Behind `kinegrade compare-entries`. What stands in one file alone differs, too; what is equal as a
typed value does not.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from kinegrade.deadlines.moment import parse_moment
from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.sitting import Sitting
from kinegrade.files.cell_text import is_answered, shorten, trim
from kinegrade.files.csv_writing import encode_for_people, write_csv_text
from kinegrade.files.tables import Complaint
from kinegrade.grading.sheets.entry import Entry
from kinegrade.grading.sheets.sheet import Part
from kinegrade.grading.typed.decimal_style import FileStyle, find_file_style
from kinegrade.grading.typed.same_answer import are_same
from kinegrade.language.catalogue import Catalogue
from kinegrade.language.lines import show_in_one_line
from kinegrade.language.message import Listing, Message, list_statements
from kinegrade.language.terminal_lines import align

_WHOLE = "*"  # in place of an ask: the student has no row
_NO_ROW = "–"
_SUBMITTED = "submitted"  # the column of times
_BESIDE = " | "  # between the cells of a student's several rows


@dataclass(frozen=True, slots=True)
class TypedCell:
    """What was typed, and the line on which it stands, None where none is known."""

    text: str
    line: int | None


@dataclass(frozen=True, slots=True)
class EntryDifference:
    """An answer that differs: `first` and `second` are the cells of each file, one for each of the
    student's rows there; none where the student has no row. `ask` is its column, "" for a whole
    row.
    """

    student: str
    ask: str
    first: tuple[TypedCell, ...]
    second: tuple[TypedCell, ...]


@dataclass(frozen=True)
class DoubleEntry:
    """Two files compared: what differs, how many cells are filled and agree, and the agreed
    answers, by student, in the order of `columns`. `submitted` says by student when they were
    handed in, as far as the files do.
    """

    files: tuple[str, str]
    columns: tuple[str, ...]
    differences: tuple[EntryDifference, ...]
    agreed: int
    answers: Mapping[str, tuple[str, ...]]
    submitted: Mapping[str, str]
    complaints: tuple[Complaint, ...]


def compare_parts(
    first: Part, second: Part, sitting: Sitting, titles: Sequence[str]
) -> DoubleEntry:
    """Two files of the same exam, as far as its students have a row in either; `titles` are the
    headers of the agreed answers.
    """
    asks = sitting.asks
    styles = _find_style(first), _find_style(second)
    timed = all(map(_has_times, (first, second)))
    comparer = _Comparer(asks, styles, timed=timed)
    differences: list[EntryDifference] = []
    answers: dict[str, tuple[str, ...]] = {}
    agreed = 0
    submitted: dict[str, str] = {}
    for student in sitting.students:
        one, other = first.entries.get(student, ()), second.entries.get(student, ())
        if not one and not other:
            continue
        found = list(comparer.find(student, one, other))
        differences += found
        times = [each.submitted for each in (*one, *other) if trim(each.submitted)]
        if one and other:
            submitted |= dict.fromkeys([student], times[0]) if times else {}
            cells = answers[student] = one[-1].responses
            differing = {each.ask for each in found}
            agreed += sum(
                is_answered(cell) and ask.column not in differing
                for cell, ask in zip(cells, asks, strict=True)
            )
    return DoubleEntry(
        (first.file, second.file),
        tuple(titles),
        tuple(differences),
        agreed,
        answers,
        submitted,
        (*first.complaints, *second.complaints),
    )


@dataclass(frozen=True, slots=True)
class _Comparer:
    asks: Sequence[Ask]
    styles: tuple[FileStyle, FileStyle]
    timed: bool  # where one file alone has times, nothing contradicts them

    def find(
        self, student: str, one: Sequence[Entry], other: Sequence[Entry]
    ) -> Iterator[EntryDifference]:
        """What differs for a student: between the files, or between several rows in one."""
        if not one or not other:
            cells = (tuple(TypedCell("", each.line) for each in rows) for rows in (one, other))
            yield EntryDifference(student, "", *cells)
            return
        (left, right), last = self.styles, one[-1]
        rows = [*((each, left) for each in one), *((each, right) for each in other)]
        for number, ask in enumerate(self.asks):
            if not all(self._agree(number, (last, left), row) for row in rows):
                typed = (tuple(_find_cell(each, number) for each in rows) for rows in (one, other))
                yield EntryDifference(student, ask.column, *typed)
        if self.timed and not all(_are_same_times(last, each) for each, _ in rows):
            times = (
                tuple(TypedCell(each.submitted, each.line) for each in several)
                for several in (one, other)
            )
            yield EntryDifference(student, _SUBMITTED, *times)

    def _agree(
        self, number: int, one: tuple[Entry, FileStyle], other: tuple[Entry, FileStyle]
    ) -> bool:
        """Whether an answer is the same in two rows, each read as its file writes numbers."""
        cells = [row.responses[number] for row, _ in (one, other)]
        styles = [style.of_row(row.responses) for row, style in (one, other)]
        return are_same(cells[0], cells[1], self.asks[number].unit, (styles[0], styles[1]))


def _has_times(part: Part) -> bool:
    return any(trim(each.submitted) for entries in part.entries.values() for each in entries)


def _are_same_times(one: Entry, other: Entry) -> bool:
    """Whether two rows were handed in at one time, however that is written."""
    times = trim(one.submitted), trim(other.submitted)
    moments = [parse_moment(each) for each in times]
    return times[0] == times[1] or moments[0] == moments[1] is not None


def _find_cell(entry: Entry, number: int) -> TypedCell:
    return TypedCell(entry.responses[number], entry.place(number).line)


def _find_style(part: Part) -> FileStyle:
    return find_file_style(entries[-1].responses for entries in part.entries.values())


def write_double_entry_text(compared: DoubleEntry, words: Catalogue) -> str:
    """An aligned table of what differs, and a summary line."""
    line = words.text("marking.line-heading")
    header = ("student", "ask", compared.files[0], line, compared.files[1], line)
    rows = [
        (
            show_in_one_line(each.student),
            each.ask or _WHOLE,
            *_show(each.first),
            *_show(each.second),
        )
        for each in compared.differences
    ]
    table = align(header, rows, numbers=(3, 5)) if rows else ""
    return f"{table}{words.write(_summarise(compared))}"


def encode_agreed(compared: DoubleEntry) -> bytes:
    """The answers on which both files agree, as one answer sheet."""
    times = compared.submitted
    header = ("student", *compared.columns, *((_SUBMITTED,) if times else ()))
    rows = (
        (student, *cells, *((times.get(student, ""),) if times else ()))
        for student, cells in compared.answers.items()
    )
    return encode_for_people(write_csv_text(header, rows))


def _show(cells: Sequence[TypedCell]) -> tuple[str, str]:
    """The cells of a file and their lines, as they are shown."""
    if not cells:
        return _NO_ROW, ""
    texts = _BESIDE.join(show_in_one_line(shorten(trim(each.text))) for each in cells)
    return texts, _BESIDE.join(str(each.line) for each in cells)


def _summarise(compared: DoubleEntry) -> Listing:
    cells = sum(bool(each.ask) for each in compared.differences)
    alone = len(compared.differences) - cells
    lone = [Message("marking.in-one-file", count=alone)] if alone else []
    return list_statements(
        [
            Message("marking.cells-differ", count=cells),
            *lone,
            Message("marking.cells-agree", count=compared.agreed),
        ]
    )
