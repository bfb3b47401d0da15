"""Moodle: the gradebook's CSV import (Grades > Import > CSV file) and the assignment's offline
grading worksheet.

In Moodle map "ID number" to the profile field of that name, "Grade" to a grade item whose maximum
is the exam's points, and "Feedback" to the feedback of that item. Moodle compares ids as texts,
takes a file whole or not at all, and replaces a grade by an empty one: so ids are written exactly,
and students who handed in nothing are left out. The headers of a downloaded gradebook are in the
language of the person who downloads it, so its columns are found by their content.
"""

from __future__ import annotations

import re

from kinegrade.lms.grades.dialect import (
    Channel,
    Column,
    Dialect,
    Download,
    ItemWords,
    Key,
    NewFile,
)

_KEYS = (
    Key("id", ("ID number", "ID-Nummer", "学号")),
    Key("email", ("Email address", "E-Mail-Adresse", "Email地址"), ignores_case=True),
    Key("login", ("Username",), ignores_case=True),
)
_WORDS: ItemWords = {
    "points": ("Real", "Punkte", "Brut", "Punteggio", "Echt", "分数", "実データ"),
    "percentage": ("Percentage", "Prozentsatz", "Pourcentage", "Porcentaje", "百分比"),
    "feedback": ("Feedback", "Rückmeldung", "反馈"),
}

MOODLE = Dialect(
    name="Moodle",
    places=5,
    downloads=(
        Download(
            keys=_KEYS,
            item=re.compile(r"(?P<title>Grade)"),
            required=("Identifier", "Grade", "Last modified (grade)"),
            maximum_column="Maximum grade",
            locked=("Grade can be changed", "No"),
            channel=Channel(("Feedback comments",), html=True),
        ),
        Download(
            keys=_KEYS,
            item=re.compile(r"(?P<title>.*\S)\s*\(.*\)"),
            any_item=True,
            item_words=_WORDS,
            channel=Channel((), html=True),
        ),
    ),
    new_file=NewFile(
        columns=(
            Column("ID number", "id"),
            Column("Email address", "email"),
            Column("Username", "login"),
            Column("Full name", "name"),
            Column("{title}", "grade"),
            Column("Feedback", "feedback", html=True),
        ),
        key="id",
        title="Grade",
    ),
)
