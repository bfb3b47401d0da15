"""Points by hand that are written as fractions."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.grading.by_hand.hand_marking import ADA, SOFYA, faults, give
from tests.small_class import table


@pytest.mark.parametrize(
    ("typed", "points"),
    [("1/2", "0.5"), ("½", "0.5"), ("1 1/2", "1.5"), ("1½", "1.5"), ("3/2", "1.5"), ("0/4", "0")],
)
def test_points_may_be_written_as_a_fraction(folder: Path, typed: str, points: str) -> None:
    """1/2 was no number; of 1½ the sign stands for 1/2 and not for 11/2."""
    given = give(folder, f"{ADA},q2,{typed},\n{SOFYA},q2,1,\n")
    assert given.exit_code == 0, given.stderr
    marks = {row["student"]: row["points"] for row in table(folder / "MARKS" / "manual.csv")}
    assert marks == {ADA: points, SOFYA: "1"}


def test_a_fraction_that_may_be_so_many_of_the_points_is_asked_about(folder: Path) -> None:
    two = give(folder, f"{ADA},q3,3/4,\n{SOFYA},q1,1/3,\n{SOFYA},q2,1/3,\n")
    write = "write the points as one number"
    assert faults(two, folder) == [
        f'by-hand.csv:2: q3: "3/4" may be 0.75 points, or 3 of 4 - {write}',
        f'by-hand.csv:3: q1: "1/3" may be 0.3333 points, or 1 of 3 - {write}',
        'by-hand.csv:4: q2: points are "1/3" '
        "- expected a number of zero or more with at most 4 decimals",
    ]
