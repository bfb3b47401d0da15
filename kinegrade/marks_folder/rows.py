"""The rows of a marks folder's files, typed: texts as they were before they were made safe for
spreadsheets, amounts as exact numbers.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime, timedelta
from fractions import Fraction
from functools import cached_property

import msgspec

from kinegrade.ask_names import Named
from kinegrade.language.message import Text
from kinegrade.marks_folder.hand_marks import BY_HAND, HandMark, work_out_total
from kinegrade.marks_folder.layout import Status

_ABSENT: Status = "absent"
Put = Mapping[str, Mapping[str, str]]  # whose line of the key, by student and answer column
Orders = Mapping[str, tuple[str, ...]]  # the questions as printed, by student


class MarkedAnswer(msgspec.Struct, frozen=True, gc=False):  # there are many
    """One line of marks.csv; `read_as` is in plain digits and in `unit`. Both are empty where
    nothing was read.

    `mistakes` are the known mistakes that lead to the answer, the likeliest first, where the
    verdict is that there are some; `by_policy` is whether the rule was not the paper's. All of this
    is the machine's; the points are those of the mark `by_hand` where there is one.
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
    mistakes: tuple[str, ...] = ()
    by_policy: bool = False
    by_hand: HandMark | None = None

    @property
    def column(self) -> str:
        """Its column in the answer sheet; the question where all of it is meant."""
        return Named(self.question, self.ask).column

    @property
    def worth(self) -> tuple[Fraction, Fraction]:
        """The points, and the maximum."""
        return self.points, self.out_of

    @property
    def judged(self) -> str:
        """The verdict that stands: the machine's, or that a hand marked it."""
        return BY_HAND if self.by_hand else self.verdict

    @property
    def reason_given(self) -> str:
        """Why it has these points: by the machine, or by the hand that marked it."""
        return self.by_hand.comment if self.by_hand else self.reason


@dataclass(frozen=True, slots=True)
class KeptTotal:
    """One line of kept.csv: a student whose earlier total stands, and the total by the new marking
    alone.
    """

    student: str
    name: str
    reason: Text
    before: Fraction
    before_out_of: Fraction
    by_this_marking: Fraction
    out_of: Fraction
    stands: Fraction


@dataclass(frozen=True, slots=True)
class Submission:
    """One of a student's submissions: when it was handed in and when it was due, None where that is
    not known; `late_by` is zero in time and within the grace; `before` is how many came before it.
    """

    submitted: datetime | None = None
    due: datetime | None = None
    late_by: timedelta = timedelta(0)
    before: int = 0


@dataclass(frozen=True, slots=True)
class Subtracted:
    """One line of subtracted.csv: the points taken from a student's total for being late and for
    trying again, and the shares that these cost.
    """

    student: str
    name: str
    submission: Submission
    points: Fraction
    late_share: Fraction = Fraction(0)
    tries_share: Fraction = Fraction(0)


def _find_share(total: Fraction, out_of: Fraction) -> Fraction:
    return total / out_of if out_of else Fraction(0)


class Grade(msgspec.Struct, frozen=True, gc=False):  # there are many
    """One line of grades.csv as it is written: a student's points for each question of the exam,
    None for an alternative that the paper does not hold, and the total.

    `kept` is the total that stands instead of the sum, where an earlier one was higher and no total
    may fall. A student who is `absent` answered nothing at all. `grade` is that of the total,
    "" where there is no scale. What its `submission` costs is `subtracted` from the points; it is
    None where nothing is.
    """

    student: str
    name: str
    points: tuple[Fraction | None, ...]
    out_of: Fraction
    kept: Fraction | None = None
    absent: bool = False
    grade: str = ""
    submission: Submission | None = None
    subtracted: Fraction = Fraction(0)

    @property
    def total(self) -> Fraction:
        """The sum of the points without what is subtracted, or the total that was kept."""
        if self.kept is not None:
            return self.kept
        points = work_out_total(each for each in self.points if each is not None)
        return points - self.subtracted if self.subtracted else points

    @property
    def share(self) -> Fraction:
        """The total as a share of the maximum; 0 where there are no points to get."""
        return _find_share(self.total, self.out_of)

    @property
    def percent(self) -> Fraction:
        """The total as a percentage of the maximum; 0 where there are no points to get."""
        return 100 * self.share


class StudentTotal(msgspec.Struct, frozen=True, gc=False):  # there are many
    """One line of grades.csv as it is read; `kept` is the student's line of kept.csv.

    `points` are those of the questions that the paper holds, `line` is its line number. `percent`
    is None where the column was left out, `status` in folders of earlier versions; `grade` is ""
    where no scale was stated.
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
    grade: str = ""
    subtracted: Fraction = Fraction(0)

    @property
    def is_present(self) -> bool:
        """Whether the total is one of a student who was there, or an earlier one that stands."""
        return self.status != _ABSENT or self.kept is not None

    @property
    def worth(self) -> tuple[Fraction, Fraction]:
        """The points, and the maximum."""
        return self.total, self.out_of

    @property
    def share(self) -> Fraction:
        """The total as a share of the maximum; 0 where there are no points to get."""
        return _find_share(self.total, self.out_of)


@dataclass(frozen=True)
class ClassTotals:
    """All of grades.csv, in the order of the file."""

    questions: tuple[str, ...]
    students: tuple[StudentTotal, ...]

    @cached_property
    def by_student(self) -> Mapping[str, StudentTotal]:
        """Every student's total, in the order of the file."""
        return {each.student: each for each in self.students}


@dataclass(frozen=True)
class QuestionSums:
    """Amounts added up by question, and of how many lines; students with the same amounts share
    them.
    """

    by_question: Mapping[str, Fraction]
    counts: Mapping[str, int]

    @cached_property
    def total(self) -> Fraction:
        """The sum of all."""
        return work_out_total(self.by_question.values())

    @cached_property
    def lines(self) -> int:
        """How many lines they are."""
        return sum(self.counts.values())


class StudentSums(msgspec.Struct, frozen=True, gc=False):  # there are many
    """The sums of one student's lines in marks.csv, with marks by hand in their place; `line` is
    the line number of the last.

    `answered` is whether anything other than blanks and dashes was typed, or marked by hand,
    `bonus` what could be had on top of the maximum; `by_hand` is whether marks by hand are in it.
    """

    line: int
    student: str
    points: QuestionSums
    out_of: QuestionSums
    answered: bool
    bonus: Fraction = Fraction(0)
    by_hand: bool = False

    @property
    def total_out_of(self) -> Fraction:
        """The maximum, without the bonus."""
        return self.out_of.total - self.bonus
