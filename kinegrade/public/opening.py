"""`kinegrade.open_exam` and `kinegrade.open_marks`: folders that were written before."""

from __future__ import annotations

from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

from kinegrade.exam.folder import exam_folder
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.public.folders import expect_folders

if TYPE_CHECKING:
    from kinegrade.marks_folder.folder import MarksFolder


def open_exam(path: str | PathLike[str]) -> ExamFolder:
    """The exam folder there. Raises ExamError with all faults of its head, TableError for a folder
    of marks.

    >>> open_exam("EXAM").questions
    ('q1',)
    >>> open_exam("MARKS")
    Traceback (most recent call last):
    kinegrade.errors.TableError: MARKS: you gave MARKS where EXAM is expected - ...
    """
    expect_folders((Path(path), "EXAM"))
    return exam_folder.open_exam(Path(path))


def open_marks(path: str | PathLike[str], *, to_mark_again: bool = False) -> MarksFolder:
    """The marks folder there. Raises TableError where its totals contradict its marks, and for
    anything else. One that is opened `to_mark_again`, as `GradeOptions(since=...)`, may lack marks
    by hand that were taken back in its manual.csv.

    >>> [student.total for student in open_marks("MARKS").totals.students]
    [Fraction(2, 1), Fraction(0, 1)]
    >>> open_marks("EXAM")
    Traceback (most recent call last):
    kinegrade.errors.TableError: EXAM: you gave EXAM where MARKS is expected - ...
    """
    from kinegrade.marks_folder import folder as marks_folder  # a paper alone needs no marks

    expect_folders((Path(path), "MARKS"))
    return marks_folder.open_marks(Path(path), to_mark_again=to_mark_again)
