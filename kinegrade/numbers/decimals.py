"""Exact numbers to so many significant digits: as decimals, rounded only where digits are too few,
and the interval of the numbers that agree with one.
"""

from __future__ import annotations

from decimal import ROUND_CEILING, ROUND_FLOOR, ROUND_HALF_EVEN, Context, Decimal
from fractions import Fraction
from functools import lru_cache
from math import ceil, floor
from typing import Literal

#: A double keeps every decimal of so many digits.
FEW_DIGITS = 15
Rounding = Literal["nearest", "down", "up"]  # down: towards minus infinity
_ROUNDINGS: dict[Rounding, str] = {
    "nearest": ROUND_HALF_EVEN,
    "down": ROUND_FLOOR,
    "up": ROUND_CEILING,
}


def round_to_decimal(number: Fraction, digits: int, rounding: Rounding = "nearest") -> Decimal:
    """A number with that many significant digits, without zeros at its end.

    >>> round_to_decimal(Fraction(-5, 2), 6), round_to_decimal(Fraction(2, 3), 2, "down")
    (Decimal('-2.5'), Decimal('0.66'))
    """
    context = _make_context(rounding, digits)
    quotient = context.divide(Decimal(number.numerator), Decimal(number.denominator))
    return quotient.normalize(context)


@lru_cache(maxsize=16)
def _make_context(rounding: Rounding, digits: int) -> Context:
    return Context(prec=digits, rounding=_ROUNDINGS[rounding])


def figures_interval(exact: Fraction, figures: int) -> tuple[Fraction, Fraction]:
    """The interval of numbers that agree with a non-zero number to so many significant figures; a
    tie may be rounded either way.

    >>> [float(bound) for bound in figures_interval(Fraction("1.235"), 3)]
    [1.225, 1.245]
    """
    unit = Fraction(10) ** (leading_power(exact) - figures + 1)
    half = Fraction(1, 2)
    return (ceil(exact / unit - half) - half) * unit, (floor(exact / unit + half) + half) * unit


def leading_power(exact: Fraction) -> int:
    """The power of ten of the first significant figure: 2 for 314, -1 for 0.5. Exact at powers of
    ten.
    """
    size = abs(exact)
    power = len(str(size.numerator)) - len(str(size.denominator))  # right, or one too large
    return power if size >= Fraction(10) ** power else power - 1
