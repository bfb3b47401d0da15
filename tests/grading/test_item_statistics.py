"""Statistics of a class against their definitions, and for classes too small to tell anything."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.reports.classes.equal_hardness import (
    adjust_p_values,
    compare_groups,
    find_parameter_trends,
    rank_values,
    split_in_thirds,
)
from kinegrade.reports.classes.item_statistics import (
    correlate,
    find_discriminations,
    find_facilities,
    find_interval,
    find_reliability,
    make_histogram,
    summarise,
)

SHARES = st.lists(st.floats(0, 100), max_size=60)
FEW_LEVELS = st.lists(st.integers(0, 4), min_size=3, max_size=40)
ONE_EACH = np.array([1.0, 1.0])


def test_facility_is_the_mean_share_of_the_points() -> None:
    points = np.array([[4.0, 0.0], [2.0, 0.0], [0.0, 0.0]])
    assert find_facilities(points, np.array([4.0, 0.0])) == (0.5, None)
    assert find_facilities(np.empty((0, 2)), np.array([4.0, 3.0])) == (None, None)


def test_discrimination_leaves_the_ask_itself_out_of_the_total() -> None:
    points = np.array([[1.0, 3.0, 2.0], [0.0, 1.0, 2.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    rest = [5.0, 3.0, 0.0, 1.0]
    expected = np.corrcoef([1.0, 0.0, 1.0, 0.0], rest)[0, 1]
    assert find_discriminations(points, np.array([1.0, 3.0, 2.0]))[0] == pytest.approx(expected)
    agreeing = np.array([[1.0, 1.0], [0.0, 0.0], [1.0, 1.0]])
    assert find_discriminations(agreeing, ONE_EACH) == pytest.approx((1.0, 1.0))
    against = np.array([[1.0, 0.0], [0.0, 1.0], [1.0, 0.0]])
    assert find_discriminations(against, ONE_EACH) == pytest.approx((-1.0, -1.0))


def test_papers_that_ask_for_more_are_no_better_papers() -> None:
    none = np.nan
    heavy = [[1.0, 10.0, none], [0.0, 0.0, none]]
    light = [[1.0, none, 1.0], [0.0, none, 0.0]]
    points = np.array([*heavy, *light])
    assert find_discriminations(points, np.array([1.0, 10.0, 1.0]))[0] == pytest.approx(1)


@pytest.mark.parametrize(
    "points", [np.empty((0, 2)), np.ones((1, 2)), np.eye(2), np.ones((5, 2)), np.full((7, 2), 0.1)]
)
def test_what_too_few_or_too_equal_students_cannot_tell_is_none(points: np.ndarray) -> None:
    assert find_discriminations(points, ONE_EACH) == (None, None)
    assert find_reliability(points) is None


def test_an_interval_of_confidence_is_that_of_the_tables() -> None:
    low, high = find_interval(0.5, 28) or (0.0, 0.0)  # Fisher's z: 0.5493 ± 0.392
    assert (low, high) == pytest.approx((0.156, 0.736), abs=5e-4)
    assert find_interval(-0.5, 28) == pytest.approx((-high, -low))
    assert find_interval(1.0, 28) == pytest.approx((1.0, 1.0))
    assert find_interval(0.5, 3) is None


def test_asks_that_agree_are_reliable_and_asks_that_do_not_are_not() -> None:
    alike = np.array([[1.0, 1.0], [0.0, 0.0], [1.0, 1.0]])
    assert find_reliability(alike) == pytest.approx(1)
    unlike = np.array([[1.0, 1.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.0]])
    assert find_reliability(unlike) == pytest.approx(0)


def test_a_summary_of_none_one_and_two() -> None:
    assert summarise([]) is None
    one, two = summarise([40.0]), summarise([40.0, 60.0])
    assert one
    assert two
    assert (one.count, one.mean, one.sd, one.lower, one.upper) == (1, 40, None, 40, 40)
    assert (two.mean, two.median, two.lower, two.upper) == (50, 50, 45, 55)
    assert two.sd == pytest.approx(200**0.5)


@given(SHARES)
def test_a_histogram_counts_everybody_once_from_nought_to_a_hundred(percents: list[float]) -> None:
    shown = make_histogram(percents)
    assert sum(shown.counts) == len(percents)
    assert (shown.edges[0], shown.edges[-1], len(shown.counts)) == (0, 100, len(shown.edges) - 1)


def test_a_value_on_an_edge_counts_to_the_right_and_bonus_points_to_the_last_class() -> None:
    assert make_histogram([20.0, 100.0, 104.0]).counts == (0, 1, 0, 0, 2)
    assert make_histogram([29.999999999999996] * 30).counts[3] == 30


@given(FEW_LEVELS)
def test_ranks_of_equals_are_the_mean_of_their_places(values: list[int]) -> None:
    ranked = rank_values(np.array(values, dtype=float))
    for value, rank in zip(values, ranked, strict=True):
        places = [place for place, other in enumerate(sorted(values), 1) if other == value]
        assert rank == sum(places) / len(places)


@given(FEW_LEVELS, st.integers(2, 3))
def test_h_is_the_share_of_the_ranks_variance_between_the_groups(
    values: list[int], groups: int
) -> None:
    names = [f"{place % groups}" for place in range(len(values))]
    test = compare_groups(np.array(values, dtype=float), names)
    ranked = rank_values(np.array(values, dtype=float))
    whole = ((ranked - ranked.mean()) ** 2).sum()
    if whole == 0:
        assert test is None
        return
    members = [ranked[[other == name for other in names]] for name in set(names)]
    between = sum(len(group) * (group.mean() - ranked.mean()) ** 2 for group in members)
    assert test is not None
    assert test.statistic == pytest.approx((len(values) - 1) * between / whole, abs=1e-9)
    assert 0 < test.p <= 1


def test_p_is_that_of_all_permutations_and_always_the_same() -> None:
    apart = np.array([1.0, 2.0, 3.0, 7.0, 8.0, 9.0])
    test = compare_groups(apart, list("AAABBB"))
    assert test == compare_groups(apart, list("AAABBB"))
    assert test
    assert test.p == pytest.approx(2 / 20, abs=0.01)
    steps = np.arange(5.0)
    (monotone,) = find_parameter_trends({("q1", "r"): steps}, {"q1": steps**3})
    assert monotone.test.statistic == pytest.approx(1)
    assert monotone.test.p == pytest.approx(2 / 120, abs=0.004)


def test_one_version_and_equal_points_have_no_test() -> None:
    assert compare_groups(np.arange(9.0), ["A"] * 9) is None
    assert compare_groups(np.ones(9), list("ABCABCABC")) is None
    assert find_parameter_trends({("q1", "r"): np.ones(9)}, {"q1": np.arange(9.0)}) == ()
    assert correlate(np.full(9, 0.1), np.arange(9.0)) is None


def test_many_tests_are_adjusted_for() -> None:
    assert adjust_p_values([]) == ()
    assert adjust_p_values([0.01, 0.04, 0.04]) == pytest.approx((0.03, 0.08, 0.08))
    assert adjust_p_values([0.9, 0.95]) == (1.0, 1.0)


@given(st.lists(st.integers(0, 9), min_size=8, max_size=20), st.integers(0, 3))
def test_a_trend_is_tested_beside_others_as_it_is_alone(numbers: list[int], blank: int) -> None:
    row = np.array(numbers, dtype=float)
    shorter = np.where(np.arange(len(row)) < blank, np.nan, row[::-1])
    shares = {"q1": np.linspace(0, 1, len(row))}
    drawn = {("q1", "r"): row, ("q1", "h"): shorter, ("q1", "k"): np.flip(row)}
    together = {each.parameter: each.test for each in find_parameter_trends(drawn, shares)}
    alone = {
        each.parameter: each.test
        for key, value in drawn.items()
        for each in find_parameter_trends({key: value}, shares)
    }
    assert together == alone


@given(st.lists(st.integers(0, 9), min_size=3, max_size=50))
def test_thirds_hold_everybody_and_keep_equal_numbers_together(numbers: list[int]) -> None:
    shares = np.linspace(0, 1, len(numbers))
    groups = split_in_thirds(np.array(numbers, dtype=float), shares)
    assert sum(group.count for group in groups) == len(numbers)
    assert sum(group.count * group.share for group in groups) == pytest.approx(shares.sum())
    assert [(left, right) for left, right in pairwise(groups) if left.highest >= right.lowest] == []


def test_a_number_that_makes_papers_harder_stands_first_and_one_that_does_not_vary_is_left_out() -> (
    None
):
    numbers = np.arange(40.0)
    found = find_parameter_trends(
        {
            ("q1", "k"): np.tile([1.0, 2.0], 20),
            ("q1", "r"): numbers,
            ("q1", "h"): np.ones(40),
            ("q2", "r"): np.full(40, np.nan),
        },
        {"q1": 1 - numbers / 40, "q2": np.ones(40)},
    )
    assert [trend.parameter for trend in found] == ["r", "k"]
    assert found[0].correlation == pytest.approx(-1)
    assert found[0].adjusted == 2 * found[0].test.p
