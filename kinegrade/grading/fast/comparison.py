"""The fast twin of `judging.judge.judge`: thousands of numbers compared with thousands of right
answers at once, in double precision, and which results are certain.

`block_judge` uses it; whatever is not certain is decided by `judge`. A comparison is certain if its
verdict, and every digit of its reason, would be the same for all numbers within the error of double
precision. So the outcome is always the exact one. Decimals are subtracted exactly where that error
is too large for the digits: an answer as round as the key differs by nothing.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from kinegrade.grading.fast.bounds import (
    GUARD,
    HALF,
    ROUNDING,
    Bounds,
    Flags,
    Numbers,
    Places,
    Rules,
)
from kinegrade.grading.fast.decimals import find_differences
from kinegrade.grading.fast.number_texts import scale_numbers

Decimals = Callable[[Places], Flags]
_ALIKE = 1e-5  # a difference and a tolerance this close may be written with the same digits


@dataclass(frozen=True, slots=True)
class Comparison:
    """The outcome of comparing: `right` is valid where `decided` holds, and the numbers
    that are `stated` where `certain` holds.
    """

    right: Flags
    decided: Flags
    certain: Flags
    centres: Numbers
    difference: Numbers
    bounds: Bounds

    @property
    def stated(self) -> Numbers:
        """The numbers that reasons state, a row for each of those that `reasons.Form` counts."""
        bounds = self.bounds
        return np.stack([self.centres, self.difference, bounds.room, bounds.low, bounds.high])


def compare(values: Numbers, centres: Numbers, rules: Rules, decimals: Decimals) -> Comparison:
    """Compares each value with the right one beside it; nothing is certain of a value that is not a
    number. `decimals` says of places whether both are next to decimals of few digits.
    """
    bounds = rules.bounds(centres)
    with np.errstate(all="ignore"):  # overflow and NaN are simply not certain
        difference, scale = np.abs(values - centres), np.abs(centres) + np.abs(values)
        from_bound = np.abs(difference - bounds.room)
        decided = bounds.settled & np.isfinite(difference)
        decided &= from_bound > np.maximum(_ALIKE * bounds.room, GUARD * scale)
        alike = _are_written_alike(difference, ROUNDING * scale)
        doubtful = np.flatnonzero(decided & ~alike)
        doubtful = doubtful[decimals(doubtful)]
        exactly = find_differences(values[doubtful], centres[doubtful])
        difference[doubtful], alike[doubtful] = exactly
        alike &= _are_written_alike(bounds.room, ROUNDING * bounds.room)
        if bounds.to_figures.any():
            for bound in (bounds.low, bounds.high):
                decided &= np.abs(values - bound) > GUARD * scale
                error = ROUNDING * (np.abs(bound) + np.abs(centres))
                alike &= _are_written_alike(np.abs(bound), error) | ~bounds.to_figures
        right = (bounds.low <= values) & (values <= bounds.high)
    return Comparison(right, decided, decided & alike, centres, difference, bounds)


def _are_written_alike(numbers: Numbers, error: Numbers) -> Flags:
    """Whether everything within the error of a number is written with the same six digits; for
    zero, only if it is exact.
    """
    scaled = scale_numbers(numbers)
    last, most = scaled.last, error * scaled.unit
    from_half = np.abs(last - np.floor(last) - 0.5)
    certain: Flags = scaled.known & (from_half > most + HALF) & (most < 1)
    certain |= (numbers == 0) & (error == 0)
    return certain
