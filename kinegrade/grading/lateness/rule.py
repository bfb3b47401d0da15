"""What being late costs, and what it costs to try again: the rules of a policy, and what they take
from a student's points.

`reading` reads them; `grading.totals` subtracts.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime, timedelta
from fractions import Fraction
from typing import Literal, assert_never

from kinegrade.marks_folder.rows import Submission

Per = Literal["hour", "day", "week", "once"]
Base = Literal["maximum", "total"]


@dataclass(frozen=True, slots=True)
class LateRule:
    """A `share` is taken for each begun unit of time after `due`, `most` at most; nothing within
    the `grace`. `extensions` are what some students have in place of the due date.
    """

    due: datetime
    share: Fraction
    per: Per = "day"
    most: Fraction = Fraction(1)
    grace: timedelta = timedelta(0)
    extensions: Mapping[str, datetime] = field(default_factory=dict)

    def find_due(self, student: str) -> datetime:
        """When it is due for a student."""
        return self.extensions.get(student, self.due)

    def find_share(self, late_by: timedelta) -> Fraction:
        """The share that so much time costs."""
        return min(self.most, self.count_units(late_by) * self.share)

    def count_units(self, late_by: timedelta) -> int:
        """How many units of time have begun."""
        if not late_by:
            return 0
        match self.per:
            case "hour":
                return -(-late_by // timedelta(hours=1))
            case "day":
                return -(-late_by // timedelta(days=1))
            case "week":
                return -(-late_by // timedelta(weeks=1))
            case "once":
                return 1
            case _:
                assert_never(self.per)


@dataclass(frozen=True, slots=True)
class TryRule:
    """A `share` is taken for each submission after the first, `most` at most."""

    share: Fraction
    most: Fraction = Fraction(1)

    def find_share(self, before: int) -> Fraction:
        """The share that a submission after so many costs."""
        return min(self.most, before * self.share)


@dataclass(frozen=True, slots=True)
class Penalties:
    """What a policy subtracts, a share of the `base`: the points that could be had, or those that
    were reached. None where it has no such rule.
    """

    late: LateRule | None = None
    tries: TryRule | None = None
    base: Base = "maximum"

    @property
    def are_any(self) -> bool:
        """Whether anything can be subtracted."""
        return self.late is not None or self.tries is not None

    def subtract(self, submission: Submission, total: Fraction, out_of: Fraction) -> Fraction:
        """The points that a submission costs of a total; never more than it has."""
        match self.base:
            case "maximum":
                base = out_of
            case "total":
                base = total
            case _:
                assert_never(self.base)
        return min(total, base * self.find_share(submission))

    def find_share(self, submission: Submission) -> Fraction:
        """The share that a submission costs, for its time and for those before it together."""
        return min(Fraction(1), sum(self.find_shares(submission), Fraction(0)))

    def find_shares(self, submission: Submission) -> tuple[Fraction, Fraction]:
        """The shares that a submission costs for its time, and for those before it."""
        late = self.late.find_share(submission.late_by) if self.late else Fraction(0)
        tries = self.tries.find_share(submission.before) if self.tries else Fraction(0)
        return late, tries


NO_PENALTIES = Penalties()
