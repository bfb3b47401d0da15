"""A plain sheet for systems whose format is not known: id, name, grade and comment, in UTF-8 with a
byte-order mark.

The mark makes spreadsheets show Chinese names. Columns are mapped, or copied, by hand, so the
headers are in the language of the exam.
"""

from __future__ import annotations

from kinegrade.language.message import Message
from kinegrade.lms.grades.dialect import Column, Dialect, NewFile

GENERIC = Dialect(
    name=Message("grades.generic-sheet"),
    places=4,
    new_file=NewFile(
        columns=(
            Column(Message("grades.column-id"), "id"),
            Column(Message("grades.column-email"), "email"),
            Column(Message("grades.column-name"), "name"),
            Column("{title}", "grade"),
            Column(Message("grades.column-scale-grade"), "letter"),
            Column(Message("grades.column-comment"), "feedback"),
        ),
        key="id",
        title=Message("grades.column-grade"),
        mark=True,
    ),
)
