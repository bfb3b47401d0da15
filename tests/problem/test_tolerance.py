"""What is right: the widest of the bank's rules; next to zero the largest term gives room."""

from __future__ import annotations

from fractions import Fraction

import pytest

from kinegrade.numbers.tolerance import ONE_PER_CENT, Tolerance
from kinegrade.problem.tolerance import find_effective_tolerance, round_to_two_figures


def tolerance(relative: str = "0", absolute: str = "0", figures: int | None = None) -> Tolerance:
    return Tolerance(Fraction(relative), Fraction(absolute), figures)


@pytest.mark.parametrize(
    ("rule", "exact", "low", "high"),
    [
        (ONE_PER_CENT, "-2", "-2.02", "-1.98"),
        (tolerance("1/100", "0.1"), "2", "1.9", "2.1"),
        (tolerance("1/100", "0.1"), "0", "-0.1", "0.1"),
        (tolerance(figures=3), "1.2349", "1.225", "1.235"),
        (tolerance(figures=3), "-1.2349", "-1.235", "-1.225"),
        (
            tolerance("1/1000", figures=3),
            "1.2349",
            "1.225",
            "1.2361349",
        ),  # each bound from the rule that gives more room
        (tolerance("1/100", figures=3), "1.2", "1.188", "1.212"),
        (tolerance(absolute="0.02", figures=2), "0", "-0.02", "0.02"),
    ],
)
def test_the_rule_that_gives_most_room_holds(
    rule: Tolerance, exact: str, low: str, high: str
) -> None:
    assert rule.interval(Fraction(exact)) == (Fraction(low), Fraction(high))


@pytest.mark.parametrize(
    ("rule", "exact", "figures"),
    [
        (ONE_PER_CENT, "1", 3),
        (tolerance("1/20"), "1", 3),  # nobody is expected to carry two
        (tolerance("1/199"), "1", 3),
        (tolerance("1/200"), "1", 4),  # 1.005 written as 1.01 would use all the room up
        (tolerance("1/1000"), "1", 4),
        (tolerance("1/10000"), "1", 5),
        (tolerance(figures=3), "1", 4),
        (tolerance(figures=5), "1", 6),
        (tolerance("1/100", figures=3), "1", 3),
        (tolerance(absolute="0.01"), "1", 3),
        (tolerance(absolute="0.01"), "100", 5),
        (tolerance(absolute="0.01"), "0", 3),
    ],
)
def test_a_student_carries_three_figures_or_as_many_as_the_rule_takes(
    rule: Tolerance, exact: str, figures: int
) -> None:
    assert rule.carried(Fraction(exact)) == figures


@pytest.mark.parametrize(
    ("rule", "share"),
    [
        (ONE_PER_CENT, "1/100"),
        (tolerance(figures=3), "1/200"),
        (tolerance("1/1000", figures=2), "1/20"),
        (tolerance(absolute="3"), "0"),
    ],
)
def test_the_share_is_what_the_rule_allows_whatever_the_value(rule: Tolerance, share: str) -> None:
    assert rule.share == Fraction(share)


@pytest.mark.parametrize(
    ("value", "absolute"),
    [
        (0.0, "0.1"),
        (0.0999, "0.1"),
        (-0.0999, "0.1"),
        (0.1, "0"),
        (5.0, "0"),
    ],
)
def test_an_answer_next_to_zero_gets_room_from_the_largest_of_the_terms_that_cancel(
    value: float, absolute: str
) -> None:
    rule = find_effective_tolerance(ONE_PER_CENT, value, 10.0)
    assert rule == tolerance("1/100", absolute)


@pytest.mark.parametrize(
    ("size", "rounded"),
    [
        (0.0, 0),
        (12.0, 12),
        (0.0123456, "0.012"),
        (987.6, 990),
        (9.96, 10),
        (1.25, "1.2"),
        (1e-9, "1e-9"),
        (57.3, 57),
        (0.1 + 0.025, "0.12"),
        (0.12500000000000003, "0.12"),
    ],
)
def test_scales_are_rounded_to_two_figures(size: float, rounded: str | int) -> None:
    assert round_to_two_figures(size) == Fraction(rounded)
