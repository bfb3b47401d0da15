"""A plain sheet for systems whose format is not known: id, name, grade and comment, in UTF-8 with a
byte-order mark.

The mark makes spreadsheets show Chinese names. Columns are mapped, or copied, by hand, so the
headers are in the language of the exam.
"""

from __future__ import annotations

from kinegrade.language import Language
from kinegrade.lms.dialect import Column, Dialect, NewFile

_GENERIC_ENGLISH = Dialect(
    name="the generic sheet",
    places=4,
    new_file=NewFile(
        columns=(
            Column("Student ID", "id"),
            Column("E-mail", "email"),
            Column("Name", "name"),
            Column("{title}", "grade"),
            Column("Comment", "feedback"),
        ),
        key="id",
        title="Grade",
        mark=True,
    ),
)
GENERIC_CHINESE = Dialect(
    name="the generic sheet",
    places=4,
    new_file=NewFile(
        columns=(
            Column("学号", "id"),
            Column("邮箱", "email"),
            Column("姓名", "name"),
            Column("{title}", "grade"),
            Column("评语", "feedback"),
        ),
        key="id",
        title="成绩",
        mark=True,
    ),
)


def generic(language: Language) -> Dialect:
    """The sheet with headers in a language."""
    return {"en": _GENERIC_ENGLISH, "zh": GENERIC_CHINESE}[language]
