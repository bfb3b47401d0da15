"""Everything that is told of answers which stand in a wrong place of the sheet, once a class is
marked: columns, rows, and those to another sheet or
version.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.files.answer_file import AnswerFile
from kinegrade.files.tables import Complaint
from kinegrade.grading.fast.another_paper import PapersAnswered
from kinegrade.grading.misplaced.class_answers import ClassAnswers
from kinegrade.grading.misplaced.columns import MisplacedColumns
from kinegrade.grading.misplaced.displaced_columns import DisplacedColumns
from kinegrade.grading.misplaced.other_sheets import find_other_sheets
from kinegrade.grading.misplaced.other_versions import OtherVersions
from kinegrade.grading.misplaced.rows import MisplacedRows


def find_typing_slips(
    exam: ExamFolder, papers: PapersAnswered, titles: Sequence[str], answers: ClassAnswers
) -> Iterator[Complaint]:
    """The complaints, columns first. Raises ExamError where the papers cannot be read."""
    yield from DisplacedColumns(papers.intervals, titles, answers).list_complaints()
    columns = MisplacedColumns(papers.intervals, titles, answers)
    yield from columns.list_complaints()
    asks, questions = columns.others, papers.questions
    students = exam.students
    rows = MisplacedRows(papers.intervals, papers.different, students, answers, asks, questions)
    yield from rows.list_complaints()
    yield from find_other_sheets(exam, answers)
    if exam.head.versions:
        versions = [each.version for each in exam.head.students]
        yield from OtherVersions(exam.students, versions, answers).list_complaints()


def put_after(
    files: Iterable[AnswerFile], slips: Iterable[Complaint], complaints: Sequence[Complaint]
) -> tuple[Complaint, ...]:
    """The complaints with these slips in front, but behind what is said of whole files as they were
    read, which may be why.
    """
    first = [each for file in files for each in file.table.complaints if each.line is None]
    return (*first, *slips, *(each for each in complaints if each not in first))
