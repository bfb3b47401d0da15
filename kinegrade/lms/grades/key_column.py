"""A column that says whose row it is."""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.files.cell_text import trim
from kinegrade.lms.grades.cells import Record
from kinegrade.lms.grades.dialect import Key
from kinegrade.lms.grades.grades import StudentGrade, known_as


@dataclass(frozen=True, slots=True)
class KeyColumn:
    """A key of the system and the place of its column in the file."""

    key: Key
    place: int

    def value(self, row: Record) -> str:
        """The row's value, as the system compares it."""
        text = trim(row.cells[self.place].text)
        return self.compared(text.removeprefix(self.key.prefix) if self.key.prefix else text)

    def wanted(self, grade: StudentGrade) -> str:
        """The value that a student's row must have; empty where that is not known."""
        return self.compared(known_as(grade, self.key.field))

    def compared(self, text: str) -> str:
        """A value as the system compares it."""
        return text.casefold() if self.key.ignores_case else text
