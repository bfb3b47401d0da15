"""The answers of a class, typed twice: where two files differ, cell by cell.

Behind `kinegrade compare-entries`. What stands in one file alone differs, too; what is equal as a
typed value does not.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from kinegrade.exam.folder.keys import Ask
from kinegrade.files.cell_text import is_answered, shorten, trim
from kinegrade.files.csv_writing import encode_for_people, write_csv_text
from kinegrade.files.tables import Complaint
from kinegrade.grading.sheets.sheet import Entry, Part
from kinegrade.grading.typed.decimal_style import FileStyle, find_file_style
from kinegrade.grading.typed.same_answer import are_same
from kinegrade.language.catalogue import Catalogue
from kinegrade.language.lines import show_in_one_line
from kinegrade.language.message import Listing, Message, list_statements
from kinegrade.language.terminal_lines import align

_WHOLE = "*"  # in place of an ask: the student has no row
_NO_ROW = "–"


@dataclass(frozen=True, slots=True)
class EntryDifference:
    """A cell that differs: `first` and `second` are what was typed, and the lines on which it
    stands; None where the student has no row. `ask` is its column, "" for a whole row.
    """

    student: str
    ask: str
    first: str
    second: str
    first_line: int | None
    second_line: int | None


@dataclass(frozen=True)
class DoubleEntry:
    """Two files compared: what differs, how many cells are filled and agree, and the agreed
    answers, by student, in the order of `columns`.
    """

    files: tuple[str, str]
    columns: tuple[str, ...]
    differences: tuple[EntryDifference, ...]
    agreed: int
    answers: Mapping[str, tuple[str, ...]]
    complaints: tuple[Complaint, ...]


def compare_parts(
    first: Part, second: Part, asks: Sequence[Ask], students: Sequence[str]
) -> DoubleEntry:
    """Two files of the same exam, as far as its students have a row in either."""
    styles = _find_style(first), _find_style(second)
    comparer = _Comparer(first, second, asks, styles)
    differences: list[EntryDifference] = []
    answers: dict[str, tuple[str, ...]] = {}
    agreed = 0
    for student in students:
        one, other = first.entries.get(student, ()), second.entries.get(student, ())
        if not one and not other:
            continue
        differences += comparer.find(student, one, other)
        if one and other:
            cells = one[-1].responses
            answers[student] = cells
            agreed += sum(map(is_answered, cells))
    differing = {(each.student, each.ask) for each in differences if each.ask}
    agreed -= sum(is_answered(answers[who][comparer.place(ask)]) for who, ask in differing)
    return DoubleEntry(
        (first.file, second.file),
        tuple(ask.column for ask in asks),
        tuple(differences),
        agreed,
        answers,
        (*first.complaints, *second.complaints),
    )


@dataclass(frozen=True, slots=True)
class _Comparer:
    first: Part
    second: Part
    asks: Sequence[Ask]
    styles: tuple[FileStyle, FileStyle]

    def place(self, column: str) -> int:
        """The place of an ask among all."""
        return [ask.column for ask in self.asks].index(column)

    def find(
        self, student: str, one: Sequence[Entry], other: Sequence[Entry]
    ) -> Iterator[EntryDifference]:
        """What differs for a student; rows that stand twice are compared among themselves, too."""
        if not one or not other:
            lines = [entries[-1].line if entries else None for entries in (one, other)]
            yield EntryDifference(student, "", "", "", *lines)
            return
        last, (left, right) = (one[-1], other[-1]), self.styles
        pairs = [(entry, last[0], left, left) for entry in one[:-1]]
        pairs += [(entry, last[1], right, right) for entry in other[:-1]]
        for pair in [*pairs, (*last, left, right)]:
            yield from self._compare(student, *pair)

    def _compare(
        self, student: str, one: Entry, other: Entry, left: FileStyle, right: FileStyle
    ) -> Iterator[EntryDifference]:
        styles = left.of_row(one.responses), right.of_row(other.responses)
        for number, ask in enumerate(self.asks):
            cells = one.responses[number], other.responses[number]
            if not are_same(*cells, ask.unit, styles):
                lines = one.place(number).line, other.place(number).line
                yield EntryDifference(student, ask.column, *cells, *lines)


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
            *_show(each.first, each.first_line),
            *_show(each.second, each.second_line),
        )
        for each in compared.differences
    ]
    table = align(header, rows, numbers=(3, 5)) if rows else ""
    return f"{table}{words.write(_summarise(compared))}"


def encode_agreed(compared: DoubleEntry) -> bytes:
    """The answers on which both files agree, as one answer sheet."""
    rows = ((student, *cells) for student, cells in compared.answers.items())
    return encode_for_people(write_csv_text(("student", *compared.columns), rows))


def _show(cell: str, line: int | None) -> tuple[str, str]:
    """A cell and its line, as they are shown."""
    if line is None:
        return _NO_ROW, ""
    return show_in_one_line(shorten(trim(cell))), str(line)


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
