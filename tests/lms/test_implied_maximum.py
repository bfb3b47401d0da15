"""The maximum that follows from points beside per cent."""

from __future__ import annotations

from fractions import Fraction

import pytest

from kinegrade.lms.grades.implied_maximum import implied_maximum


@pytest.mark.parametrize(
    ("told", "maximum"),
    [
        ("2.94 29.41; 5.29 52.94", "10"),
        ("1 2.94; 34 100", "34"),
        ("7.25 69.05", "10.5"),
        ("41.2 41.2", "100"),
        ("", None),
        ("0 0", None),
        ("0.10 0.98", None),  # 9.6 to 10.7: too wide to tell
        ("3 32.03", None),  # 9.37: no maximum that is usual
        ("2.94 29.41; 2.94 14.71", None),  # they do not agree
    ],
)
def test_points_beside_per_cent(told: str, maximum: str | None) -> None:
    pairs = [tuple(map(Fraction, pair.split())) for pair in told.split(";") if pair.strip()]
    assert implied_maximum((points, share) for points, share in pairs) == (
        maximum and Fraction(maximum)
    )
