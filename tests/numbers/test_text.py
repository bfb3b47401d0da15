"""How numbers print: exact text read back, LaTeX, decimals rounded correctly to any number of
digits.
"""

from __future__ import annotations

import re
from decimal import ROUND_HALF_EVEN, Context, Decimal
from typing import Any

import pytest
from flint import arb, ctx, fmpq
from hypothesis import assume, given
from hypothesis import strategies as st
from mpmath import mp, mpf, nstr

from kinegrade.expressions.evaluation import evaluate, make_elementary_functions
from kinegrade.expressions.reading import read_expression
from kinegrade.numbers.angle import Angle
from kinegrade.numbers.field import Field
from kinegrade.numbers.rounded_text import write_decimal
from kinegrade.numbers.text import LATEX, write_exact, write_multiple_of_pi
from tests.numbers.numbers import build, digits, rationals, towers

Q = fmpq


@given(towers())
def test_exact_text_is_read_back_by_our_grammar_as_the_same_number(recipe: Any) -> None:
    field = Field()
    number = build(recipe, field)[0]
    text = write_exact(number)
    assume(len(text) <= 400)
    assert evaluate(read_expression(text), {}, make_elementary_functions(field), field) == number


@given(towers())
def test_latex_is_balanced_and_holds_the_same_digits(recipe: Any) -> None:
    number = build(recipe, Field())[0]
    latex = write_exact(number, LATEX)
    assert latex.count("{") == latex.count("}")
    assert re.fullmatch(r"(?:\\frac|\\sqrt|[{}\d+\- ])+", latex)
    assert sorted(re.findall(r"\d+", latex)) == sorted(re.findall(r"\d+", write_exact(number)))


@pytest.mark.parametrize(
    ("number", "plain", "latex"),
    [
        (lambda f: 2 / f.sqrt(Q(3)), "2*sqrt(3)/3", r"\frac{2 \sqrt{3}}{3}"),
        (lambda f: Q(-3, 2) + f.sqrt(Q(2)), "sqrt(2) - 3/2", r"\sqrt{2} - \frac{3}{2}"),
        (lambda f: -f.sqrt(Q(5)), "-sqrt(5)", r"-\sqrt{5}"),
        (
            lambda f: f.sqrt(382 - 9 * f.sqrt(Q(3))) / 20,
            "sqrt(382 - 9*sqrt(3))/20",
            r"\frac{\sqrt{382 - 9 \sqrt{3}}}{20}",
        ),
        (
            lambda f: f.sqrt(1 + f.sqrt(Q(2))) * f.sqrt(Q(2)),
            "sqrt(2)*sqrt(1 + sqrt(2))",
            r"\sqrt{2} \sqrt{1 + \sqrt{2}}",
        ),
        (lambda f: Q(7), "7", "7"),
        (lambda f: Q(-7, 3), "-7/3", r"-\frac{7}{3}"),
    ],
)
def test_numbers_print_as_in_a_book(number: Any, plain: str, latex: str) -> None:
    assert write_exact(number(Field())) == plain
    assert write_exact(number(Field()), LATEX) == latex


@pytest.mark.parametrize(
    ("half_turns", "text", "latex"),
    [
        (Q(0), "0", "0"),
        (Q(1), "pi", r"\pi"),
        (Q(-1, 2), "-pi/2", r"-\frac{\pi}{2}"),
        (Q(7, 6), "7*pi/6", r"\frac{7 \pi}{6}"),
    ],
)
def test_multiples_of_pi_print_as_in_a_book(half_turns: Any, text: str, latex: str) -> None:
    assert (write_multiple_of_pi(half_turns), write_multiple_of_pi(half_turns, LATEX)) == (
        text,
        latex,
    )


@given(towers(), st.integers(1, 40))
def test_decimals_of_exact_numbers_are_those_of_mpmath(recipe: Any, count: int) -> None:
    number = build(recipe, Field())[0]
    with mp.workdps(60):
        exact = digits(number)
        assert (
            abs(mpf(write_decimal(number, count)) - exact)
            <= abs(exact) * mpf(10) ** (1 - count) / 2 + mpf(10) ** -55
        )


@given(rationals, st.integers(1, 30))
def test_decimals_of_rationals_are_rounded_half_to_even(number: Any, count: int) -> None:
    context = Context(prec=count, rounding=ROUND_HALF_EVEN)
    assert Decimal(write_decimal(number, count)) == context.divide(
        Decimal(int(number.p)), Decimal(int(number.q))
    )


@given(rationals, st.integers(0, 25), st.integers(3, 30))
def test_a_ball_is_given_to_the_digits_that_it_holds_and_no_more(
    number: Any, wide: int, count: int
) -> None:
    assume(abs(number) > Q(2, 10**wide))
    with ctx.workprec(300):
        ball = arb(number, arb(10) ** -wide)
        ends = ball.lower().fmpq(), ball.upper().fmpq()
    held = [
        n for n in range(1, count + 1) if write_decimal(ends[0], n) == write_decimal(ends[1], n)
    ]
    finely = [write_decimal(end, count + 12) for end in ends]
    assume(count in held or finely[0] != finely[1])  # about a middle: below
    assert write_decimal(ball, count) == write_decimal(number, held[-1] if held else 1)


@pytest.mark.parametrize(
    ("number", "count", "text"),
    [
        (Q(2, 3), 5, "0.66667"),
        (Q(-2, 3), 1, "-0.7"),
        (Q(5, 2), 1, "2"),
        (Q(7, 2), 1, "4"),
        (Q(25, 1000), 1, "0.02"),
        (Q(1, 8), 3, "0.125"),
        (Q(0), 7, "0"),
        (Q(99999, 1000), 3, "100"),
        (Q(123456), 3, "123000"),
        (Q(1, 10**7), 4, "0.0000001"),
        (Q(1, 10**8), 4, "1e-8"),
        (Q(123, 10**10), 3, "1.23e-8"),
        (Q(10) ** 20, 3, "100000000000000000000"),
        (Q(10) ** 21, 3, "1e21"),
        (Q(314, 100) * Q(10) ** 30, 3, "3.14e30"),
    ],
)
def test_rationals_print_like_this(number: Any, count: int, text: str) -> None:
    assert write_decimal(number, count) == text


def test_the_first_hundred_digits_of_root_two() -> None:
    with mp.workdps(130):
        assert write_decimal(Field().sqrt(Q(2)), 100) == nstr(mpf(2) ** mpf("0.5"), 100)


def test_angles_print_in_radians_or_degrees() -> None:
    assert write_decimal(Angle(Q(1, 3)), 6) == "1.0472"
    assert write_decimal(Angle(Q(1, 3)), 6, degrees=True) == "60"
    assert write_decimal(Angle(Q(0), ((Q(1), (Q(4), Q(3))),)), 8, degrees=True) == "36.869898"
    assert write_decimal(Angle(Q(0)), 5) == "0"


def test_nearly_a_tie_is_rounded_by_the_digits_that_follow() -> None:
    field = Field()
    below = Q(25, 10) - (field.sqrt(Q(2)) - Q(1)) / Q(10) ** 200
    assert write_decimal(below, 1) == "2"
    assert write_decimal(2 * Q(25, 10) - below, 1) == "3"


def test_a_ball_about_zero_prints_as_zero() -> None:
    assert write_decimal(arb(0, arb("1e-50")), 10) == "0"


@pytest.mark.parametrize(
    ("number", "count", "printed"),
    [("-0.021375", 4, "-0.02138"), ("-0.051965", 4, "-0.05196"), ("0.25", 1, "0.2")],
)
def test_a_narrow_ball_about_a_middle_is_rounded_as_the_middle_is(
    number: str, count: int, printed: str
) -> None:
    """To even, as every number; three digits, which are all that its ends share, would be padded
    to -0.02140.
    """
    with ctx.workprec(200):
        assert write_decimal(arb(number, "1e-40"), count) == printed
