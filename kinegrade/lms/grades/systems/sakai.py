"""Sakai (Gradebook > Import): the first column is the login, the second the name, whatever their
headers.

Without a byte-order mark Sakai reads Windows-1252. "Title [10]" is an item of 10 points, "* Title"
the comment on it, "# ..." is ignored. Where the file is separated by semicolons, Sakai expects a
decimal comma.
"""

from __future__ import annotations

import re

from kinegrade.language.message import Message
from kinegrade.lms.grades.dialect import Channel, Column, Dialect, Download, Key, NewFile

SAKAI = Dialect(
    name="Sakai",
    places=2,
    downloads=(
        Download(
            keys=(Key("login", position=0), Key("id", position=0)),
            item=re.compile(
                r"(?P<title>[^#*\[][^\[]*?)\s*(?:\[(?P<maximum>[0-9]+(?:[.,][0-9]{1,2})?)\])?"
            ),
            first_item=2,
            channel=Channel(("* {title}",)),
            decimal_comma_with_semicolon=True,
        ),
    ),
    new_file=NewFile(
        columns=(
            Column("Student ID", "login"),
            Column("Student Name", "name"),
            Column("{title} [{maximum}]", "grade"),
            Column("* {title}", "feedback"),
        ),
        key="login",
        mark=True,
        unfit=(
            (re.compile(r"\["), Message("grades.sakai-bracket")),
            (
                re.compile(r"\s*[#*]"),
                Message("grades.sakai-signs"),
            ),
        ),
    ),
)
