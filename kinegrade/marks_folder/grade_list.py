"""The grades of a class in columns: students who have the same points share a pattern, so that each
is worked out and written once.
"""

from __future__ import annotations

from array import array
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import overload

import msgspec

from kinegrade.marks_folder.rows import Grade


@dataclass(frozen=True, eq=False)
class GradeList(Sequence[Grade]):
    """The grade of each student: one of the `patterns`, whatever student it names, by its number.

    >>> from fractions import Fraction
    >>> [each.student for each in GradeList(["7", "8"], ["Ann", ""], [0, 0],
    ...                                     [Grade("", "", (), Fraction(3))])]
    ['7', '8']
    """

    students: Sequence[str]
    names: Sequence[str]
    which: Sequence[int]
    patterns: Sequence[Grade]

    @classmethod
    def of(cls, grades: Sequence[Grade]) -> GradeList:
        """These grades, none of which shares anything."""
        students, names = [each.student for each in grades], [each.name for each in grades]
        return cls(students, names, range(len(grades)), grades)

    @classmethod
    def joined(cls, parts: Iterable[GradeList]) -> GradeList:
        """Lists that share their patterns, one behind the other."""
        students: list[str] = []
        names: list[str] = []
        which = array("L")
        patterns: Sequence[Grade] = ()
        for part in parts:
            students += part.students
            names += part.names
            which.extend(part.which)
            patterns = part.patterns
        return cls(students, names, which, patterns)

    def __len__(self) -> int:
        return len(self.which)

    @overload
    def __getitem__(self, place: int) -> Grade: ...

    @overload
    def __getitem__(self, place: slice) -> GradeList: ...

    def __getitem__(self, place: int | slice) -> Grade | GradeList:
        if isinstance(place, slice):
            part = self.students[place], self.names[place], self.which[place]
            return GradeList(*part, self.patterns)
        return msgspec.structs.replace(
            self.patterns[self.which[place]],
            student=self.students[place],
            name=self.names[place],
        )

    def __eq__(self, other: object) -> bool:
        return isinstance(other, GradeList) and [*self] == [*other]

    __hash__ = None  # type: ignore[assignment]

    def changed(self, change: Callable[[Grade], Grade]) -> GradeList:
        """These grades changed in the same way, whatever student they name."""
        patterns = [*map(change, self.patterns)]
        return GradeList(self.students, self.names, self.which, patterns)

    def without_names(self) -> GradeList:
        """These grades of students without names."""
        return GradeList(self.students, [""] * len(self), self.which, self.patterns)

    def write(self, write: Callable[[Grade], str]) -> Sequence[str]:
        """A text for each grade that depends on its pattern alone."""
        texts = [*map(write, self.patterns)]
        return [texts[number] for number in self.which]
