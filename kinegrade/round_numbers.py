"""Round numbers: few leading figures times a power of ten, next to a number, exactly."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import floor, log10

STEPS: Sequence[int | Fraction] = (1, 2, 5)


def round_down(number: Fraction, figures: Sequence[int | Fraction] = STEPS) -> Fraction:
    """The largest round number that is not above a positive number. `figures` ascend from 1 and
    are below 10.

    >>> round_down(Fraction("0.0198")), round_down(Fraction("0.5"))
    (Fraction(1, 100), Fraction(1, 2))
    """
    decade = _find_decade(number)
    return max(figure * decade for figure in figures if figure * decade <= number)


def round_up(number: Fraction, figures: Sequence[int | Fraction] = STEPS) -> Fraction:
    """The smallest round number that is not below a positive number. `figures` ascend from 1 and
    are below 10.

    >>> round_up(Fraction("0.0198")), round_up(Fraction(6))
    (Fraction(1, 50), Fraction(10, 1))
    """
    decade = _find_decade(number)
    return min(figure * decade for figure in (*figures, 10) if figure * decade >= number)


def _find_decade(number: Fraction) -> Fraction:
    """The largest power of ten that is not above a positive number."""
    decade = Fraction(10) ** floor(log10(number))
    if decade > number:
        return decade / 10
    return decade * 10 if decade * 10 <= number else decade
