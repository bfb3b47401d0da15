"""What a class answered, in numbers: a row for each student in the order of the roster."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from kinegrade.files.tables import Complaint
from kinegrade.grading.fast.bounds import Flags, Numbers
from kinegrade.language.message import Message


@dataclass(frozen=True)
class ClassAnswers:
    """The `numbers` by row and ask, NaN where there is none, which of them are `right` or void, and
    the file and line of each row, 0 where it has none.
    """

    numbers: Numbers
    right: Flags
    files: Sequence[str]
    lines: Sequence[int]

    def complain(self, row: int, problem: Message, done: Message) -> Complaint:
        """A complaint of a whole row."""
        return Complaint(self.files[row], self.lines[row] or None, "", "", problem, done)
