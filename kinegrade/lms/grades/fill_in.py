"""The system's own file filled in: only the grade cells of matched students change, every other
byte stays.

`fill_in` is called by `export --into`. A cell with anything but a grade (excused, not assigned) is
left unchanged, with a complaint. The cells of students who handed in nothing are left unchanged
too, because an empty or zero grade would replace the one in the system.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from kinegrade.errors import Problem, TableError
from kinegrade.files.cell_text import trim
from kinegrade.files.tables import Complaint
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
from kinegrade.lms.grades.filling_task import FillingTask, find_misread, list_changes
from kinegrade.lms.grades.grades import TOTAL, ClassGrades
from kinegrade.lms.grades.item_columns import ItemColumns, item_columns
from kinegrade.lms.grades.key_column import KeyColumn
from kinegrade.lms.grades.key_columns import exam_hint, key_columns
from kinegrade.lms.grades.matching import match
from kinegrade.lms.grades.maximum import maximum_faults
from kinegrade.lms.grades.replaced_cells import find_replaced


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
    task = FillingTask(table, dialect, download, found.columns, feedback, options)
    _refuse_maxima(task, grades)
    graded = {each.student for each in grades.exported(ungraded=options.ungraded)}
    matching = match(table, rows, keys, grades.students, graded, test_person=download.test_person)
    changes, closed = list_changes(task, rows, matching, graded, grades)
    complaints = (*matching.complaints, *closed, *find_misread(task, rows))
    if not changes:
        hint = exam_hint(table, grades.students)
        nothing = Message("grades.no-student-fits", hint=hint)
        raise TableError(Fault(table.file, nothing), *(each.fault for each in complaints[:20]))
    notes = (*_list_notes(task, keys), *find_replaced(task, rows, matching, changes))
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


def _list_notes(task: FillingTask, keys: Sequence[KeyColumn]) -> Iterator[Problem]:
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


def _refuse_maxima(task: FillingTask, grades: ClassGrades) -> None:
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


def _write_content(task: FillingTask, changes: Mapping[Cell, str]) -> bytes:
    content, most = task.table.with_cells(changes), task.download.most_bytes
    if most is not None and len(content) > most:
        large = Message(
            "grades.too-large", number=len(content), most=most, system=task.dialect.name
        )
        raise TableError(Fault(task.table.file, large))
    return content


def _count(rows: Sequence[Record], changes: Mapping[Cell, str]) -> int:
    return sum(any(cell in changes for cell in row.cells) for row in rows)
