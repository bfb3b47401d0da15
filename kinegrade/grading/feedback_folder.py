"""`kinegrade feedback`: a folder with a sheet for every student, written whole or not at all.

`sheets/` holds one file for each student; `feedback.csv` says which is whose, for programs that
send them out.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Literal, assert_never

from kinegrade.csv_writing import neutralised, write_for_people
from kinegrade.errors import ExamError
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.files import output_folder
from kinegrade.grading.feedback import FeedbackSheet, feedback_sheets
from kinegrade.grading.feedback_html import feedback_html
from kinegrade.grading.feedback_markdown import feedback_markdown
from kinegrade.grading.wording import Wording
from kinegrade.language import Language
from kinegrade.marks_folder.folder import MarksFolder

Text = Literal["html", "md"]
# The sheet as PDF, a solution behind it where there is one
Press = Callable[[FeedbackSheet, bytes | None], bytes]
MARKER, SHEETS = "feedback.csv", "sheets"


def write_feedback(
    exam: ExamFolder,
    marks: MarksFolder,
    output: Path,
    wording: Wording,
    form: Text | Press,
    *,
    language: Language,
    solutions: bool = False,
    force: bool = False,
) -> int:
    """Writes the folder `output` and gives the number of sheets.

    `form` is a kind of text, or what prints a PDF.
    With `solutions` everybody gets the worked solutions that the exam folder has: in the PDF, or as
    a file beside. Raises ExamError, TableError, TypesetError, OutputError; then nothing is written.
    """
    if solutions and marks.put:
        raise ExamError(
            f"{marks.path}: the answers were given to questions from a pool, and {exam.path} has "
            "worked solutions of the students' own papers - expected no solutions - "
            "add --no-solutions"
        )
    with output_folder(output, marker=MARKER, contents=(MARKER, SHEETS), force=force) as folder:
        (folder / SHEETS).mkdir()
        rows = []
        for candidate, sheet in feedback_sheets(marks, exam, wording, language):
            stem = exam.head.file_stems[candidate.student]
            solution = exam.solution(stem) if solutions else None
            files = dict(_files(stem, sheet, solution, form))
            for name, content in files.items():
                (folder / SHEETS / name).write_bytes(content)
            whose = candidate.student, neutralised(candidate.name), neutralised(candidate.email)
            rows.append((*whose, f"{SHEETS}/{next(iter(files))}"))
        write_for_people(folder / MARKER, ("student", "name", "email", "file"), rows)
    return len(rows)


def _files(
    stem: str, sheet: FeedbackSheet, solution: bytes | None, form: Text | Press
) -> Iterator[tuple[str, bytes]]:
    """The names and contents of one student's files, the sheet first."""
    if callable(form):
        yield f"{stem}.pdf", form(sheet, solution)
        return
    beside = f"{stem}-solution.pdf" if solution is not None else ""
    sheet = replace(sheet, solution=beside)
    text = _text(sheet, form)
    yield f"{stem}.{form}", text.encode("utf-8", "backslashreplace")
    if solution is not None:
        yield beside, solution


def _text(sheet: FeedbackSheet, form: Text) -> str:
    match form:
        case "md":
            return feedback_markdown(sheet)
        case "html":
            return feedback_html(sheet)
        case _:
            assert_never(form)
