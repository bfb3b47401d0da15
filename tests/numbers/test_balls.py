"""Certified arithmetic: balls hold the true value, are narrow, and say when they cannot tell."""

from __future__ import annotations

from typing import Any

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from mpmath import atan2, cos, mp, mpf, pi, sin, sqrt

from kinegrade.numbers.balls import Balls, Undecided
from kinegrade.numbers.elimination import Contradiction, Singular
from kinegrade.numbers.field import Field
from kinegrade.numbers.refusals import NegativeRoot, NoDirection
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names
from tests.laws.cases import arbitrary_values, drawn_values, shipped
from tests.numbers.numbers import build, digits, rationals, towers

Q = fmpq
BALLS = Balls(256)


def holds(ball: Any, decimal: Any) -> bool:
    """Whether the ball, widened by the last of the 60 digits, holds the decimal, and is narrow."""
    with mp.workdps(60):
        gap = abs(digits(ball) - decimal) - digits(arb(ball.rad()))
        return bool(
            gap < mpf(10) ** -55 * max(1, abs(decimal))
            and ball.rad() < arb("1e-55") * (1 + abs(ball))
        )


@given(rationals)
def test_sines_cosines_and_arctangents_hold_sixty_digits_of_mpmath(number: Any) -> None:
    with BALLS.context(), mp.workdps(60):
        value = mpf(int(number.p)) / int(number.q)
        ball = BALLS.number(number)
        assert holds(BALLS.cos(ball), cos(value))
        assert holds(BALLS.sin(ball), sin(value))
        assert holds(BALLS.arctangent(ball, arb(-2)), atan2(value, -2))
        assert holds(BALLS.sqrt(abs(ball)), sqrt(abs(value)))
        assert holds(BALLS.turns(number), value * pi)


@given(towers())
def test_a_ball_of_an_exact_number_holds_it(recipe: Any) -> None:
    number, decimal = build(recipe, Field())
    with BALLS.context():
        assert holds(BALLS.number(number), decimal) or decimal == 0


@given(st.data())
def test_answers_of_templates_are_certified_to_thirty_digits_whatever_the_values(
    data: st.DataObject,
) -> None:
    template = shipped(data.draw(st.sampled_from(find_template_names())))
    values = data.draw(st.one_of(drawn_values(template), arbitrary_values(template)))
    solution = solve_template(template, values)
    for answer in solution.answers.values():
        if not answer.is_exact:
            assert answer.number.rad() <= abs(answer.number) * arb(
                "1e-30"
            ) or answer.number.rad() < arb("1e-30")


@given(st.data())
def test_answers_by_balls_hold_the_exact_answers(data: st.DataObject) -> None:
    template = shipped(data.draw(st.sampled_from(find_template_names())))
    values = data.draw(drawn_values(template))
    exact = solve_template(template, values)
    # an angle that is no nice one but equal to it to forty digits leaves no exact field
    nudged = {
        name: f"{text} + 1e-45" if template.parameters[name].unit.degrees else text
        for name, text in values.items()
    }
    certified = solve_template(template, nudged)
    for name, answer in certified.answers.items():
        near, true = mpf(answer.decimal(25)), mpf(exact[name].decimal(25))
        assert abs(near - true) <= max(1, abs(true)) * mpf("1e-14"), name


def test_zero_is_told_from_small_numbers_or_not_told_at_all() -> None:
    with BALLS.context():
        assert BALLS.is_zero(arb(0))
        assert BALLS.is_zero(arb(0, arb("1e-60")))
        assert not BALLS.is_zero(arb("1e-60"))
        assert (BALLS.sign(arb(-2)), BALLS.sign(arb(0)), BALLS.sign(arb("1e-70"))) == (-1, 0, 1)
        with pytest.raises(Undecided):
            BALLS.is_zero(arb(0, arb("1e-6")))


def test_roots_and_directions_at_their_borders() -> None:
    with BALLS.context():
        assert 0 in BALLS.sqrt(arb(0, arb("1e-60")))
        assert BALLS.arctangent(arb(0), arb(3)) == 0
        assert BALLS.arctangent(arb(0), arb(-3)).overlaps(arb.pi())
        with pytest.raises(NegativeRoot):
            BALLS.sqrt(arb(-1))
        with pytest.raises(NoDirection):
            BALLS.arctangent(arb(0), arb(0))


def test_linear_equations_in_balls() -> None:
    with BALLS.context():
        # The third is the sum of the others
        x, y = BALLS.solve([[2, 1], [1, 3], [3, 4]], [3, 5, 8])
        assert x.overlaps(arb(Q(4, 5)))
        assert y.overlaps(arb(Q(7, 5)))
        with pytest.raises(Singular):
            BALLS.solve([[1, 2], [2, 4]], [0, 0])
        with pytest.raises(Contradiction):
            BALLS.solve([[1], [1]], [1, 2])
        BALLS.require_zero(arb(0))
        with pytest.raises(Contradiction):
            BALLS.require_zero(arb(1))
