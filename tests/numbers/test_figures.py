"""Significant figures: which numbers agree with an exact one to so many of them."""

from __future__ import annotations

from decimal import ROUND_HALF_DOWN, ROUND_HALF_UP, Context, Decimal
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.numbers.decimals import figures_interval, leading_power

NUMBERS = st.fractions(max_denominator=10**9).filter(bool)
FIGURES = st.integers(1, 6)


@pytest.mark.parametrize(
    ("exact", "figures", "low", "high"),
    [
        ("1.2304", 3, "1.225", "1.235"),
        ("-1.2304", 3, "-1.235", "-1.225"),
        ("0.00123449", 3, "0.001225", "0.001235"),
        ("98765", 2, "98500", "99500"),
        ("9.996", 3, "9.995", "10.005"),  # the figures of the exact value count, not those of 10.0
        ("10", 3, "9.95", "10.05"),
        ("1.235", 3, "1.225", "1.245"),  # a tie: 1.23 and 1.24 are both right
        ("1.225", 3, "1.215", "1.235"),
        ("2/3", 2, "0.665", "0.675"),
    ],
)
def test_half_a_unit_of_the_last_figure_is_the_bound(
    exact: str, figures: int, low: str, high: str
) -> None:
    assert figures_interval(Fraction(exact), figures) == (Fraction(low), Fraction(high))


@given(NUMBERS, FIGURES)
def test_the_exact_number_and_its_roundings_agree_with_it(exact: Fraction, figures: int) -> None:
    low, high = figures_interval(exact, figures)
    assert low <= exact <= high
    for rounding in (ROUND_HALF_UP, ROUND_HALF_DOWN):
        context = Context(prec=figures, rounding=rounding)
        assert (
            low
            <= Fraction(context.divide(Decimal(exact.numerator), Decimal(exact.denominator)))
            <= high
        )


@given(NUMBERS, FIGURES)
def test_the_interval_is_one_unit_of_the_last_figure_or_two_at_a_tie(
    exact: Fraction, figures: int
) -> None:
    low, high = figures_interval(exact, figures)
    unit = Fraction(10) ** (leading_power(exact) - figures + 1)
    assert high - low == unit * (2 if (exact / unit - Fraction(1, 2)).denominator == 1 else 1)


@given(NUMBERS, st.integers(-40, 40))
def test_the_leading_power_is_the_place_of_the_first_figure(exact: Fraction, shift: int) -> None:
    number = exact * Fraction(10) ** shift
    assert (
        Fraction(10) ** leading_power(number)
        <= abs(number)
        < Fraction(10) ** (leading_power(number) + 1)
    )
