"""A file to be filled in, and the texts that go into its cells."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from html import escape

from kinegrade.files.cell_text import trim
from kinegrade.files.tables import Complaint
from kinegrade.language.message import (
    Message,
    Quoted,
)
from kinegrade.lms.grades.cells import Cell, CellTable, Record
from kinegrade.lms.grades.dialect import Dialect, Download, ExportOptions
from kinegrade.lms.grades.grades import ClassGrades, StudentGrade, feedback_text
from kinegrade.lms.grades.item_candidates import ItemColumn
from kinegrade.lms.grades.matching import Matching
from kinegrade.lms.grades.maximum import scaled, target_maximum
from kinegrade.numbers.amounts import write_amount


@dataclass(frozen=True)
class FillingTask:
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


def list_changes(
    task: FillingTask,
    rows: Sequence[Record],
    matching: Matching,
    graded: set[str],
    grades: ClassGrades,
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


def _find_locked(task: FillingTask, row: Record) -> Message | None:
    """Why the system would skip a whole row; None where it would not."""
    header, text = task.download.locked
    places = [place for place, title in enumerate(task.table.titles) if title == header != ""]
    if any(trim(row.cells[place].text) == text for place in places):
        return Message("grades.locked-row", text=Quoted(text), header=Quoted(header))
    return None


def _collect_comments(
    task: FillingTask, row: Record, grade: StudentGrade, grades: ClassGrades
) -> dict[Cell, str]:
    channel = task.download.channel
    if channel is None:
        return {}
    text = feedback_text(grade, grades.questions, grades.language)
    shown = escape(text, quote=False) if channel.html else text
    return {
        row.cells[place]: channel.format_text if is_format else shown
        for place, is_format in task.feedback.items()
    }


def _explain_closed(
    task: FillingTask, row: Record, column: ItemColumn, grade: StudentGrade, reason: Message
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


def find_misread(task: FillingTask, rows: Sequence[Record]) -> Iterator[Complaint]:
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
