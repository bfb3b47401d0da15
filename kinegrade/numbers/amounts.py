"""How points are added and written: as the shortest decimal with at most four places."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from functools import lru_cache
from math import ceil, lcm

PLACES = 4


def write_amount(amount: Fraction, places: int = PLACES) -> str:
    """The shortest decimal with at most that many places, halves rounded up; amounts are not
    negative.

    >>> write_amount(Fraction(7, 2)), write_amount(Fraction(2, 3))
    ('3.5', '0.6667')
    """
    return _write_amount_once(amount.numerator, amount.denominator, places)


# By whole numbers, because hashing a fraction takes longer than writing it
@lru_cache(maxsize=4096)
def _write_amount_once(numerator: int, denominator: int, places: int) -> str:
    whole, decimals = divmod(
        (2 * numerator * 10**places + denominator) // (2 * denominator), 10**places
    )
    digits = f"{decimals:0{places}d}".rstrip("0")
    return f"{whole}.{digits}" if digits else str(whole)


def write_change(change: Fraction, places: int = PLACES) -> str:
    """A change with its sign: "+1.5", "-2", "0".

    >>> write_change(Fraction(-1, 3))
    '-0.3333'
    """
    size = write_amount(abs(change), places)
    return size if size == "0" else f"{'-' if change < 0 else '+'}{size}"


def bound_rounding(count: int) -> Fraction:
    """How far a written amount may be from the sum of so many written amounts: half of the last
    place for each of them.
    """
    return Fraction(count + 1, 2 * 10**PLACES)


def round_up_amount(amount: Fraction) -> Fraction:
    """An amount rounded up to as many places as are written."""
    return Fraction(ceil(amount * 10**PLACES), 10**PLACES)


def add_amounts(amounts: Iterable[Fraction]) -> Fraction:
    """The sum of the amounts: whole numbers over the common denominator, several times faster than
    adding fractions one by one.
    """
    listed = tuple(amounts)
    common = lcm(*[amount.denominator for amount in listed])
    if common == 1:
        return Fraction(sum([amount.numerator for amount in listed]))
    return Fraction(
        sum([amount.numerator * (common // amount.denominator) for amount in listed]), common
    )
