"""Rational and algebraic multiples of powers of pi, in exact arithmetic."""

from __future__ import annotations

from collections.abc import Callable
from math import pi, sqrt
from typing import Any

import pytest
from flint import fmpq

from kinegrade.numbers.angle import Angle
from kinegrade.numbers.balls import Balls
from kinegrade.numbers.field import Field
from kinegrade.numbers.floats import Floats
from kinegrade.numbers.pi_multiple import PiMultiple
from kinegrade.numbers.refusals import Inexact, NegativeRoot
from kinegrade.numbers.rounded_text import write_decimal
from kinegrade.numbers.symbolic import convert_to_sympy
from kinegrade.numbers.text import LATEX, write_exact
from kinegrade.numbers.units import Scale

FIELD = Field()
ROOT = FIELD.sqrt(fmpq(3))
TURN = PiMultiple(fmpq(2), 1)


@pytest.mark.parametrize(
    ("work", "value"),
    [
        (lambda: TURN + TURN, 4 * pi),
        (lambda: TURN + 0, 2 * pi),
        (lambda: 0 - TURN, -2 * pi),
        (lambda: TURN * ROOT, 2 * pi * sqrt(3)),
        (lambda: ROOT * TURN, 2 * pi * sqrt(3)),
        (lambda: TURN / ROOT, 2 * pi / sqrt(3)),
        (lambda: ROOT / TURN, sqrt(3) / (2 * pi)),
        (lambda: (1 + ROOT) / TURN, (1 + sqrt(3)) / (2 * pi)),
        (lambda: fmpq(3) / TURN, 3 / (2 * pi)),
        (lambda: 3 / TURN, 3 / (2 * pi)),
        (lambda: Angle(fmpq(1)) * TURN, 2 * pi**2),
        (lambda: TURN * TURN / Angle(fmpq(2)), 2 * pi),
        (lambda: Angle(fmpq(1)) * ROOT, pi * sqrt(3)),
        (lambda: 3 / Angle(fmpq(1)), 3 / pi),
        (lambda: Angle(fmpq(1)) ** 2, pi**2),
        (lambda: TURN**3, (2 * pi) ** 3),
        (lambda: TURN**-1, 1 / (2 * pi)),
        (lambda: abs(-TURN), 2 * pi),
        (lambda: FIELD.sqrt(TURN * TURN * 3), 2 * pi * sqrt(3)),
        (lambda: FIELD.magnitude(TURN, TURN), 2 * pi * sqrt(2)),
        (lambda: FIELD.fork().embed(TURN * ROOT), 2 * pi * sqrt(3)),
        (lambda: FIELD.solve([[fmpq(2), ROOT], [fmpq(0), fmpq(1)]], [TURN, fmpq(0)])[0], pi),
    ],
)
def test_what_has_one_power_of_pi_stays_exact(work: Callable[[], Any], value: float) -> None:
    number = work()
    assert isinstance(number, PiMultiple)
    assert float(number) == pytest.approx(value, rel=1e-15)


def test_pi_that_cancels_leaves_a_number_without_it() -> None:
    assert TURN / PiMultiple(fmpq(1, 30), 1) == fmpq(60)
    assert fmpq(0) == TURN - TURN
    assert (TURN * ROOT) / TURN == ROOT
    assert FIELD.arctangent(TURN, TURN) == Angle(fmpq(1, 4))
    assert FIELD.arctangent(TURN, fmpq(0)) == Angle(fmpq(1, 2))


@pytest.mark.parametrize(
    "work",
    [
        lambda: TURN + 1,
        lambda: TURN * TURN - TURN,
        lambda: FIELD.sqrt(TURN),
        lambda: FIELD.cos(TURN),
        lambda: FIELD.arctangent(TURN, fmpq(1)),
        lambda: Angle(fmpq(0), ((fmpq(1), (fmpq(2), fmpq(1))),)) * TURN,
    ],
)
def test_what_has_no_single_power_of_pi_is_left_to_balls(work: Callable[[], Any]) -> None:
    with pytest.raises(Inexact):
        work()


def test_a_negative_multiple_has_no_root() -> None:
    with pytest.raises(NegativeRoot):
        FIELD.sqrt(-TURN * TURN)


def test_multiples_are_compared_with_any_number() -> None:
    assert fmpq(6) < TURN < fmpq(7)
    assert TURN < 4 * ROOT
    assert TURN * TURN > 6 * TURN
    assert TURN >= TURN * 1
    assert not TURN < TURN * 1
    assert -TURN < 0
    assert TURN != ROOT
    assert hash(TURN * ROOT) == hash(ROOT * TURN)


@pytest.mark.parametrize(
    ("number", "text", "latex"),
    [
        (PiMultiple(fmpq(10, 3), 1), "10*pi/3", r"\frac{10 \pi}{3}"),
        (PiMultiple(fmpq(-1), 2), "-pi**2", r"-\pi^{2}"),
        (PiMultiple(fmpq(75, 2), -1), "75/(2*pi)", r"\frac{75}{2 \pi}"),
        (PiMultiple(fmpq(3), -2), "3/pi**2", r"\frac{3}{\pi^{2}}"),
        (TURN * (1 - ROOT), "2*pi - 2*sqrt(3)*pi", r"2 \pi - 2 \sqrt{3} \pi"),
    ],
)
def test_multiples_print_as_in_a_book(number: Any, text: str, latex: str) -> None:
    assert (write_exact(number), write_exact(number, LATEX)) == (text, latex)
    assert float(convert_to_sympy(number)) == pytest.approx(float(write_decimal(number, 17)))


def test_a_unit_with_pi_is_the_same_in_every_arithmetic() -> None:
    scale, balls = Scale(fmpq(1, 30), 1), Balls(256)
    exact = FIELD.scale(scale)
    with balls.context():
        enclosed = balls.scale(scale)
        assert enclosed.overlaps(balls.number(exact))
    assert Floats().scale(scale) == pytest.approx(pi / 30, rel=1e-15)
    assert Floats().number(exact) == pytest.approx(pi / 30, rel=1e-15)
