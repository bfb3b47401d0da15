"""Exact numbers as decimals of so many significant digits, rounded only where digits are too few."""

from __future__ import annotations

from decimal import ROUND_CEILING, ROUND_FLOOR, ROUND_HALF_EVEN, Context, Decimal
from fractions import Fraction
from functools import lru_cache
from typing import Literal

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
