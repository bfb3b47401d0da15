"""Blackboard Learn (Grade Center > Work Offline): a column is identified by the id after the bar in
its header.

A column without an id would become a new text column without points, so a new file needs the header
from Blackboard. Its downloads are comma or tab separated, in UTF-8 or UTF-16, and are written back
in the same form.
"""

from __future__ import annotations

import re

from kinegrade.lms.grades.dialect import Channel, Column, Dialect, Download, Key, NewFile

BLACKBOARD = Dialect(
    name="Blackboard",
    places=4,
    downloads=(
        Download(
            keys=(Key("login", ("Username",)), Key("id", ("Student ID",))),
            item=re.compile(
                r"(?P<title>.*) \[Total Pts: (?P<maximum>[0-9.,]+)(?: Score)?\] \|[0-9]+"
            ),
            channel=Channel(
                ("Feedback to Learner",), format_header="Feedback Format", format_text="PLAIN_TEXT"
            ),
        ),
    ),
    new_file=NewFile(
        columns=(
            Column("Username", "login"),
            Column("Student ID", "id"),
            Column("{title}", "grade"),
            Column("Feedback to Learner", "feedback"),
            Column("Feedback Format", "feedback format", "PLAIN_TEXT"),
        ),
        key="login",
        quotes_all=True,
        header_needed=True,
    ),
)
