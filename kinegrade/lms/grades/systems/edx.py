"""Open edX (bulk grades): its export filled in, either of staff graded points or of subsection
overrides.

Rows are identified by edX's user and block ids, so no file can be written from scratch.
"""

from __future__ import annotations

import re

from kinegrade.lms.grades.dialect import Dialect, Download, Key

_LOGIN = Key("login", ("username",))

EDX = Dialect(
    name="Open edX",
    places=4,
    downloads=(
        Download(
            keys=(Key("id", ("student_uid",)), _LOGIN),
            item=re.compile(r"(?P<title>New Points)"),
            required=("user_id", "block_id", "Previous Points", "New Points"),
            encodings=("UTF-8",),
            most_bytes=4 * 1024 * 1024,
        ),
        Download(
            keys=(Key("id", ("student_key",)), _LOGIN),
            item=re.compile(r"(?P<title>new_override-.+)"),
            required=("user_id", "course_id"),
            encodings=("UTF-8",),
        ),
    ),
)
