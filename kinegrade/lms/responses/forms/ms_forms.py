"""Responses of a Microsoft form: ID, start and completion time, Email, Name, then the questions,
each with its points.

The ID is the number of the response, not of a student. Email is "anonymous" where the form needs no
sign-in.
"""

from __future__ import annotations

from collections.abc import Sequence

from kinegrade.exam.folder.records import ExamHead
from kinegrade.files.cell_text import make_header_key
from kinegrade.files.tables import Table
from kinegrade.language.message import Message
from kinegrade.lms.responses.forms.form_rows import form_rows
from kinegrade.lms.responses.typed_rows import Attempts, TypedRows

TITLE = Message("responses.ms-forms")
_FIRST = ("id", "start time", "completion time", "email", "name")
_END = _FIRST.index("completion time")
_ADDRESS = _FIRST.index("email")
_BETWEEN = ("total points", "quiz feedback", "last modified time")


def recognises(header: Sequence[str]) -> bool:
    """Whether these are the first columns of such a file, by their English names."""
    return tuple(map(make_header_key, header[: len(_FIRST)])) == _FIRST


def read(table: Table, head: ExamHead, attempts: Attempts) -> TypedRows:
    """The responses in the order of the file. The first five columns are the form's, in any
    language.

    Raises TableError where questions and asks do not agree.
    """
    questions = [
        place
        for place in range(len(_FIRST), len(table.header))
        if make_header_key(table.header[place]) not in _BETWEEN
    ]
    return form_rows(table, head, questions=questions, known={"email": [_ADDRESS]}, end=_END)
