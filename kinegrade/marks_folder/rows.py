"""The rows of a marks folder's files, typed: cells are given as they were before they were made
safe for spreadsheets, amounts as exact numbers.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from kinegrade.amounts import added

Put = Mapping[str, Mapping[str, str]]  # by student and answer column, whose line of the key
Orders = Mapping[str, tuple[str, ...]]  # by student, the questions as they were printed


@dataclass(frozen=True, slots=True)
class MarkedAnswer:
    """One line of marks.csv; `read_as` is in plain digits and in `unit`, both empty where nothing
    was read.
    """

    student: str
    question: str
    ask: str
    typed: str
    read_as: str
    unit: str
    verdict: str
    points: Fraction
    out_of: Fraction
    reason: str

    @property
    def column(self) -> str:
        """Its column in the answer sheet."""
        return f"{self.question}.{self.ask}"

    @property
    def worth(self) -> tuple[Fraction, Fraction]:
        """The points, and out of how many."""
        return self.points, self.out_of


@dataclass(frozen=True, slots=True)
class KeptTotal:
    """One line of kept.csv: a student whose earlier total stands, and the one by the new marking
    alone.
    """

    student: str
    name: str
    reason: str
    before: Fraction
    before_out_of: Fraction
    by_this_marking: Fraction
    out_of: Fraction
    stands: Fraction


@dataclass(frozen=True, slots=True)
class Grade:
    """One line of grades.csv as it is written: a student's points for each question, in the order
    of the paper, and in all.

    `kept` is the total that stands instead of the sum, where an earlier one was higher and no total
    is to fall. Who is `absent` answered nothing at all.
    """

    student: str
    name: str
    points: tuple[Fraction, ...]
    out_of: Fraction
    kept: Fraction | None = None
    absent: bool = False

    @property
    def total(self) -> Fraction:
        """All points, or what was kept."""
        return added(self.points) if self.kept is None else self.kept

    @property
    def percent(self) -> Fraction:
        """Of the points there are; 0 where there are none."""
        return 100 * self.total / self.out_of if self.out_of else Fraction(0)


@dataclass(frozen=True, slots=True)
class StudentTotal:
    """One line of grades.csv as it is read; `kept` is what kept.csv says of the student.

    `line` is where it stands. `percent` is None where the column was left out, `status` in
    folders of earlier versions.
    """

    line: int
    student: str
    name: str
    points: Mapping[str, Fraction]
    total: Fraction
    out_of: Fraction
    percent: Fraction | None
    status: str | None
    kept: KeptTotal | None

    @property
    def worth(self) -> tuple[Fraction, Fraction]:
        """The points, and out of how many."""
        return self.total, self.out_of

    @property
    def share(self) -> Fraction:
        """Of the points there are; 0 where there are none."""
        return self.total / self.out_of if self.out_of else Fraction(0)


@dataclass(frozen=True)
class ClassTotals:
    """All of grades.csv, in its order."""

    questions: tuple[str, ...]
    students: tuple[StudentTotal, ...]

    @cached_property
    def by_student(self) -> Mapping[str, StudentTotal]:
        """Everybody's total, in the order of the file."""
        return {each.student: each for each in self.students}


@dataclass(frozen=True, slots=True)
class StudentSums:
    """What one student's lines of marks.csv add up to, by question; `lines` counts them, and the
    last stands at `line`.

    `answered` is whether anything besides blanks and dashes was typed.
    """

    line: int
    student: str
    points: Mapping[str, Fraction]
    out_of: Mapping[str, Fraction]
    lines: Mapping[str, int]
    answered: bool

    @property
    def total(self) -> Fraction:
        """All points."""
        return added(self.points.values())

    @property
    def total_out_of(self) -> Fraction:
        """All points there are."""
        return added(self.out_of.values())
