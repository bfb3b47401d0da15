"""Rules, right answers and typed numbers that put a fast twin to the test: nice numbers and ugly
ones, many of them on a bound or next to it.
"""

from __future__ import annotations

from fractions import Fraction
from math import isfinite

from hypothesis import strategies as st

from kinegrade.numbers.tolerance import Tolerance

SHARES = st.sampled_from([Fraction(0), Fraction(1, 100), Fraction(1, 50), Fraction(1, 3)])
AMOUNTS = st.sampled_from([Fraction(0), Fraction(1, 500), Fraction(1, 20), Fraction(2)])
FIGURES = st.sampled_from([None, 1, 2, 3, 3, 5])
RULES = st.builds(Tolerance, SHARES, AMOUNTS, FIGURES)
# Among them ties of rounding to significant figures, such as 1.235 and 0.00865
_TIES = st.builds(
    lambda digits, power: Fraction(10 * digits + 5) * Fraction(10) ** power,
    st.one_of(st.integers(1, 9), st.integers(10, 99), st.integers(100, 999)),
    st.integers(-7, 3),
)
VALUES = st.one_of(
    st.fractions(-60, 60, max_denominator=30),
    st.decimals(-1000, 1000, allow_nan=False, places=12).map(Fraction),
    _TIES,
)
# Differences of seven digits, the last of which is rounded away
_HALVES = st.builds(
    lambda digits, power: Fraction(10 * digits + 5) * Fraction(10) ** power,
    st.integers(100000, 999999),
    st.integers(-9, -7),
)


@st.composite
def typed_numbers(draw: st.DrawFn, right: Fraction, rule: Tolerance) -> str:
    """Plain digits, as a student types them: the right answer, a bound, next to one, or anything."""
    low, high = rule.interval(right)
    anchors = [right, low, high, low, high, 2 * right, right + draw(_HALVES)]
    step = draw(st.sampled_from([0, 0, 0, Fraction(1, 10**9), Fraction(-1, 10**5)]))
    number = float(draw(st.sampled_from(anchors)) * (1 + step))
    return f"{number:.{draw(st.sampled_from([1, 3, 12, 12]))}f}"


def is_short(number: float, exactly: str | Fraction) -> bool:
    """Whether a double stands for a decimal that is known from it."""
    return isfinite(number) and Fraction(repr(number)) == Fraction(exactly)
