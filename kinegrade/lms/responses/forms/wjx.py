"""Responses of a 问卷星 (wjx.cn) questionnaire: six columns about the submission, then the
questions, like "2、学号".
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from kinegrade.errors import TableError
from kinegrade.exam.folder.records import ExamHead
from kinegrade.files.cell_text import trim
from kinegrade.files.rows.row import Row
from kinegrade.files.tables import Table
from kinegrade.language.message import Fault, Message
from kinegrade.lms.responses.forms.form_rows import form_rows
from kinegrade.lms.responses.typed_rows import Attempts, TypedRows

TITLE = Message("responses.wjx")
_NUMBER = "序号"
_END = 1  # the column after it says when it was sent
_QUESTION = re.compile(r"\s*\d+、")
# What stands where nothing was written, and where a question was never shown
_UNANSWERED = frozenset({"(空)", "（空）", "(跳过)", "（跳过）"})


def recognises(header: Sequence[str]) -> bool:
    """Whether the first column is the response's number and questions are numbered as in wjx."""
    return bool(header) and trim(header[0]) == _NUMBER and bool(_questions(header))


def read(table: Table, head: ExamHead, attempts: Attempts) -> TypedRows:
    """The responses in the order of the file. Raises TableError where questions and asks do not
    agree.
    """
    questions = _questions(table.header)
    if not questions:
        raise TableError(Fault(table.file, Message("responses.no-numbers", report=TITLE)))
    answered = replace(table, rows=tuple(map(_blank_unanswered, table.rows)))
    return form_rows(answered, head, questions=questions, known={}, end=_END)


def _blank_unanswered(row: Row) -> Row:
    """The row with nothing in the cells of questions left empty or never shown."""
    return row._replace(
        cells=tuple("" if trim(cell) in _UNANSWERED else cell for cell in row.cells)
    )


def _questions(header: Sequence[str]) -> list[int]:
    return [place for place, name in enumerate(header) if _QUESTION.match(name)]
