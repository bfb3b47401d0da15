"""Units in which Canvas keeps an answer: it rounds what students type to four decimals."""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction

from kinegrade.exam.quiz_document import QuizAsk

KEPT = Fraction(1, 10**4)  # the last decimal that Canvas keeps
SMALLEST = 10 * KEPT  # a right answer, not zero, of which two decimals are left at least
FINER = {"km": ("m", 1000), "m": ("mm", 1000), "cm": ("mm", 10)}  # exact powers of ten
_LENGTH_FIRST = re.compile(
    r"(km|m|cm)(?![\^a-z])"
)  # a length to the first power leads: m, m/s, cm/s^2


def fits(ask: QuizAsk) -> bool:
    """Whether four decimals are enough: for the answer, and for what counts as right on either side of it."""
    if ask.low == ask.high:
        return (ask.value / KEPT).denominator == 1
    return (_wide_enough(ask) or _kept(ask.low, ask.high)) and (
        ask.value == 0 or abs(ask.value) >= SMALLEST
    )


def _wide_enough(ask: QuizAsk) -> bool:
    return min(ask.value - ask.low, ask.high - ask.value) >= KEPT


def _kept(low: Fraction, high: Fraction) -> bool:
    """Whether rounding to four decimals makes nothing wrong that is right, for the bounds are kept as they are."""
    return high - low >= 2 * KEPT and all((bound / KEPT).denominator == 1 for bound in (low, high))


def fitted(ask: QuizAsk) -> QuizAsk | None:
    """The ask in its own unit where that fits, else in the nearest finer one that does; None where none does."""
    if fits(ask):
        return ask
    found = _LENGTH_FIRST.match(ask.unit)
    if found is None:
        return None
    finer, factor = FINER[found[1]]
    return fitted(
        replace(
            ask,
            unit=finer + ask.unit[found.end() :],
            value=ask.value * factor,
            low=ask.low * factor,
            high=ask.high * factor,
            mistakes=(),
        )
    )
