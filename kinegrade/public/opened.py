"""A path in place of what is read from it: the likeliest slip of a program."""

from __future__ import annotations

from collections.abc import Mapping
from os import PathLike

from kinegrade.errors import OptionError
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.grading.same_key import require_same_key
from kinegrade.language.message import Fault, Message
from kinegrade.marks_folder.folder import MarksFolder

_READERS: Mapping[str, str] = {
    "bank": "kinegrade.Bank.read",
    "roster": "kinegrade.Roster.read",
    "late": "kinegrade.Roster.read",
    "exam": "kinegrade.open_exam",
    "marks": "kinegrade.open_marks",
}


def expect_exam_and_marks(exam: ExamFolder, marks: MarksFolder) -> None:
    """Raises OptionError for a path in place of either, TableError for marks of another
    exam or by another key.
    """
    expect_opened(exam=exam, marks=marks)
    require_same_key(exam, marks)


def expect_opened(**given: object) -> None:
    """Raises OptionError with every argument, by its name, that is a path or a text."""
    faults = [
        Fault(
            name,
            Message("terminal.a-path"),
            do=Message("terminal.read-first", call=f"{_READERS[name]}({str(value)!r})"),
        )
        for name, value in given.items()
        if isinstance(value, str | PathLike)
    ]
    if faults:
        raise OptionError(*faults)
