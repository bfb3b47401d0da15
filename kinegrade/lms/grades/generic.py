"""A plain sheet for systems whose format is not known: id, name, grade and comment, in UTF-8 with a
byte-order mark.

The mark makes spreadsheets show Chinese names. Columns are mapped, or copied, by hand, so the
headers are in the language of the exam.
"""

from __future__ import annotations

from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Message
from kinegrade.lms.grades.dialect import Column, Dialect, NewFile


def generic(language: Language) -> Dialect:
    """The sheet with headers in a language."""
    words = open_catalogue(language)
    return Dialect(
        name=Message("grades.generic-sheet"),
        places=4,
        new_file=NewFile(
            columns=(
                Column(words.text("grades.column-id"), "id"),
                Column(words.text("grades.column-email"), "email"),
                Column(words.text("grades.column-name"), "name"),
                Column("{title}", "grade"),
                Column(words.text("grades.column-comment"), "feedback"),
            ),
            key="id",
            title=words.text("grades.column-grade"),
            mark=True,
        ),
    )
