"""What makes the rest of a question trivial, and what does not."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

import pytest

from kinegrade.grading.judging.trivial_answers import Later, is_trivial


def normal_and_tangential(own: Mapping[str, Fraction]) -> tuple[Fraction]:
    """An acceleration omega^2 + 12, with omega = 2 right."""
    return (own["omega"] ** 2 + 12,)


def along(own: Mapping[str, Fraction]) -> tuple[Fraction]:
    """A velocity 3 omega."""
    return (3 * own["omega"],)


@pytest.mark.parametrize(
    ("omega", "response", "trivial"),
    [
        ("0.002", "12", True),
        ("0.1", "12.01", True),
        ("-0.2", "12.04", True),
        ("0.9", "12.81", False),
        ("3", "21", False),
        ("20", "412", False),
        ("30", "912", False),
        ("115", "13237", True),
        ("1990", "3960112", True),
    ],
)
def test_a_term_that_vanishes_or_drowns_all_others(
    omega: str, response: str, trivial: bool
) -> None:
    given = Fraction(response)
    assert (
        is_trivial(
            "omega",
            {"omega": Fraction(omega)},
            Fraction(2),
            Later(normal_and_tangential, lambda value: abs(given - value) <= abs(value) / 100),
        )
        is trivial
    )


@pytest.mark.parametrize("omega", ["0.002", "0.1", "3", "20", "1990", "-1990"])
def test_what_is_nothing_but_in_proportion_is_not_trivial(omega: str) -> None:
    given = 3 * Fraction(omega)
    assert not is_trivial(
        "omega",
        {"omega": Fraction(omega)},
        Fraction(2),
        Later(along, lambda value: abs(given - value) <= abs(value) / 100),
    )


def test_a_term_that_never_mattered_is_not_trivial() -> None:
    def hardly(own: Mapping[str, Fraction]) -> tuple[Fraction]:
        return (own["omega"] / 1000 + own["alpha"],)

    own = {"omega": Fraction(1, 100), "alpha": Fraction(5)}
    assert not is_trivial(
        "omega", own, Fraction(2), Later(hardly, lambda value: abs(5 - value) <= Fraction(1, 20))
    )


def test_where_nothing_follows_nothing_is_trivial() -> None:
    assert not is_trivial(
        "omega",
        {"omega": Fraction(1, 100)},
        Fraction(2),
        Later(lambda own: (), lambda value: True),
    )
