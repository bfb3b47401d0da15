"""D2L Brightspace (Grades > Enter Grades > Import): ids follow "#", and a last column with "#" ends
the line.

The "#" keeps a spreadsheet from dropping leading zeros and a trailing empty grade. A header states
the item's maximum, "Title Points Grade <Numeric MaxPoints:10>", and creates the item where there is
none.
"""

from __future__ import annotations

import re

from kinegrade.language.message import Message
from kinegrade.lms.grades.dialect import Column, Dialect, Download, Key, NewFile

BRIGHTSPACE = Dialect(
    name="Brightspace",
    places=4,
    downloads=(
        Download(
            keys=(
                Key("id", ("OrgDefinedId",), prefix="#"),
                Key("login", ("Username",), prefix="#"),
            ),
            item=re.compile(
                r"(?P<title>.*) Points Grade(?: <(?:Numeric "
                r")?(?:[^>]*\b)?MaxPoints:(?P<maximum>[0-9.,]+)[^>]*>| <[^>]*>)?"
            ),
            encodings=("UTF-8",),
        ),
    ),
    new_file=NewFile(
        columns=(
            Column("OrgDefinedId", "id", "#"),
            Column("Username", "login", "#"),
            Column("{title} Points Grade <Numeric MaxPoints:{maximum}>", "grade"),
            Column("End-of-Line Indicator", "fixed", "#"),
        ),
        key="id",
        mark=True,
        unfit=((re.compile(r"[<>]"), Message("grades.brightspace-brackets")),),
    ),
)
