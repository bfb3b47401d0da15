"""Numbers as decimals of so many significant digits, certified: rounded half to even."""

from __future__ import annotations

from functools import lru_cache
from math import floor, log10
from typing import Any

from flint import arb, ctx, fmpq

from kinegrade.numbers.angle import Angle
from kinegrade.numbers.surd import Surd, enclose_at_precision

_LOG_TWO = log10(2)
_FURTHER = 12  # digits by which a ball is narrower than the decimals between which it lies


def write_decimal(number: Any, digits: int, degrees: bool = False) -> str:
    """The number rounded to `digits` significant digits, half to even, certified; no exponent
    within 1e-7..1e21.

    Takes rationals, doubles, surds, balls and Angles (in radians, or in degrees). A ball too wide
    for the digits asked is given to as many as it holds; a narrow one about the middle between two
    of these decimals counts as that middle. A ball about zero gives "0".

    >>> write_decimal(fmpq(2, 3), 5)
    '0.66667'
    """
    if isinstance(number, Angle) and degrees and not number.parts:
        number = number.half_turns * 180
    if isinstance(number, float):
        number = fmpq(*number.as_integer_ratio())
    if isinstance(number, fmpq):
        return _write_rounded(number, digits)
    if isinstance(number, Surd):
        return _write_surd(number, digits)
    return _write_certified(number, digits, degrees)


@lru_cache(maxsize=4096)
def _write_surd(number: Surd, digits: int) -> str:
    """A number with roots, of which solutions ask for the same digits again and again."""
    return _write_certified(number, digits)


def _write_certified(number: Any, digits: int, degrees: bool = False) -> str:
    """A number that is no fraction, by bounds that are closer and closer to it."""
    for precision in (64 + 4 * digits, 256 + 8 * digits, 4096):
        low, high = find_bounds(number, precision, degrees)
        rounded = _round(low, digits)
        if rounded == _round(high, digits):
            return _write_whole(*rounded)
        if isinstance(number, arb) and (middle := _find_middle(low, high, digits)) is not None:
            return _write_rounded(middle, digits)
        for count in range(digits, 0, -1):
            text = _write_rounded(low, count)
            if text == _write_rounded(high, count):
                if count == digits or precision == 4096 or isinstance(number, arb):
                    return text
                break
        if low <= 0 <= high and (isinstance(number, arb) or precision == 4096):
            return "0"
    return _write_rounded((low + high) / 2, 1)


def _find_middle(low: Any, high: Any, digits: int) -> Any | None:
    """The number half way between two decimals of so many digits that lies between bounds which
    agree in many more digits; None where the bounds, which are rounded apart, do not.
    """
    whole, exponent = _round(low, digits + _FURTHER)
    agree = (whole, exponent) == _round(high, digits + _FURTHER)
    return whole * fmpq(10) ** exponent if agree else None


def find_bounds(number: Any, precision: int, degrees: bool = False) -> tuple[Any, Any]:
    """Rational bounds of a number, computed with `precision` bits; an Angle in radians or in
    degrees.
    """
    with ctx.workprec(precision):
        value = (
            number
            if isinstance(number, arb)
            else number.ball()
            if isinstance(number, Angle)
            else enclose_at_precision(number)
        )
        value = value * 180 / arb.pi() if degrees and isinstance(number, Angle) else value
        return value.lower().fmpq(), value.upper().fmpq()


def _write_rounded(value: Any, digits: int) -> str:
    """A rational number with `digits` significant digits, half to even; trailing zeros are
    dropped.
    """
    return _write_whole(*_round(value, digits))


def _write_whole(whole: int, exponent: int) -> str:
    """A whole number times a power of ten; trailing zeros are dropped."""
    size = _write_plainly(str(abs(whole)), exponent) if whole else "0"
    return ("-" if whole < 0 else "") + size


def _round(value: Any, digits: int) -> tuple[int, int]:
    """A rational number to `digits` significant digits, half to even, as a whole number times a
    power of ten.
    """
    if value == 0:
        return 0, 0
    above, below = abs(int(value.p)), int(value.q)
    exponent = _find_magnitude(above, below) - digits + 1
    if exponent < 0:
        above *= 10**-exponent
    else:
        below *= 10**exponent
    whole, rest = divmod(above, below)
    if 2 * rest > below or (2 * rest == below and whole % 2):
        whole += 1
    return (-whole if value < 0 else whole), exponent


def _find_magnitude(above: int, below: int) -> int:
    """The decimal exponent of a positive fraction: 10^n <= above/below < 10^(n+1)."""
    guess = floor((above.bit_length() - below.bit_length()) * _LOG_TWO)
    while above * 10 ** max(-guess, 0) < below * 10 ** max(guess, 0):
        guess -= 1
    while above * 10 ** max(-guess - 1, 0) >= below * 10 ** max(guess + 1, 0):
        guess += 1
    return guess


def _write_plainly(digits: str, exponent: int) -> str:
    """Digits times 10^exponent, written plainly, or with an exponent when very large or small."""
    point = len(digits) + exponent
    digits = digits.rstrip("0")
    if not -7 < point <= 21:
        tail = "." + digits[1:] if len(digits) > 1 else ""
        return f"{digits[0]}{tail}e{point - 1}"
    if point <= 0:
        return "0." + "0" * -point + digits
    if len(digits) <= point:
        return digits + "0" * (point - len(digits))
    return digits[:point] + "." + digits[point:]
