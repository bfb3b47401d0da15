"""Differences of decimals of few digits, rightly rounded to doubles, where the difference of their
doubles is not: what is equal differs by nothing, and a half is a half.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from kinegrade.grading.fast.bounds import Flags, Numbers
from kinegrade.numbers.decimals import FEW_DIGITS

_FEW = 10.0**FEW_DIGITS
_WHOLE = 2.0**53  # below it, every whole number is a double
_TENS = 10.0 ** np.arange(FEW_DIGITS + 1)


class _Decimals(NamedTuple):
    """Whole numbers `digits` of units of the last of so many `places`, where they are `known`."""

    digits: Numbers
    places: Numbers
    known: Flags


def find_differences(some: Numbers, others: Numbers) -> tuple[Numbers, Flags]:
    """How far numbers are from others, all of them the doubles next to decimals of at most fifteen
    digits, and where that is known: it is not where digits lie too far apart.

    >>> find_differences(np.array([0.3, 1.62]), np.array([0.1, 1.62]))[0].tolist()
    [0.2, 0.0]
    """
    first, second = _read_decimals(some), _read_decimals(others)
    places = np.maximum(first.places, second.places)
    scaled = [
        each.digits * _TENS[(places - each.places).astype(np.intp)] for each in (first, second)
    ]
    known = first.known & second.known
    for each in scaled:
        known &= np.abs(each) < _WHOLE
    return np.abs(scaled[0] - scaled[1]) / _TENS[places.astype(np.intp)], known


def _read_decimals(numbers: Numbers) -> _Decimals:
    """The decimals: those with the fewest places whose nearest doubles these numbers are, as whole
    numbers and powers of ten are divided with right rounding.
    """
    digits, places = np.zeros_like(numbers), np.zeros_like(numbers)
    open_to = np.arange(len(numbers))
    for count, power in enumerate(_TENS):
        whole = np.rint(numbers[open_to] * power)
        found = (whole / power == numbers[open_to]) & (np.abs(whole) < _FEW)
        digits[open_to[found]], places[open_to[found]] = whole[found], count
        open_to = open_to[~found]
        if not len(open_to):
            break
    known = np.ones(len(numbers), dtype=np.bool_)
    known[open_to] = False
    return _Decimals(digits, places, known)
