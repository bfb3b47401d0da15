"""Significant figures of exact numbers: the interval that agrees with a number to so many
figures.
"""

from __future__ import annotations

from fractions import Fraction
from math import ceil, floor


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
