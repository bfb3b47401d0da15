"""Numbers as learning management systems read them in any language: a decimal point, no thousands,
no power of ten.
"""

from __future__ import annotations

from decimal import ROUND_CEILING, ROUND_FLOOR, ROUND_HALF_EVEN, Context, Decimal
from fractions import Fraction
from functools import lru_cache
from typing import Literal

_DIGITS = 17  # as many as it takes to distinguish doubles
Rounding = Literal["nearest", "down", "up"]
_ROUNDINGS: dict[Rounding, str] = {
    "nearest": ROUND_HALF_EVEN,
    "down": ROUND_FLOOR,
    "up": ROUND_CEILING,
}


def write_decimal(number: Fraction, rounding: Rounding = "nearest", digits: int = _DIGITS) -> str:
    """A number with that many significant digits: exactly where they are enough, otherwise rounded.

    "down" is towards minus infinity.

    >>> write_decimal(Fraction(-5, 2)), write_decimal(Fraction(1, 3))
    ('-2.5', '0.33333333333333333')
    >>> write_decimal(Fraction(1, 3), "up")
    '0.33333333333333334'
    """
    quotient = _divide(number, rounding, digits)
    return f"{quotient:f}" if quotient else "0"


def round_to_digits(number: Fraction, rounding: Rounding, digits: int) -> Fraction:
    """A number rounded to that many significant digits.

    >>> round_to_digits(Fraction(2, 3), "up", 2)
    Fraction(67, 100)
    """
    return Fraction(_divide(number, rounding, digits))


def _divide(number: Fraction, rounding: Rounding, digits: int) -> Decimal:
    context = _make_context(rounding, digits)
    quotient = context.divide(Decimal(number.numerator), Decimal(number.denominator))
    return quotient.normalize(context)


@lru_cache(maxsize=16)
def _make_context(rounding: Rounding, digits: int) -> Context:
    return Context(prec=digits, rounding=_ROUNDINGS[rounding])
