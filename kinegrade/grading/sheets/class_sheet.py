"""One answer sheet from one file or several: versions' quizzes, or parts of the exam typed by
different assistants.

`class_sheet` is called by `grade`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinegrade.exam.folder.sitting import Sitting
from kinegrade.files.answer_file import AnswerFile, LeftOut
from kinegrade.files.tables import Complaint, Table
from kinegrade.grading.sheets.attempts import find_unordered, leave_out_blank, order_attempts
from kinegrade.grading.sheets.entry import Entry
from kinegrade.grading.sheets.grid_entries import GridEntries
from kinegrade.grading.sheets.joining import Entries, join_parts
from kinegrade.grading.sheets.part import read_part
from kinegrade.grading.sheets.sheet import Sheet
from kinegrade.language.message import Message, Quoted


def read_sheet(table: Table, exam: Sitting) -> Sheet:
    """The sheet of a single file; raises TableError as `class_sheet` does."""
    return class_sheet([AnswerFile(table)], exam)


def class_sheet(files: Sequence[AnswerFile], exam: Sitting) -> Sheet:
    """Finds every student's responses in these files, which together are one class.

    Raises TableError if a file has no student column, no answer column, or is the sheet of another
    exam.
    """
    parts = [read_part(answers, exam) for answers in files]
    names = ", ".join(part.file for part in parts)
    columns = tuple(
        next((part.columns[number] for part in parts if part.columns[number]), "")
        for number in range(len(exam.asks))
    )
    entries, conflicts = join_parts(parts, exam.asks)
    left_out = [each for answers in files for each in answers.left_out]
    unordered = () if isinstance(entries, GridEntries) else find_unordered(entries)
    complaints = [
        *(complaint for part in parts for complaint in part.complaints),
        *_find_missing_columns(names, columns, exam),
        *conflicts,
        *unordered,
        *_find_left_out(left_out, entries),
        *_find_missing_students(names, exam, entries, {each.student for each in left_out}),
    ]
    return Sheet(
        tuple(name or ask.column for name, ask in zip(columns, exam.asks, strict=True)),
        _arrange(entries, exam, names),
        tuple(complaints),
    )


def _arrange(entries: Entries, exam: Sitting, names: str) -> Entries:
    """Those of all examinees, empty ones of those who have none."""
    if isinstance(entries, GridEntries):
        return entries.of(exam.students)
    nothing = (Entry(None, ("",) * len(exam.asks), file=names),)
    found = ((student, entries.get(student, nothing)) for student in exam.students)
    return {
        student: order_attempts(leave_out_blank(several)) if len(several) > 1 else several
        for student, several in found
    }


def _find_missing_columns(names: str, columns: Sequence[str], exam: Sitting) -> Iterator[Complaint]:
    for ask, name in zip(exam.asks, columns, strict=True):
        if not name:
            problem, done = Message("marking.no-column"), Message("marking.column-blank")
            yield Complaint(names, None, ask.column, "", problem, done)


def _find_left_out(left_out: Sequence[LeftOut], entries: Entries) -> Iterator[Complaint]:
    """Why rows are not marked; for a student without an attempt only once, and only if no other
    file has one.
    """
    absent: set[str] = set()
    for each in left_out:
        if each.attempted:
            yield each.complaint
        elif each.student not in entries and each.student not in absent:
            absent.add(each.student)
            yield each.complaint


def _find_missing_students(
    names: str, exam: Sitting, entries: Entries, said: set[str]
) -> Iterator[Complaint]:
    there = entries.keys()
    if (*there,) == exam.students:  # as in most files
        return
    for student in exam.students:
        if student not in there and student not in said:
            problem = Message("marking.no-row", student=Quoted(student))
            yield Complaint(names, None, "", student, problem, Message("marking.all-blank"))
