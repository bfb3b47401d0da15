"""Exact angles: multiples of 15, 18 and 22.5 degrees, arctangents, their sums and halves."""

from __future__ import annotations

from typing import Any

import pytest
from flint import arb, ctx, fmpq
from hypothesis import given
from hypothesis import strategies as st
from mpmath import atan2, cos, mp, mpf, pi, sin

from kinegrade.expressions.evaluation import evaluate, make_elementary_functions
from kinegrade.expressions.reading import read_expression
from kinegrade.numbers.angle import Angle
from kinegrade.numbers.balls import Balls
from kinegrade.numbers.field import Field
from kinegrade.numbers.refusals import Inexact, NoDirection
from kinegrade.numbers.text import LATEX, write_angle
from tests.numbers.numbers import digits

Q = fmpq
NICE = sorted(
    {15 * n for n in range(-12, 25)}
    | {18 * n for n in range(-10, 11)}
    | {22.5 * n for n in range(-8, 9)}
)
slopes = st.builds(fmpq, st.integers(-6, 6), st.integers(1, 4))


def degrees(value: float) -> Angle:
    return Angle(Q(int(value * 2), 360))


@pytest.mark.parametrize("value", NICE)
def test_nice_angles_have_exact_sines_and_cosines_and_are_named_again(value: float) -> None:
    field = Field()
    x, y = degrees(value).direction(field)
    with mp.workdps(60):
        assert abs(digits(x) - cos(mpf(value) * pi / 180)) < mpf(10) ** -50
        assert abs(digits(y) - sin(mpf(value) * pi / 180)) < mpf(10) ** -50
    assert x * x + y * y == 1
    named = field.arctangent(y, x)
    assert not named.parts
    assert ((named.half_turns - Q(int(value * 2), 360)) / 2).q == 1
    assert Q(-1) < named.half_turns <= 1


@given(
    slopes,
    slopes,
    st.sampled_from([Q(1), Q(2), Q(-1), Q(1, 2), Q(-3, 2), Q(3)]),
    st.sampled_from([0, 15, 90, 150]),
)
def test_sums_multiples_and_halves_of_arctangents_point_where_mpmath_says(
    a: Any, b: Any, factor: Any, nice: int
) -> None:
    field = Field()
    angle = field.arctangent(a, Q(1)) * factor + field.arctangent(b, Q(-1)) - degrees(nice)
    try:
        x, y = angle.direction(field)
    except Inexact:
        return
    with mp.workdps(60):
        value = (
            atan2(digits(a), 1) * digits(factor)
            + (atan2(digits(b), -1) if b != 0 else pi)
            - nice * pi / 180
        )
        assert abs(digits(x) - cos(value)) < mpf(10) ** -45
        assert abs(digits(y) - sin(value)) < mpf(10) ** -45
    with ctx.workprec(200):
        assert abs(float(angle.ball()) - float(value)) < 1e-12


@given(
    slopes,
    slopes,
    st.sampled_from([Q(1), Q(2), Q(1, 3), Q(-1, 2)]),
    st.sampled_from([0, 15, 90, -150]),
)
def test_the_text_of_an_angle_reads_back_as_the_same_angle(
    a: Any, b: Any, factor: Any, nice: int
) -> None:
    field, balls = Field(), Balls(256)
    angle = field.arctangent(a, Q(-1)) * factor - field.arctangent(b, Q(1)) + degrees(nice)
    with balls.context():
        for unit, size in ((False, arb(1)), (True, 180 / arb.pi())):
            text = write_angle(angle, unit)
            back = evaluate(
                read_expression(text),
                {"pi": balls.turns(1)},
                make_elementary_functions(balls),
                balls,
            )
            assert abs(back - angle.ball() * size) < arb("1e-60")
            latex = write_angle(angle, unit, LATEX)
            assert latex.count("{") == latex.count("}")
            assert latex.count("(") == latex.count(")")


@pytest.mark.parametrize(
    ("angle", "radians", "in_degrees"),
    [
        (Angle(Q(1, 3)), "pi/3", "60"),
        (Angle(Q(-5, 12)), "-5*pi/12", "-75"),
        (Angle(Q(0)), "0", "0"),
        (Angle(Q(2)), "2*pi", "360"),
        (Angle(Q(0), ((Q(1), (Q(3), Q(1))),)), "atan(1/3)", "180*atan(1/3)/pi"),
        (Angle(Q(0), ((Q(2), (Q(1), Q(2))),)), "2*atan(2)", "180*2*atan(2)/pi"),
        (
            Angle(Q(1, 2), ((Q(-1), (Q(4), Q(3))),)),
            "-atan(3/4) + pi/2",
            "180*(-atan(3/4) + pi/2)/pi",
        ),
        (Angle(Q(0), ((Q(1), (Q(-4), Q(3))),)), "atan(-3/4) + pi", "180*(atan(-3/4) + pi)/pi"),
        (Angle(Q(0), ((Q(1), (Q(-4), Q(-3))),)), "atan(3/4) - pi", "180*(atan(3/4) - pi)/pi"),
    ],
)
def test_angles_print_as_in_a_book(angle: Angle, radians: str, in_degrees: str) -> None:
    assert write_angle(angle, degrees=False) == radians
    assert write_angle(angle, degrees=True) == in_degrees


def test_equal_parts_are_added_up_and_vanish() -> None:
    field = Field()
    angle = field.arctangent(Q(3), Q(4))
    assert angle + angle == angle * 2
    assert (angle - angle) == Angle(Q(0))
    assert angle + 0 == angle
    assert 0 + angle == angle
    assert -angle == angle * -1
    assert angle / 2 + angle / 2 == angle


def test_a_quarter_turn_less_an_angle_swaps_sine_and_cosine() -> None:
    field = Field()
    angle = field.arctangent(Q(3), Q(4))  # cos 4/5, sin 3/5
    assert (field.turns(Q(1, 2)) - angle).direction(field) == (Q(3, 5), Q(4, 5))
    assert (angle * 2).direction(field) == (Q(7, 25), Q(24, 25))
    assert field.cos(angle / 2) ** 2 == Q(9, 10)


@pytest.mark.parametrize(
    "make",
    [
        pytest.param(lambda f: f.cos(f.turns(Q(37, 180))), id="cosine-of-37-degrees"),
        pytest.param(lambda f: f.arctangent(Q(1), Q(3)) * f.turns(Q(1)), id="angle-times-angle"),
        pytest.param(lambda f: f.arctangent(Q(1), Q(3)) * f.sqrt(Q(2)), id="angle-times-root"),
        pytest.param(lambda f: f.arctangent(Q(1), Q(3)) / f.turns(Q(1)), id="ratio-of-angles"),
        pytest.param(lambda f: Q(1) / f.arctangent(Q(1), Q(3)), id="number-over-an-angle"),
        pytest.param(lambda f: f.cos(f.arctangent(Q(1), Q(3)) / 3), id="third-of-an-angle"),
    ],
)
def test_what_has_no_small_field_is_left_to_balls(make: Any) -> None:
    with pytest.raises(Inexact):
        make(Field())


def test_the_ratio_of_two_plain_angles_is_a_number() -> None:
    assert Field().turns(Q(1, 3)) / Field().turns(Q(1)) == Q(1, 3)


def test_the_zero_vector_has_no_direction() -> None:
    with pytest.raises(NoDirection):
        Field().arctangent(Q(0), Q(0))
