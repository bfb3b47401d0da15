"""One file of answers: its columns are found, its rows given to their students, and whatever is
neither becomes a complaint.

`read_part` is called by `class_sheet`.
"""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from operator import itemgetter
from unicodedata import normalize

from kinegrade.errors import TableError
from kinegrade.exam.folder.keys import Ask, Sitting
from kinegrade.exam.roster.known_columns import list_column_names, list_key_columns
from kinegrade.exam.roster.student_ids import StudentIds, describe_restoration
from kinegrade.exam.roster.students import make_student_key
from kinegrade.files.answer_file import AnswerFile, Sources
from kinegrade.files.cell_text import make_header_key, shorten, trim
from kinegrade.files.csv_writing import write_csv_text
from kinegrade.files.tables import Complaint, Row, Table, drop_headers
from kinegrade.grading.sheets.sheet import Entry, Part
from kinegrade.language.message import (
    Fault,
    Message,
    Quoted,
    Text,
    list_choices,
    list_plainly,
)

_NO_STUDENT_COLUMN = Message("marking.no-student-column")


_ANSWER_COLUMN = re.compile(r"q[0-9]+\.\w+")  # as generate writes the headers of the answer sheet


@dataclass(frozen=True, slots=True)
class _Columns:
    student: int
    asks: tuple[int | None, ...]
    extra: tuple[int, ...]

    def responses(self) -> Callable[[tuple[str, ...]], tuple[str, ...]]:
        """A function that picks the responses from the cells of a row; missing ones are blank."""

        def one_by_one(cells: tuple[str, ...]) -> tuple[str, ...]:
            return tuple(
                [
                    cells[index] if index is not None and index < len(cells) else ""
                    for index in self.asks
                ]
            )

        places = [index for index in self.asks if index is not None]
        if len(places) < len(self.asks) or len(places) == 1:
            return one_by_one
        all_at_once, width = itemgetter(*places), max(places) + 1
        return lambda cells: all_at_once(cells) if len(cells) >= width else one_by_one(cells)

    def sources(self, answers: AnswerFile) -> Mapping[int, Sources]:
        """By line, the student whose line of the key each ask is marked by, in the order of the
        asks.
        """
        return {
            line: tuple(["" if index is None else sources[index - 1] for index in self.asks])
            for line, sources in answers.put.items()
        }


def read_part(answers: AnswerFile, exam: Sitting) -> Part:
    """Finds the responses in one file.

    Raises TableError if there is no student column or no answer column, or if the sheet belongs to
    another exam.
    """
    table = answers.table
    columns = _find_columns(table, exam.asks)
    rows, complaints = _group_rows(table, columns, exam)
    responses, put = columns.responses(), columns.sources(answers)
    entries = {
        student: _make_entries(rows[student], table.file, responses, put) for student in rows
    }
    names = ("" if index is None else table.header[index] for index in columns.asks)
    said = (*table.complaints, *_find_extra_columns(table, columns), *complaints)
    return Part(table.file, tuple(names), entries, said)


def _find_columns(table: Table, asks: Sequence[Ask]) -> _Columns:
    header = [make_header_key(cell) for cell in table.header]
    named = (header.index(name) for name in list_key_columns() if name in header)
    student = next(named, None)
    found = _find_ask_columns(table.header, asks)
    faults = []
    if student is None:
        faults.append(_explain(table, _NO_STUDENT_COLUMN, Message("marking.column-of-ids")))
    if all(index is None for index in found):
        first = list_plainly(ask.column for ask in asks[:4])
        expected = Message("marking.answer-columns", columns=first)
        faults.append(_explain(table, Message("marking.no-answer-column"), expected))
    strange = [
        cell for cell in header if _ANSWER_COLUMN.fullmatch(cell) and cell not in _list_keys(asks)
    ]
    if not faults and len(strange) > sum(index is not None for index in found):
        first = list_plainly(strange[:4])
        faults.append(_explain(table, Message("marking.another-exam", columns=first)))
    if student is None or faults:
        raise TableError(*faults)
    needless = {*list_column_names("name"), *list_column_names("email"), *list_key_columns()}
    unused = (index for index in range(len(header)) if index not in {student, *found})
    return _Columns(
        student, found, tuple(index for index in unused if header[index] not in needless)
    )


def _explain(table: Table, problem: Message, expected: Text = "") -> Fault:
    return Fault(table.file, problem, expected, Message("marking.fill-in"))


def _list_keys(asks: Sequence[Ask]) -> set[str]:
    return {make_header_key(ask.column) for ask in asks}


def _find_ask_columns(header: Sequence[str], asks: Sequence[Ask]) -> tuple[int | None, ...]:
    """Exact spelling comes first, because v_A and v_a may both be asked; otherwise case does not
    matter.
    """
    backwards = list(enumerate(header))[::-1]  # so that of two equal columns the first is kept
    exact = {_make_exact_key(cell): index for index, cell in backwards}
    folded = {make_header_key(cell): index for index, cell in backwards}
    alike = Counter(make_header_key(ask.column) for ask in asks)

    def find(column: str) -> int | None:
        key = make_header_key(column)
        return exact.get(_make_exact_key(column), folded.get(key) if alike[key] == 1 else None)

    return tuple(find(ask.column) for ask in asks)


def _make_exact_key(column: str) -> str:
    return trim(normalize("NFKC", column))


def _group_rows(
    table: Table, columns: _Columns, exam: Sitting
) -> tuple[Mapping[str, Sequence[Row]], list[Complaint]]:
    ids = StudentIds(exam.students, exam.codes)
    found = [(row, ids.exact(row.cell(columns.student))) for row in drop_headers(table)]
    strange = [row.cell(columns.student) for row, student in found if student is None]
    taken = {student for _, student in found if student is not None} if strange else set()
    restored = ids.restored(strange, taken)
    rows: dict[str, list[Row]] = defaultdict(list)
    complaints = [_complain_of_restored(table, columns, restored)] if restored else []
    for row, exact in found:
        student = exact or restored.get(row.cell(columns.student))
        if student is None:
            complaints.append(_complain_of_unknown(table, row, columns, ids))
        else:
            rows[student].append(row)
    return rows, complaints


def _complain_of_restored(
    table: Table, columns: _Columns, restored: Mapping[str, str]
) -> Complaint:
    problem, done = describe_restoration(restored)
    return Complaint(table.file, None, table.header[columns.student], "", problem, done)


def _complain_of_unknown(table: Table, row: Row, columns: _Columns, ids: StudentIds) -> Complaint:
    cell = row.cell(columns.student)
    key, likely = make_student_key(cell), ids.near(cell)
    unknown = Message("marking.no-student", student=Quoted(shorten(key)))
    correct = Message("marking.correct-id", students=list_choices(map(Quoted, likely)))
    return Complaint(
        table.file,
        row.line,
        table.header[columns.student],
        _join_row(row),
        unknown if key else Message("marking.no-id"),
        correct if likely else Message("marking.not-graded"),
    )


def _join_row(row: Row) -> str:
    return write_csv_text([shorten(cell) for cell in row.cells], []).rstrip("\n")


def _make_entries(
    rows: Sequence[Row],
    file: str,
    responses: Callable[[tuple[str, ...]], tuple[str, ...]],
    put: Mapping[int, Sources],
) -> tuple[Entry, ...]:
    if len(rows) == 1:
        (row,) = rows
        return (Entry(row.line, responses(row.cells), "", file, put.get(row.line, ())),)
    return tuple(
        [
            Entry(row.line, responses(row.cells), _join_row(row), file, put.get(row.line, ()))
            for row in rows
        ]
    )


def _find_extra_columns(table: Table, columns: _Columns) -> Iterator[Complaint]:
    for index in columns.extra:
        name = shorten(table.header[index])
        filled = [row for row in table.rows if trim(row.cell(index))]
        if trim(name):
            done = Message("marking.cells-follow") if filled else Message("marking.ignored")
            yield Complaint(
                table.file,
                None,
                name,
                "",
                Message("marking.no-answer-column-here"),
                done,
            )
        for row in filled:
            content = shorten(row.cell(index))
            yield Complaint(
                table.file,
                row.line,
                name,
                content,
                Message("marking.in-ignored-column"),
                Message("marking.kept-here"),
            )
