"""Responses of a Google form: a timestamp, the e-mail address where it is collected, the score of a
quiz, then the questions.
"""

from __future__ import annotations

from collections.abc import Sequence

from kinegrade.exam.folder.records import ExamHead
from kinegrade.files.cell_text import make_header_key
from kinegrade.files.tables import Table
from kinegrade.language.message import Message
from kinegrade.language.spellings import list_spellings
from kinegrade.lms.responses.forms.form_rows import form_rows
from kinegrade.lms.responses.typed_rows import Attempts, TypedRows

TITLE = Message("responses.google-forms")
_TIMESTAMP = Message("responses.titles-of-timestamps")
_ADDRESS = ("email address", "username")
_SCORE = "score"


def recognises(header: Sequence[str]) -> bool:
    """Whether the first column is the timestamp, by its name in a known language."""
    return bool(header) and make_header_key(header[0]) in list_spellings(_TIMESTAMP)


def read(table: Table, head: ExamHead, attempts: Attempts) -> TypedRows:
    """The responses in the order of the file. The first column is the timestamp, in any language.

    Raises TableError where questions and asks do not agree.
    """
    keys = [make_header_key(name) for name in table.header[:3]]
    address = [place for place in (1, 2) if place < len(keys) and keys[place] in _ADDRESS][:1]
    score = [place for place in (1, 2) if place < len(keys) and keys[place] == _SCORE][:1]
    questions = [place for place in range(1, len(table.header)) if place not in {*address, *score}]
    return form_rows(table, head, questions=questions, known={"email": address}, end=0)
