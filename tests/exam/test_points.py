"""Points shared out: whole, all of them, nobody without, nobody more than a point from the exact
share.
"""

from __future__ import annotations

from fractions import Fraction

from hypothesis import given
from hypothesis import strategies as st

from kinegrade.exam.bank.entries.points import share_points

WEIGHTS = st.lists(st.integers(1, 9), min_size=1, max_size=6).map(
    lambda found: dict(zip("abcdef", found, strict=False))
)


@given(WEIGHTS, st.integers(0, 60))
def test_all_points_are_given_and_everyone_gets_one(weights: dict[str, int], more: int) -> None:
    points = share_points(len(weights) + more, weights)
    assert sum(points.values()) == len(weights) + more
    assert min(points.values()) >= 1
    assert list(points) == list(weights)


@given(WEIGHTS, st.integers(1, 60))
def test_it_is_the_largest_remainder_method_where_every_share_is_a_point_or_more(
    weights: dict[str, int], more: int
) -> None:
    total = sum(weights.values()) + more
    shares = {
        name: Fraction(total * weight, sum(weights.values())) for name, weight in weights.items()
    }
    floors = {name: int(share) for name, share in shares.items()}
    by_remainder = sorted(weights, key=lambda name: floors[name] - shares[name])
    favoured = by_remainder[: total - sum(floors.values())]
    assert share_points(total, weights) == {
        name: floors[name] + (name in favoured) for name in weights
    }


def test_a_total_that_is_the_weights_own_changes_nothing() -> None:
    assert share_points(9, {"v_B": 3, "omega_AB": 2, "a_B": 4}) == {
        "v_B": 3,
        "omega_AB": 2,
        "a_B": 4,
    }
    assert share_points(3, {"small": 1, "large": 90, "other": 1}) == {
        "small": 1,
        "large": 1,
        "other": 1,
    }
