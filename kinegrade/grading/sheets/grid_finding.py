"""Whether a file of answers has one row for each student and nothing else that matters to marks."""

from __future__ import annotations

from collections.abc import Sequence

from kinegrade.exam.folder.sitting import Sitting
from kinegrade.exam.roster.student_ids import StudentIds
from kinegrade.files.answer_file import AnswerFile
from kinegrade.files.rows.cell_grid import CellGrid
from kinegrade.files.tables import drop_headers
from kinegrade.grading.sheets.columns import Columns
from kinegrade.grading.sheets.grid_entries import AnswerGrid, GridEntries


def find_grid_entries(answers: AnswerFile, columns: Columns, exam: Sitting) -> GridEntries | None:
    """The entries of a file whose rows stand in a grid, each that of another student by its id,
    with an answer to each ask; None for any other file.
    """
    rows = drop_headers(answers.table)
    asks = [column for column in columns.asks if column is not None]
    beside = answers.put or answers.lines or answers.submitted
    others = columns.codes or columns.ids
    if not isinstance(rows, CellGrid) or beside or others or len(asks) < len(columns.asks):
        return None
    # In most files, which `generate` wrote, they are those of the roster, and are held once
    ids: Sequence[str | None] = exam.students
    if (*rows.column(columns.student),) != ids:
        ids = StudentIds(exam.students, exam.codes).all_exact(rows.column(columns.student))
    places = dict(zip(filter(None, ids), range(len(ids)), strict=False))
    if len(places) < len(ids):
        return None
    return GridEntries(AnswerGrid(rows, tuple(asks), answers.table.file), places)
