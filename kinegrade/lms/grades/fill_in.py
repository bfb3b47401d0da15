"""The system's own file filled in: only the grade cells of matched students change, every other
byte stays.

`fill_in` is called by `export --into`. A cell with anything but a grade (excused, not assigned) is
left unchanged, with a complaint. The cells of students who handed in nothing are left unchanged
too, because an empty or zero grade would replace the one in the system.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from pathlib import Path

from kinegrade.errors import Problem, TableError
from kinegrade.files.tables import Complaint, trim
from kinegrade.language.lines import show_in_one_line
from kinegrade.language.message import (
    Fault,
    Listing,
    Message,
    Quoted,
    list_all,
    list_choices,
    list_plainly,
)
from kinegrade.lms.grades.cells import Cell, CellTable, Record, read_cells
from kinegrade.lms.grades.dialect import Dialect, Download, ExportOptions
from kinegrade.lms.grades.grades import TOTAL, ClassGrades, StudentGrade, feedback_text
from kinegrade.lms.grades.item_columns import ItemColumn, ItemColumns, item_columns
from kinegrade.lms.grades.key_columns import exam_hint, key_columns
from kinegrade.lms.grades.matching import KeyColumn, Matching, match
from kinegrade.lms.grades.maximum import maximum_faults, scaled, target_maximum
from kinegrade.numbers.amounts import write_amount


@dataclass(frozen=True, slots=True)
class Filled:
    """The bytes to be written, how many students have a grade in them, and what the instructor has
    to check.

    `notes` state which columns were used, and what was left out because the file has no column for
    it.
    """

    content: bytes
    students: int
    complaints: tuple[Complaint, ...]
    notes: tuple[Problem, ...]


@dataclass(frozen=True)
class _Task:
    """A file, and the columns into which grades and feedback go."""

    table: CellTable
    dialect: Dialect
    download: Download
    columns: Mapping[str, ItemColumn]
    feedback: Mapping[int, bool]
    options: ExportOptions

    def written(self, grade: StudentGrade, item: str) -> str:
        """The text of a grade cell."""
        target = target_maximum(self.columns[item].maximum, self.options)
        text = write_amount(scaled(grade, item, target), self.dialect.places)
        comma = self.download.decimal_comma_with_semicolon and self.table.separator == ";"
        return text.replace(".", ",") if comma else text


def fill_in(dialect: Dialect, grades: ClassGrades, into: Path, options: ExportOptions) -> Filled:
    """Fills the grades into a downloaded file. Raises TableError with all faults at once."""
    table = read_cells(into)
    download = _read_download(dialect, table)
    _refuse_unreadable(dialect, download, table)
    rows = [row for row in table.rows if not _is_skipped(download, row)]
    keys = key_columns(dialect, download, table, rows, students=grades.students, options=options)
    places = {key.place for key in keys}
    found = item_columns(table, dialect, download, grades=grades, keys=places, options=options)
    feedback = _collect_feedback(dialect, download, table, found, options)
    task = _Task(table, dialect, download, found.columns, feedback, options)
    _refuse_maxima(task, grades)
    graded = {each.student for each in grades.exported(ungraded=options.ungraded)}
    matching = match(table, rows, keys, grades.students, graded, test_person=download.test_person)
    changes, closed = _list_changes(task, rows, matching, graded, grades)
    complaints = (*matching.complaints, *closed, *_find_misread(task, rows))
    if not changes:
        hint = exam_hint(table, grades.students)
        nothing = Message("grades.no-student-fits", hint=hint)
        raise TableError(Fault(table.file, nothing), *(each.fault for each in complaints[:20]))
    notes = tuple(_list_notes(task, keys))
    return Filled(_write_content(task, changes), _count(rows, changes), complaints, notes)


def _read_download(dialect: Dialect, table: CellTable) -> Download:
    titles = set(table.titles)
    for download in dialect.downloads:
        if titles.issuperset(download.required):
            return download
    if not dialect.downloads:
        raise TableError(Message("grades.no-file-to-fill", system=dialect.name))
    columns = list_choices(list_plainly(download.required) for download in dialect.downloads)
    other = Message("grades.other-file", system=dialect.name, columns=columns)
    raise TableError(Fault(table.file, other))


def _refuse_unreadable(dialect: Dialect, download: Download, table: CellTable) -> None:
    faults: list[Message] = []
    if download.encodings and table.encoding not in download.encodings:
        faults.append(
            Message(
                "grades.refused-encoding",
                encoding=table.encoding,
                encodings=list_choices(download.encodings),
                system=dialect.name,
            )
        )
    if download.beginning and not download.beginning.match(f"{','.join(table.titles)},"):
        titles = list_plainly(table.titles[:6])
        faults.append(Message("grades.other-columns", titles=titles, system=dialect.name))
    if download.broken_beginning and download.broken_beginning.match(table.text):
        faults.append(Message("grades.byte-order-mark", system=dialect.name))
    if faults:
        raise TableError(*(Fault(table.file, fault) for fault in faults))


def _collect_feedback(
    dialect: Dialect,
    download: Download,
    table: CellTable,
    found: ItemColumns,
    options: ExportOptions,
) -> Mapping[int, bool]:
    if options.feedback is False:
        return {}
    if found.feedback is None and options.feedback:
        no_column = Message("grades.no-feedback-column", system=dialect.name)
        raise TableError(Fault(table.file, no_column))
    return found.feedback or {}


def _list_notes(task: _Task, keys: Sequence[KeyColumn]) -> Iterator[Problem]:
    """Which columns were used where headers did not decide that, and what is left out."""
    titles, options = task.table.titles, task.options
    if task.download.item_words is not None:
        keyed = _write_list(titles[place] for place in dict.fromkeys(key.place for key in keys))
        points = _write_list(column.header for column in task.columns.values())
        comments = _write_list(titles[place] for place in task.feedback)
        into = (
            Message("grades.into-both", points=points, comments=comments)
            if comments.items
            else Message("grades.into", points=points)
        )
        yield Fault(task.table.file, Message("grades.found-by", keys=keyed, into=into))
    wanted = options.feedback is None and task.download.channel and TOTAL in task.columns
    if wanted and not task.feedback:
        yield Fault(task.table.file, Message("grades.feedback-left-out"))


def _write_list(titles: Iterable[str]) -> Listing:
    return list_all(map(Quoted, titles))


def _refuse_maxima(task: _Task, grades: ClassGrades) -> None:
    students = grades.exported(ungraded=task.options.ungraded)
    faults = [
        fault
        for item, column in task.columns.items()
        for fault in maximum_faults(
            f'{task.table.file}: "{show_in_one_line(column.header)}"',
            item,
            students,
            column.maximum,
            task.options,
        )
    ]
    if faults:
        raise TableError(*dict.fromkeys(faults))


def _is_skipped(download: Download, row: Record) -> bool:
    if not any(trim(cell.text) for cell in row.cells):
        return True
    return bool(download.skipped_row and download.skipped_row.match(row.cells[0].text))


def _list_changes(
    task: _Task, rows: Sequence[Record], matching: Matching, graded: set[str], grades: ClassGrades
) -> tuple[dict[Cell, str], list[Complaint]]:
    """The new texts of cells, and complaints about those that may not be changed."""
    changes: dict[Cell, str] = {}
    complaints = []
    for row in rows:
        grade = matching.students.get(row.line)
        if grade is None or grade.student not in graded:
            continue
        for item, column in task.columns.items():
            cell = row.cells[column.place]
            reason = task.download.closed.get(trim(cell.text).upper()) or _find_locked(task, row)
            if reason:
                complaints.append(_explain_closed(task, row, column, grade, reason))
                continue
            changes[cell] = task.written(grade, item)
            changes |= _collect_comments(task, row, grade, grades)
    return changes, complaints


def _find_locked(task: _Task, row: Record) -> Message | None:
    """Why the system would skip a whole row; None where it would not."""
    header, text = task.download.locked
    places = [place for place, title in enumerate(task.table.titles) if title == header != ""]
    if any(trim(row.cells[place].text) == text for place in places):
        return Message("grades.locked-row", text=Quoted(text), header=Quoted(header))
    return None


def _collect_comments(
    task: _Task, row: Record, grade: StudentGrade, grades: ClassGrades
) -> dict[Cell, str]:
    channel = task.download.channel
    if channel is None:
        return {}
    text = feedback_text(grade, grades.questions)
    shown = escape(text, quote=False) if channel.html else text
    return {
        row.cells[place]: channel.format_text if is_format else shown
        for place, is_format in task.feedback.items()
    }


def _explain_closed(
    task: _Task, row: Record, column: ItemColumn, grade: StudentGrade, reason: Message
) -> Complaint:
    problem = Message(
        "grades.closed-cell",
        student=Quoted(grade.student),
        reason=reason,
        text=row.cells[column.place].text,
    )
    done = Message("grades.left-as-it-is")
    if len(task.columns) == 1:
        would_be = task.written(grade, next(iter(task.columns)))
        done = Message("grades.left-with-grade", grade=would_be)
    return Complaint(task.table.file, row.line, column.header, grade.student, problem, done)


def _find_misread(task: _Task, rows: Sequence[Record]) -> Iterator[Complaint]:
    """Cells of other columns that the system would read as other numbers."""
    shape = task.download.misread
    places = {column.place for column in task.columns.values()}
    keys = {title for key in task.download.keys for title in key.headers}
    for row in rows if shape else ():
        for place, cell in enumerate(row.cells):
            if (
                shape
                and place not in places
                and task.table.titles[place] not in keys
                and shape.fullmatch(cell.text)
            ):
                problem = Message(
                    "grades.misread",
                    system=task.dialect.name,
                    text=Quoted(cell.text),
                    number=cell.text.replace(",", ".", 1),
                )
                yield Complaint(
                    task.table.file,
                    row.line,
                    task.table.titles[place],
                    cell.text,
                    problem,
                    Message("grades.correct-first"),
                )


def _write_content(task: _Task, changes: Mapping[Cell, str]) -> bytes:
    content, most = task.table.with_cells(changes), task.download.most_bytes
    if most is not None and len(content) > most:
        large = Message(
            "grades.too-large", number=len(content), most=most, system=task.dialect.name
        )
        raise TableError(Fault(task.table.file, large))
    return content


def _count(rows: Sequence[Record], changes: Mapping[Cell, str]) -> int:
    return sum(any(cell in changes for cell in row.cells) for row in rows)
