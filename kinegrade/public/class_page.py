"""`kinegrade.report`: a page on the class."""

from __future__ import annotations

from os import PathLike
from pathlib import Path

from kinegrade.exam.exam_wording import read_exam_wording
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.files.output import write_file
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.public.folders import expect_own_place
from kinegrade.public.opened import expect_exam_and_marks
from kinegrade.public.options import find_language
from kinegrade.public.outcome import Outcome
from kinegrade.reports.classes.page import class_report


def report(
    exam: ExamFolder,
    marks: MarksFolder,
    output: str | PathLike[str],
    *,
    language: str | None = None,
    ranks: bool = False,
    force: bool = False,
) -> Outcome:
    """Write a page on the class: distribution, how hard each ask was, where points were lost; as
    `kinegrade report` does, in the papers' language unless another one is wanted; with `ranks`, how
    the students stand in the class.

    Raises KinegradeError.

    >>> exam, marks = kinegrade.open_exam("EXAM"), kinegrade.open_marks("MARKS")
    >>> report(exam, marks, "report.html").path.suffix
    '.html'
    >>> report(exam, marks, "report.html")
    Traceback (most recent call last):
    kinegrade.errors.OutputError: report.html: already exists - ...
    """
    expect_exam_and_marks(exam, marks)
    place = Path(output)
    expect_own_place(place)
    chosen = exam.language if language is None else find_language(language)
    page = class_report(marks, exam, read_exam_wording(exam, chosen), chosen, ranks=ranks)
    write_file(place, page.encode("utf-8", "backslashreplace"), "html", force=force)
    return Outcome(place)
