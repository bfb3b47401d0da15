"""The door outwards: numbers as sympy expressions, made of the numbers themselves.

Only this module imports sympy, which takes long to load; it is imported by what asks for it.
"""

from __future__ import annotations

from math import floor, log10
from typing import Any, TypeAlias

from flint import arb, fmpq
from sympy import Expr, Float, Integer, Rational, atan2, expand, oo, pi, sqrt

from kinegrade.numbers.angle import Angle
from kinegrade.numbers.pi_multiple import PiMultiple
from kinegrade.numbers.surd import Surd

SympyExpression: TypeAlias = Expr
_DIGITS = 40  # of an enclosure, as many as are printed elsewhere


def convert_to_sympy(number: Any, *, degrees: bool = False) -> SympyExpression:
    """The expression that equals a rational, a surd or an Angle, in radians or in degrees; infinity
    for None.

    A ball, which no closed form is known of, becomes a Float of the decimal digits that are
    certain, 40 at most; zero where it contains zero.

    >>> convert_to_sympy(fmpq(2, 3)), convert_to_sympy(Angle(fmpq(1, 6)))
    (2/3, pi/6)
    """
    match number:
        case None:
            return oo
        case Angle():
            return expand(_convert_angle(number) * (180 / pi if degrees else 1))
        case arb():
            return _convert_ball(number)
        case _:
            return expand(_convert_surd(number))


def _convert_surd(number: Any) -> Expr:
    if isinstance(number, PiMultiple):
        return _convert_surd(number.coefficient) * pi**number.power
    if isinstance(number, Surd):
        root = sqrt(_convert_surd(number.root.radicand))
        return _convert_surd(number.a) + _convert_surd(number.b) * root
    return _convert_rational(fmpq(number))


def _convert_rational(number: fmpq) -> Rational:
    return Rational(int(number.p), int(number.q))


def _convert_angle(angle: Angle) -> Expr:
    total = pi * _convert_rational(angle.half_turns)
    for factor, (x, y) in angle.parts:
        total += _convert_rational(factor) * atan2(_convert_surd(y), _convert_surd(x))
    return total


def _convert_ball(ball: arb) -> Float:
    if 0 in ball:
        return Integer(0)
    digits = min(floor(ball.rel_accuracy_bits() * log10(2)), _DIGITS)
    return Float(_convert_rational(ball.mid().fmpq()), max(digits, 1))
