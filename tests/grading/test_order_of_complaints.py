"""What is said first of a class: of whole files as they were read, as it may explain the rest."""

from __future__ import annotations

from dataclasses import replace

from kinegrade.files.answer_file import AnswerFile
from kinegrade.files.tables import Complaint, parse_table
from kinegrade.grading.misplaced.typing_slips import put_after


def test_what_is_said_of_a_whole_file_stands_before_what_follows_from_it() -> None:
    file, row, missing, slip = (
        Complaint("a.csv", line, "", "", problem, "")
        for line, problem in ((None, "file"), (2, "row"), (None, "missing"), (None, "slip"))
    )
    table = replace(parse_table(b"student\n7\n", "a.csv"), complaints=(file, row))
    told = put_after([AnswerFile(table)], [slip], (file, missing, row))
    assert told == (file, slip, missing, row)
