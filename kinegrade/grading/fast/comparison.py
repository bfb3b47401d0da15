"""The fast twin of `judging.judge.judge`: thousands of numbers compared with thousands of right
answers at once, in double precision, and which results are certain.

`block_judge` uses it; whatever is not certain is decided by `judge`. A comparison is certain if its
verdict, and every digit of its reason, would be the same for all numbers within the error of double
precision. So the outcome is always the exact one.
"""

from __future__ import annotations

from collections.abc import Sequence
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
from kinegrade.grading.fast.reasons import Form, Forms

_DIGITS = 6  # significant digits in a reason
_ALIKE = 1e-5  # a difference and a tolerance this close may be written with the same digits


@dataclass(frozen=True, slots=True)
class Comparison:
    """The outcome of comparing: `right` is valid where `decided` holds, and `reasons` where
    `certain` holds.
    """

    right: Flags
    decided: Flags
    certain: Flags
    centres: Numbers
    difference: Numbers
    bounds: Bounds

    def reasons(self, places: Places, forms: Forms) -> list[str]:
        """The comparisons at these places in words, exactly as `judge` words them."""
        bounds = self.bounds
        known = self.centres, self.difference, bounds.room, bounds.low, bounds.high
        numbers = [each[places] for each in known]
        if not bounds.to_figures.any():
            return _write_all(forms.within, numbers, len(places))
        rows = np.column_stack(numbers).tolist()
        return [
            _write_one(forms.to_figures if figures else forms.within, row)
            for figures, row in zip(bounds.to_figures[places].tolist(), rows, strict=True)
        ]


def compare(values: Numbers, centres: Numbers, rules: Rules) -> Comparison:
    """Compares each value with the right one beside it; nothing is certain of a value that is not a
    number.
    """
    bounds = rules.bounds(centres)
    with np.errstate(all="ignore"):  # overflow and NaN are simply not certain
        difference, scale = np.abs(values - centres), np.abs(centres) + np.abs(values)
        from_bound = np.abs(difference - bounds.room)
        decided = bounds.settled & np.isfinite(difference)
        decided &= from_bound > np.maximum(_ALIKE * bounds.room, GUARD * scale)
        alike = _are_written_alike(difference, ROUNDING * scale)
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
    power = _DIGITS - 1 - np.floor(np.log10(numbers))
    last = numbers * 10.0**power
    from_half = np.abs(last - np.floor(last) - 0.5)
    certain: Flags = (from_half > error * 10.0**power + HALF) & (error * 10.0**power < 1)
    certain |= (numbers == 0) & (error == 0)
    return certain


def _write_all(form: Form, numbers: Sequence[Numbers], count: int) -> list[str]:
    """One text for each row, filled in together."""
    listed: list[float] = np.column_stack([numbers[each] for each in form.order]).ravel().tolist()
    return str(f"{form.text}\n" * count % tuple(listed)).splitlines()


def _write_one(form: Form, row: Sequence[float]) -> str:
    return form.text % tuple([row[each] for each in form.order])
