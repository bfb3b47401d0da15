"""What lateness and further tries cost."""

from __future__ import annotations

from datetime import timedelta
from fractions import Fraction

import pytest

from kinegrade.deadlines.moment import read_moment
from kinegrade.grading.lateness.rule import LateRule, Penalties, TryRule
from kinegrade.marks_folder.rows import Submission
from tests.grading.late_submissions.late_exam import DAY, DUE


@pytest.mark.parametrize(
    ("late_by", "share"),
    [(0, 0), (1, 1), (24 * 60, 1), (24 * 60 + 1, 2), (5 * 24 * 60, 5), (400 * 24 * 60, 10)],
)
def test_each_begun_day_costs_its_share_and_never_more_than_all(late_by: int, share: int) -> None:
    rule = LateRule(read_moment(DUE), Fraction(1, 10))
    assert rule.find_share(timedelta(minutes=late_by)) == Fraction(share, 10)


@pytest.mark.parametrize(("per", "units"), [("hour", 49), ("day", 3), ("week", 1), ("once", 1)])
def test_time_is_counted_by_its_unit(per: str, units: int) -> None:
    rule = LateRule(read_moment(DUE), Fraction(1, 100), per)  # type: ignore[arg-type]
    assert rule.count_units(2 * DAY + timedelta(seconds=1)) == units


def test_a_penalty_is_of_the_maximum_or_of_what_was_reached_and_takes_no_more_than_that() -> None:
    late = LateRule(read_moment(DUE), Fraction(1, 2), most=Fraction(3, 4))
    submission = Submission(late_by=DAY)
    assert Penalties(late).subtract(submission, Fraction(4), Fraction(10)) == 4
    assert Penalties(late).subtract(submission, Fraction(8), Fraction(10)) == 5
    assert Penalties(late, base="total").subtract(submission, Fraction(8), Fraction(10)) == 4
    assert late.find_share(3 * DAY) == Fraction(3, 4)


def test_tries_and_lateness_add_up_to_all_at_most() -> None:
    penalties = Penalties(
        LateRule(read_moment(DUE), Fraction(1, 2)), TryRule(Fraction(1, 5), Fraction(2, 5))
    )
    assert penalties.find_share(Submission(before=1)) == Fraction(1, 5)
    assert penalties.find_share(Submission(before=9)) == Fraction(2, 5)
    assert penalties.find_share(Submission(late_by=DAY, before=1)) == Fraction(7, 10)
    assert penalties.find_share(Submission(late_by=2 * DAY, before=1)) == 1
