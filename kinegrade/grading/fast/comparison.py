"""Thousands of numbers compared with thousands of keys at once, in double precision, and which
results are certain.

`block_judge` uses it; whatever is not certain is decided exactly by `judge`. A comparison is
certain if its verdict, and every digit of its reason, would be the same for all numbers within the
error of double precision. So the outcome is always the exact one.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinegrade.grading.fast.reasons import Form, Forms
from kinegrade.numbers.tolerance import Tolerance

Numbers = NDArray[np.float64]
Flags = NDArray[np.bool_]

_DIGITS = 6  # significant digits in a reason
_ROUNDING = 1e-15  # relative error of a few operations in double precision, or of reading a number
_GUARD = 1e-9  # of the numbers compared: a bound nearer than this decides nothing
_ALIKE = 1e-5  # a difference and a tolerance this close may be written with the same digits
_HALF = 1e-6  # of the last digit written: anything this close to a half may be rounded either way


@dataclass(frozen=True, slots=True)
class Rules:
    """The rule of each comparison, as numbers; `figures` is 0 where no significant figures are
    asked for.
    """

    relative: Numbers
    absolute: Numbers
    figures: Numbers

    def at(self, places: NDArray[np.int64]) -> Rules:
        """The rules at these places."""
        return Rules(self.relative[places], self.absolute[places], self.figures[places])


def rules_of(papers: Sequence[tuple[Tolerance, ...]]) -> Rules:
    """The rules of these papers as numbers; most papers share one rule, kept as one object."""
    known = {id(rules): rules for rules in papers}
    numbers = {
        name: np.array(
            [
                (float(each.relative), float(each.absolute), float(each.figures or 0))
                for each in rules
            ],
            dtype=np.float64,
        ).reshape(-1, 3)
        for name, rules in known.items()
    }
    table = np.concatenate([np.empty((0, 3)), *(numbers[id(rules)] for rules in papers)])
    return Rules(table[:, 0], table[:, 1], table[:, 2])


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
    tolerance: Numbers
    low: Numbers
    high: Numbers
    figures: Numbers

    def reasons(self, places: NDArray[np.intp], forms: Forms) -> list[str]:
        """The comparisons at these places in words, exactly as `judge` words them."""
        known = self.centres, self.difference, self.tolerance, self.low, self.high
        numbers = [each[places] for each in known]
        if not self.figures.any():
            return _write_all(forms.within, numbers, len(places))
        to_figures = ((self.figures[places] != 0) & (numbers[0] != 0)).tolist()
        rows = np.column_stack(numbers).tolist()
        return [
            _write_one(forms.to_figures if figures else forms.within, row)
            for figures, row in zip(to_figures, rows, strict=True)
        ]


def _write_all(form: Form, numbers: Sequence[Numbers], count: int) -> list[str]:
    """One text for each row, filled in together."""
    listed: list[float] = np.column_stack([numbers[each] for each in form.order]).ravel().tolist()
    return str(f"{form.text}\n" * count % tuple(listed)).splitlines()


def _write_one(form: Form, row: Sequence[float]) -> str:
    return form.text % tuple([row[each] for each in form.order])


def may_agree(values: Numbers, centres: Numbers, rules: Rules) -> Flags:
    """False only where `compare` would certainly find no agreement, at a fraction of its cost."""
    with np.errstate(all="ignore"):
        size = np.abs(centres)
        room = np.maximum(rules.relative * size, rules.absolute)
        if rules.figures.any():
            room += np.where(rules.figures > 0, 11 * size / 10.0**rules.figures, 0)
        beyond: Flags = np.abs(values - centres) > 1.01 * room + 1e-8 * (size + np.abs(values))
    return ~beyond


def compare(values: Numbers, centres: Numbers, rules: Rules) -> Comparison:
    """Compares each value with the right one beside it; nothing is certain of a value that is not a
    number.
    """
    with np.errstate(all="ignore"):  # overflow and NaN are simply not certain
        difference, size = np.abs(values - centres), np.abs(centres)
        tolerance = np.maximum(rules.relative * size, rules.absolute)
        scale = size + np.abs(values)
        low, high = centres - tolerance, centres + tolerance
        decided = np.isfinite(difference)
        decided &= np.abs(difference - tolerance) > np.maximum(_ALIKE * tolerance, _GUARD * scale)
        if rules.figures.any():
            low, high, settled = _to_figures(centres, rules, low, high)
            decided &= (
                settled
                & (np.abs(values - low) > _GUARD * scale)
                & (np.abs(values - high) > _GUARD * scale)
            )
        right = (low <= values) & (values <= high)
        alike = _written_alike(difference, _ROUNDING * scale) & _written_alike(
            tolerance, _ROUNDING * tolerance
        )
    return Comparison(
        right, decided, decided & alike, centres, difference, tolerance, low, high, rules.figures
    )


def _to_figures(
    centres: Numbers, rules: Rules, low: Numbers, high: Numbers
) -> tuple[Numbers, Numbers, Flags]:
    """The bounds where answers have to agree to significant figures, and whether they are
    certain.
    """
    asked = (rules.figures > 0) & (centres != 0)
    power = np.floor(np.log10(np.abs(centres)))
    unit = 10.0 ** (power - rules.figures + 1)
    steps = centres / unit
    smallest = np.minimum(low, (np.ceil(steps - 0.5) - 0.5) * unit)
    largest = np.maximum(high, (np.floor(steps + 0.5) + 0.5) * unit)
    leading = np.abs(centres) / 10.0**power
    settled = (np.abs(steps - np.floor(steps) - 0.5) > _HALF) & (np.abs(steps) * _ROUNDING < _HALF)
    settled &= (leading > 1 + _GUARD) & (leading < 10 - _GUARD)
    for bound in (smallest, largest):
        settled &= _written_alike(np.abs(bound), _ROUNDING * (np.abs(bound) + np.abs(centres)))
    return (np.where(asked, smallest, low), np.where(asked, largest, high), settled | ~asked)


def _written_alike(numbers: Numbers, error: Numbers) -> Flags:
    """Whether everything within the error of a number is written with the same six digits; for
    zero, only if it is exact.
    """
    power = _DIGITS - 1 - np.floor(np.log10(numbers))
    last = numbers * 10.0**power
    from_half = np.abs(last - np.floor(last) - 0.5)
    certain: Flags = (from_half > error * 10.0**power + _HALF) & (error * 10.0**power < 1)
    certain |= (numbers == 0) & (error == 0)
    return certain
