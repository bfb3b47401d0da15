"""One file of answers: its columns are found, its rows given to their students, and whatever is
neither becomes a complaint.

`read_part` is called by `class_sheet`.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from kinegrade.exam.folder.sitting import Sitting
from kinegrade.exam.roster.student_ids import StudentIds
from kinegrade.exam.roster.student_names import StudentNames, find_name_columns
from kinegrade.exam.roster.students import make_student_key
from kinegrade.files.answer_file import AnswerFile
from kinegrade.files.cell_text import shorten, trim
from kinegrade.files.rows.row import Row
from kinegrade.files.tables import Complaint, Table, drop_headers
from kinegrade.grading.sheets.columns import Columns, find_columns
from kinegrade.grading.sheets.entry import Entry
from kinegrade.grading.sheets.extra_columns import find_extra_columns
from kinegrade.grading.sheets.grid_entries import GridEntries
from kinegrade.grading.sheets.grid_finding import find_grid_entries
from kinegrade.grading.sheets.header_units import find_stated_units
from kinegrade.grading.sheets.sheet import Part, quote_cells
from kinegrade.language.message import Message, Quoted, list_choices


@dataclass(frozen=True)
class _Papers:
    """Whose papers are whose, the spare ones, which are nobody's, and by student those that were
    theirs before an exchange.
    """

    ids: StudentIds
    spares: StudentIds
    before: Mapping[str, StudentIds]

    @classmethod
    def of(cls, exam: Sitting) -> _Papers:
        """Those of an exam."""
        before: dict[str, dict[str, str]] = defaultdict(dict)
        for student, code in exam.codes_before:
            before[student][code] = student
        return cls(
            StudentIds(exam.students, exam.codes, exam.former_ids),
            StudentIds((), {code: code for code in exam.spare_codes}),
            {student: StudentIds((), codes) for student, codes in before.items()},
        )

    def had(self, student: str, code: str) -> bool:
        """Whether the paper with that code was the student's before an exchange."""
        return student in self.before and self.before[student].coded(code) is not None


def read_part(answers: AnswerFile, exam: Sitting) -> Part:
    """Finds the responses in one file.

    Raises TableError if there is no student column or no answer column, or if the sheet belongs to
    another exam.
    """
    table = answers.table
    columns = find_columns(table, exam.asks)
    names = tuple("" if index is None else table.header[index] for index in columns.asks)
    stated = find_stated_units(table, columns, exam.asks)
    about_columns = (
        *table.complaints,
        *find_extra_columns(table, columns, exam),
        *stated.complaints,
    )
    grid = None if any(stated.units) else find_grid_entries(answers, columns, exam)
    if grid is not None:
        unlike = _find_other_names(table, grid, StudentNames(exam.names))
        return Part(table.file, names, grid, (*about_columns, *unlike))
    rows, complaints = _group_rows(table, columns, exam)
    responses = stated.convert(columns.responses())
    put, places = columns.sources(answers), columns.places(answers)

    only_rows = not (put or places or answers.submitted)

    def make_entry(row: Row, kept: str) -> Entry:
        if only_rows:  # as in most files
            return Entry(row.line, responses(row.cells), kept, table.file)
        sources = put.get(row.line, ())
        given = responses(row.cells)
        at = places.get(row.line, ())
        when = answers.submitted.get(row.line, "")
        return Entry(row.line, given, kept, table.file, sources, at, submitted=when)

    entries = {student: _make_entries(several, make_entry) for student, several in rows.items()}
    unlike = _find_other_names(table, rows, StudentNames(exam.names))
    return Part(table.file, names, entries, (*about_columns, *complaints, *unlike))


def _group_rows(
    table: Table, columns: Columns, exam: Sitting
) -> tuple[Mapping[str, Sequence[Row]], list[Complaint]]:
    papers = _Papers.of(exam)
    ids = papers.ids
    kept = drop_headers(table)
    exactly = ids.all_exact([row.cell(columns.student) for row in kept])
    found = list(zip(kept, exactly, strict=True))
    strange = [row.cell(columns.student) for row, student in found if student is None]
    taken = {student for _, student in found if student is not None} if strange else set()
    restored = ids.restored(strange, taken)
    rows: dict[str, list[Row]] = defaultdict(list)
    complaints = [*_complain_of_restored(table, columns, ids, restored)]
    for row, exact in found:
        student = exact or restored.get(row.cell(columns.student))
        if student is None:
            complaints.append(_complain_of_unknown(table, row, columns, papers))
        else:
            rows[student].append(row)
            if columns.codes or columns.ids:
                complaints += _find_other_codes(table, row, columns, papers, student)
                complaints += _find_other_ids(table, row, columns, ids, student)
    return rows, complaints


def _find_other_codes(
    table: Table, row: Row, columns: Columns, papers: _Papers, student: str
) -> Iterator[Complaint]:
    """A complaint for a code beside the id that is not that of the student's paper."""
    for index in columns.codes:
        code = row.cell(index)
        owner = papers.ids.coded(code)
        if not trim(code) or owner == student:
            continue
        whose, shown = Quoted(student), shorten(trim(code))
        done = Message("marking.own-or-exchange", student=whose, code=shown, whose=student)
        if owner:
            problem = Message("marking.code-of-another", student=Quoted(owner))
        elif papers.spares.coded(code):
            problem = Message("marking.code-of-spare")
        else:
            problem = Message("marking.no-such-code")
            done = Message("marking.marked-by-id", student=whose)
        if papers.had(student, code):  # in a workbook from before: the exchange is not to be undone
            done = Message("marking.own-since-exchange", student=whose)
        yield Complaint(table.file, row.line, table.header[index], shown, problem, done)


def _find_other_ids(
    table: Table, row: Row, columns: Columns, ids: StudentIds, student: str
) -> Iterator[Complaint]:
    """A complaint for each further id that is that of another student."""
    for index in columns.ids:
        cell = row.cell(index)
        owner = ids.exact(cell)
        if owner is not None and owner != student:
            problem = Message("marking.id-of-another", student=Quoted(owner))
            done = Message("marking.by-other-id", student=Quoted(student))
            yield Complaint(table.file, row.line, table.header[index], cell, problem, done)


def _find_other_names(
    table: Table, rows: Mapping[str, Sequence[Row]] | GridEntries, names: StudentNames
) -> Iterator[Complaint]:
    """A complaint for each name beside an id that is that of another student."""
    columns = find_name_columns(table.header)
    if not columns.places:
        return
    place, *others = columns.places
    own, title = {} if others else names.by_student, table.header[place]
    for student, row in _list_unlike(rows, place, own):
        other = names.find_other(student, columns.written(row))
        if other is not None:
            problem = Message("marking.name-of-another", student=Quoted(other))
            done = Message("marking.not-by-name", student=Quoted(student))
            yield Complaint(table.file, row.line, title, "", problem, done)


def _list_unlike(
    rows: Mapping[str, Sequence[Row]] | GridEntries, place: int, own: Mapping[str, str]
) -> Iterator[tuple[str, Row]]:
    """The rows, each with its student, whose cell at that place is not the student's own; it is
    that of most rows.
    """
    if isinstance(rows, GridEntries):
        cells, grid = rows.grid.cells.column(place), rows.grid.cells
        written = [cells[row] for row in rows.places.values()]
        if written != [*map(own.get, rows.places)]:
            for student, row in rows.places.items():
                if cells[row] != own.get(student):
                    yield student, grid[row]
        return
    for student, several in rows.items():
        for each in several:
            if each.cell(place) != own.get(student):
                yield student, each


def _complain_of_restored(
    table: Table, columns: Columns, ids: StudentIds, restored: Mapping[str, str]
) -> Iterator[Complaint]:
    for problem, done in ids.describe_restored(restored):
        yield Complaint(table.file, None, table.header[columns.student], "", problem, done)


def _complain_of_unknown(table: Table, row: Row, columns: Columns, papers: _Papers) -> Complaint:
    cell = row.cell(columns.student)
    problem, done = _explain_unknown(cell, papers)
    shown = quote_cells(row.cells)
    return Complaint(table.file, row.line, table.header[columns.student], shown, problem, done)


def _explain_unknown(cell: str, papers: _Papers) -> tuple[Message, Message]:
    """What is wrong with an id that nobody has, and what to do."""
    key, likely = make_student_key(cell), papers.ids.near(cell)
    spare = papers.spares.coded(cell)
    if not key:
        return Message("marking.no-id"), Message("marking.not-graded")
    if spare:
        return Message("marking.nobodys-paper", code=spare), Message("marking.assign", code=spare)
    unknown = Message("marking.no-student", student=Quoted(shorten(key)))
    if likely:
        students = list_choices(map(Quoted, likely))
        return unknown, Message("marking.correct-id", students=students)
    return unknown, Message("marking.not-graded")


def _make_entries(
    rows: Sequence[Row], make_entry: Callable[[Row, str], Entry]
) -> tuple[Entry, ...]:
    """The entries of a student; where there are several, each keeps its row as it came."""
    if len(rows) == 1:
        return (make_entry(rows[0], ""),)
    return tuple([make_entry(row, quote_cells(row.cells)) for row in rows])
