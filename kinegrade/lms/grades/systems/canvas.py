"""Canvas (Grades > Export, Import): UTF-8 without a byte-order mark.

An assignment is identified by the number in its header, "Title (1234)", and students by their SIS
ids. The column ID holds Canvas's internal numbers: a student number there could belong to another
student, so it is left empty. At many institutions the login is the e-mail address. Canvas falls
back on names, so the names in a new file contain the id and are not the students' real names.
"Student, Test" is the test student of the teacher's student view.
"""

from __future__ import annotations

import re

from kinegrade.language.message import Message
from kinegrade.lms.grades.dialect import Column, Dialect, Download, Key, NewFile

_IGNORED = re.compile(r"(?:Current|Final) (?:Score|Points|Grade)|Override (?:Score|Grade|Status)")

CANVAS = Dialect(
    name="Canvas",
    places=2,
    downloads=(
        Download(
            keys=(
                Key("id", ("SIS User ID",)),
                Key("login", ("SIS Login ID",)),
                Key("email", ("SIS Login ID",), ignores_case=True),
            ),
            item=re.compile(r"(?P<title>.*)\s\([0-9]+\)"),
            not_item=_IGNORED,
            maximum_row=re.compile(r".*Points Possible"),
            read_only=re.compile(r"read\s+only"),
            skipped_row=re.compile(
                r"\s*(?:(?:Muted|Manual Posting.*)?\s*$|.*Points Possible)", re.IGNORECASE
            ),
            closed={"EX": Message("grades.excused"), "N/A": Message("grades.not-assigned")},
            encodings=("UTF-8",),
            beginning=re.compile(
                r"(?:Student|LastName,FirstName),ID(?:,SIS User ID,SIS Login ID(?:,Integration ID)?"
                r"(?:,Root Account)?|,SIS Login ID)?,Section,"
            ),
            broken_beginning=re.compile('\ufeff(?:"|LastName)'),
            misread=re.compile(r"-?[0-9]{1,3}(?:,[0-9]{3})+"),
            test_person=re.compile(r"Student, Test(?:, |$)"),
        ),
    ),
    new_file=NewFile(
        columns=(
            Column("Student", "name and id"),
            Column("ID", "fixed"),
            Column("SIS User ID", "id"),
            Column("SIS Login ID", "login", also=("email",)),
            Column("Section", "fixed"),
            Column("{title}", "grade"),
        ),
        key="id",
        keeps_keys=True,
        unfit=(
            (_IGNORED, Message("grades.canvas-ignores")),
            (
                re.compile(r"\s\([0-9]+\)$"),
                Message("grades.canvas-number"),
            ),
        ),
    ),
)
