"""The maximum of an item where a download does not state it, but has grades in points and in per
cent side by side.

Moodle's gradebook is such a file. `implied_maximum` is called by
`kinegrade.lms.grades.item_columns`.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from math import ceil

_HALF_A_PLACE = Fraction(1, 200)  # points and per cent are rounded to two decimals
_STEP = Fraction(1, 2)  # maxima are whole numbers or halves
_NARROW = Fraction(1, 10)  # points: a wider range of possible maxima decides nothing


def implied_maximum(grades: Iterable[tuple[Fraction, Fraction]]) -> Fraction | None:
    """The maximum that all grades, each in points and in per cent, agree with; None where they do
    not determine one.

    >>> implied_maximum([(Fraction("2.94"), Fraction("29.41"))])
    Fraction(10, 1)
    """
    stated = [
        (points, share)
        for points, share in grades
        if points > _HALF_A_PLACE and share > _HALF_A_PLACE
    ]
    if not stated:
        return None
    least = max(
        100 * (points - _HALF_A_PLACE) / (share + _HALF_A_PLACE) for points, share in stated
    )
    most = min(100 * (points + _HALF_A_PLACE) / (share - _HALF_A_PLACE) for points, share in stated)
    found = ceil(least / _STEP) * _STEP
    return found if least <= found <= most <= least + _NARROW else None
