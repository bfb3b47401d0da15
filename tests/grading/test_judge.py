"""At the boundary: exactly the tolerance is right, one unit in the last place beyond is wrong."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.exam.folder.keys import Key
from kinegrade.grading.judging.judge import judge
from kinegrade.grading.typed.answers import read
from kinegrade.numbers.tolerance import ONE_PER_CENT, Tolerance
from tests.said import said

# Floats put 1.212 outside: 1.212 - 1.2 > 0.01 * 1.2
ONE_PERCENT = Key(Fraction("1.2"), ONE_PER_CENT)
ZERO = Key(Fraction(0), Tolerance(absolute=Fraction("0.002")))
ROOT = Fraction("0.8660254037844386467637231707529361834714")  # half the root of 3, to 40 digits
EXACT = Key(Fraction(1, 8), Tolerance())


@pytest.mark.parametrize(
    ("typed", "key", "kind"),
    [
        ("1.212", ONE_PERCENT, "right"),
        ("1.188", ONE_PERCENT, "right"),
        ("1.2120000000000000000000000000000000001", ONE_PERCENT, "wrong"),
        ("1.1879999999999999999999999999999999999", ONE_PERCENT, "wrong"),
        ("-1.2", ONE_PERCENT, "wrong"),
        ("0.002", ZERO, "right"),
        ("-2e-3", ZERO, "right"),
        ("0.00200000000000000000000000000000000001", ZERO, "wrong"),
        ("0", ZERO, "right"),
        ("-0", ZERO, "right"),
        ("0.125", EXACT, "right"),
        ("0,1250", EXACT, "right"),
        ("0.12500000000000000000000000000000000001", EXACT, "wrong"),
        ("", EXACT, "blank"),
        ("abc", EXACT, "unreadable"),
    ],
)
def test_verdicts(typed: str, key: Key, kind: str) -> None:
    assert judge(read(typed, "m/s"), key).kind == kind


@pytest.mark.parametrize(("typed", "key", "kind"), [
    ("√3/2", Key(ROOT, Tolerance()), "right"), ("√3/2", Key(-ROOT, Tolerance()), "wrong"),
    ("1.01*√3/2", Key(ROOT, ONE_PER_CENT), "right"), ("0.99√3/2", Key(ROOT, ONE_PER_CENT), "right"),
    ("1.0100000000000000000000000000001√3/2", Key(ROOT, ONE_PER_CENT), "wrong"),
    ("0.866025403784438646763723170752936183", Key(ROOT, Tolerance()), "wrong"),
])  # fmt: skip
def test_an_irrational_answer_on_the_bound_is_right(typed: str, key: Key, kind: str) -> None:
    assert judge(read(typed, "m/s"), key).kind == kind


def test_a_wrong_unit_is_told_before_numbers_are_compared() -> None:
    verdict = judge(read("0 rad", "m/s"), ZERO)
    assert (verdict.kind, said(verdict.reason)) == (
        "wrong unit",
        '"rad" measures an angle; a speed was expected, in "m/s"',
    )


def test_the_reason_shows_which_of_the_two_is_larger() -> None:
    assert (
        said(judge(read("1.5", "1"), ONE_PERCENT).reason)
        == "key 1.2, difference 0.3, allowed 0.012"
    )
    assert said(judge(read("1.21200000001", "1"), ONE_PERCENT).reason) == (
        "key 1.2, difference 0.01200000001, allowed 0.012"
    )
    assert said(judge(read("1e99", "1"), ZERO).reason) == "key 0, difference 1e+99, allowed 0.002"
    assert (
        said(judge(read("100", "1"), Key(Fraction(100), ONE_PER_CENT)).reason)
        == "key 100, difference 0, allowed 1"
    )
    assert said(judge(read("abc", "1"), ZERO).reason) == '"abc" is not a number'
    assert said(judge(read("", "1"), ZERO).reason) == ""


@given(
    st.fractions(max_denominator=10**6),
    st.fractions(min_value=0, max_denominator=10**6),
    st.decimals(
        allow_nan=False, allow_infinity=False, places=8, min_value=-(10**6), max_value=10**6
    ),
)
def test_right_is_the_closed_interval_about_the_key(
    value: Fraction, tolerance: Fraction, typed: object
) -> None:
    right = judge(read(str(typed), "1"), Key(value, Tolerance(absolute=tolerance))).kind == "right"
    assert right is (value - tolerance <= Fraction(str(typed)) <= value + tolerance)


@pytest.mark.parametrize(
    ("typed", "kind"),
    [
        ("350", "right"),
        ("-10", "right"),
        ("710", "right"),
        ("-369.5", "right"),
        ("1430", "right"),
        ("1790", "wrong"),
        ("10", "wrong"),
        ("-12", "wrong"),
    ],
)
def test_an_angle_is_right_with_a_few_full_turns(typed: str, kind: str) -> None:
    assert (
        judge(
            read(typed, "deg"), Key(Fraction(350), Tolerance(absolute=Fraction(1)), Fraction(360))
        ).kind
        == kind
    )


def test_degrees_typed_for_radians_are_no_angle_many_turns_away() -> None:
    turn = Fraction("6.283185307179586476925286766559005768394")
    key = Key(Fraction("2.34321"), Tolerance(relative=Fraction("0.02")), turn)
    verdict = judge(read("134.3", "rad"), key)
    assert (verdict.kind, said(verdict.reason)) == (
        "wrong",
        "key 2.34321, difference 131.957, allowed 0.0468642",
    )
    assert judge(read("8.6264", "rad"), key).kind == "right"


TO_FIGURES = Key(Fraction("1.2349"), Tolerance(figures=3))
WIDER = Key(Fraction("1.2349"), Tolerance(absolute=Fraction("0.01"), figures=3))


@pytest.mark.parametrize(
    ("typed", "kind"),
    [
        ("1.23", "right"),
        ("1.225", "right"),
        ("1.235", "right"),
        ("1.2249", "wrong"),
        ("1.2351", "wrong"),
        ("1.2", "wrong"),
        ("1.24", "wrong"),
        ("-1.23", "wrong"),
    ],
)
def test_what_agrees_to_the_significant_figures_asked_for_is_right(typed: str, kind: str) -> None:
    assert judge(read(typed, "1"), TO_FIGURES).kind == kind


@pytest.mark.parametrize(
    ("typed", "kind"), [("1.225", "right"), ("1.2449", "right"), ("1.24491", "wrong")]
)
def test_each_bound_is_the_wider_of_tolerance_and_figures(typed: str, kind: str) -> None:
    assert judge(read(typed, "1"), WIDER).kind == kind


def test_the_reason_names_the_bounds_where_figures_are_asked_for() -> None:
    key = TO_FIGURES
    assert said(judge(read("1.24", "1"), key).reason) == (
        "key 1.2349, difference 0.0051, right from 1.225 to 1.235"
    )


def test_figures_and_full_turns_go_together() -> None:
    key = Key(Fraction("359.96"), Tolerance(figures=3), Fraction(360))
    assert [
        judge(read(typed, "deg"), key).kind for typed in ("0.5", "-0.5", "360", "0.6", "719.4")
    ] == [
        "right",
        "right",
        "right",
        "wrong",
        "wrong",
    ]
