"""What a remark on a wrong number says: what probably went wrong, what is right and what is allowed."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest

from kinegrade.grading.judging.hints import Hint, find_hint
from kinegrade.numbers.tolerance import ONE_PER_CENT, Tolerance
from kinegrade.reports.feedback.right_answers import (
    describe_allowed,
    write_closed_form,
    write_decimal,
)
from kinegrade.reports.paper_record import RightAnswer
from tests.grading.feedback_sheets import sheets

WIDE = Tolerance(absolute=Fraction(1))


@pytest.mark.parametrize(
    ("typed", "unit", "expected"),
    [
        ("-2.5", "m/s", Hint("opposite")),
        ("-2.49", "m/s", Hint("opposite")),
        ("250", "m/s", Hint("power of ten", power=2)),
        ("-0.25", "m/s", Hint("power of ten", True, -1)),
        ("5", "m/s", Hint("twice")),
        ("-1.25", "m/s", Hint("half", True)),
        ("143.24", "rad/s", Hint("degrees for radians")),
        ("143.24", "m/s", None),
        ("0.043633", "deg", Hint("radians for degrees")),
        ("23.873", "rad/s", Hint("revolutions per minute")),
        ("0.39789", "rad/s", Hint("revolutions per second")),
        ("23.873", "rad/s^2", None),
        ("7", "m/s", Hint("another ask", column="q1.x")),
        ("2.56", "m/s", Hint("close")),
        ("3.3", "m/s", None),
        ("0", "m/s", None),
    ],
)
def test_a_number_tells_what_probably_went_wrong(
    typed: str, unit: str, expected: Hint | None
) -> None:
    found = find_hint(
        Fraction(typed),
        Fraction("2.5"),
        Tolerance(absolute=Fraction("0.025")),
        unit,
        {"q1.x": Fraction(7), "q1.z": Fraction(0)},
    )
    assert found == expected


def test_nothing_is_guessed_where_zero_is_right_and_a_wide_tolerance_does_not_guess_more() -> None:
    assert find_hint(Fraction(3), Fraction(0), WIDE, "m/s", {}) is None
    assert find_hint(Fraction("-2.2"), Fraction("2.5"), WIDE, "m/s", {}) is None


@pytest.mark.parametrize(
    ("typed", "coarse", "kind"),
    [
        ("2.08", 0.09, "rounded"),
        ("2.08", 0.07, "close"),
        ("1.85", 0.16, "rounded"),
        ("1.85", 0.14, None),
        ("1.79", 0.5, None),  # more than a tenth is not put down to rounding
        ("-2", 0.5, "opposite"),
    ],
)
def test_what_rounding_may_lead_to_is_put_down_to_it(
    typed: str, coarse: float, kind: str | None
) -> None:
    found = find_hint(Fraction(typed), Fraction(2), ONE_PER_CENT, "m/s", {}, coarse=coarse)
    assert (found and found.kind) == kind


@pytest.mark.parametrize(
    ("exact", "decimal", "unit", "expected"),
    [
        ("13/4", "3.25", "rad/s", ("", "3.25\u202frad/s")),
        (
            "2*sqrt(3)/3",
            "1.1547005383792515",
            "m/s^2",
            (r"\frac{2 \sqrt{3}}{3}", "≈ 1.1547\u202fm/s²"),
        ),
        ("10/3", "3.3333333333333333", "1", (r"\frac{10}{3}", "≈ 3.33333")),
        ("-2*pi/3", "-2.0943951023931953", "rad", (r"-\frac{2 \pi}{3}", "≈ −2.0944\u202frad")),
        (
            "-3*sqrt(2)/40 + 2",
            "1.8939339828220178",
            "m",
            (r"2 - \frac{3 \sqrt{2}}{40}", "≈ 1.89393\u202fm"),
        ),
        (None, "-0.000123456789", "deg", ("", "≈ −0.000123457°")),
        ("sqrt(3)*" + "sqrt(2 + sqrt(5))*" * 9 + "2", "1.23456789", "m", ("", "≈ 1.23457\u202fm")),
        ("acos(1/3)", "70.528779", "deg", ("", "≈ 70.5288°")),
        ("60000000000", "60000000000", "m", ("", "6E+10\u202fm")),
    ],
)
def test_a_right_answer_is_exact_where_that_is_short(
    exact: str, decimal: str, unit: str, expected: tuple[str, str]
) -> None:
    right = RightAnswer(Fraction(decimal), exact, unit, Tolerance())
    assert (write_closed_form(right), write_decimal(right)) == expected


@pytest.mark.parametrize(
    ("allowed", "written"),
    [("0.0259", "±0.025\u202fm/s"), ("0.3", "±0.3\u202fm/s"), ("1/3", "±0.33\u202fm/s"), ("0", "")],
)
def test_what_is_allowed_is_never_rounded_up(allowed: str, written: str) -> None:
    rule = Tolerance(absolute=Fraction(allowed))
    assert describe_allowed(RightAnswer(Fraction(2), None, "m/s", rule)) == written


@pytest.mark.parametrize(
    ("typed", "said", "guess"),
    [
        ("2.04", "The size is off by 18 % of the right one.", False),
        ("-2.04", "The size is off by 18 % of the right one. The sign is opposite as well.", False),
        ("7.5", "The size is about 4.3 times the right one.", False),
        ("0", "The right value is not zero.", False),
        ("3.4641", "This is twice the right value: perhaps a factor 2 too many", True),
    ],
)
def test_every_wrong_number_gets_a_remark(
    tmp_path: Path, typed: str, said: str, guess: bool
) -> None:
    (sheet,) = sheets(tmp_path, (typed, "", ""))
    row = sheet.questions[0].rows[0]
    assert (row.mark, row.verdict, row.guess, sheet.guesses) == ("✗", "wrong", guess, guess)
    assert row.remark.startswith(said)
