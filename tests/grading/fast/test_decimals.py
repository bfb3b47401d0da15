"""Differences of decimals in doubles are those of exact numbers, or are not known."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.grading.fast.decimals import find_differences
from kinegrade.numbers.decimals import FEW_DIGITS

DIGITS = st.one_of(st.integers(0, 999), st.integers(0, 10**9), st.integers(0, 10**FEW_DIGITS - 1))
DECIMALS = st.builds(
    lambda digits, sign, power: f"{sign}{digits}e{power}",
    DIGITS,
    st.sampled_from(["", "-"]),
    st.integers(-18, 4),
)


@given(st.lists(st.tuples(DECIMALS, DECIMALS), min_size=1, max_size=20))
def test_a_known_difference_is_rightly_rounded(pairs: list[tuple[str, str]]) -> None:
    some, others = (np.array([float(each) for each in side]) for side in zip(*pairs, strict=True))
    differences, known = find_differences(some, others)
    for place in np.flatnonzero(known).tolist():
        first, second = map(Fraction, pairs[place])
        assert differences[place] == float(abs(first - second))


def test_everyday_decimals_are_known() -> None:
    some, others = np.array([13.5, 0.5, -1.62, 2e3]), np.array([13.5, -3.8240653, 0.972, 0.00125])
    assert find_differences(some, others)[1].all()
