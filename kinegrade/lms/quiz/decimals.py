"""Numbers as learning management systems read them in any language: a decimal point, no thousands,
no power of ten.
"""

from __future__ import annotations

from fractions import Fraction

from kinegrade.numbers.decimals import Rounding, round_to_decimal

_DIGITS = 17  # as many as it takes to distinguish doubles


def write_decimal(number: Fraction, rounding: Rounding = "nearest", digits: int = _DIGITS) -> str:
    """A number with that many significant digits: exactly where they are enough, otherwise rounded.

    "down" is towards minus infinity.

    >>> write_decimal(Fraction(-5, 2)), write_decimal(Fraction(1, 3))
    ('-2.5', '0.33333333333333333')
    >>> write_decimal(Fraction(1, 3), "up")
    '0.33333333333333334'
    """
    quotient = round_to_decimal(number, digits, rounding)
    return f"{quotient:f}" if quotient else "0"


def round_to_digits(number: Fraction, rounding: Rounding, digits: int) -> Fraction:
    """A number rounded to that many significant digits.

    >>> round_to_digits(Fraction(2, 3), "up", 2)
    Fraction(67, 100)
    """
    return Fraction(round_to_decimal(number, digits, rounding))
