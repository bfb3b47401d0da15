"""The commonest answers that are no plain numbers, taken apart at a glance: a decimal number with a
point or a comma and what stands behind it, as a rule its unit.
"""

from __future__ import annotations

import re
from fractions import Fraction
from typing import NamedTuple

from kinegrade.grading.typed.number_text import MOST_DIGITS, DecimalStyle

_WHOLE, _DECIMALS = rf"0|[1-9][0-9]{{0,{MOST_DIGITS // 2 - 1}}}", rf"[0-9]{{1,{MOST_DIGITS // 2}}}"
# What follows begins so that it cannot go on with the number
_REST = r"(?: ?[^\W\d_][^\n]{0,40})?"
_COMMON = re.compile(rf"(-?)({_WHOLE})(?:([.,])({_DECIMALS}))?({_REST})")
_GROUP = 3  # digits: a mark before so many may be read in two ways


class NumberAndUnit(NamedTuple):
    """A number with its sign, in plain digits, and what was typed behind it."""

    digits: str
    sign: str
    rest: str

    @property
    def value(self) -> Fraction:
        """The number itself."""
        whole, _, decimals = self.digits.partition(".")
        return Fraction(int(f"{whole}{decimals}"), 10 ** len(decimals))


def split_unit(typed: str, style: DecimalStyle) -> NumberAndUnit | None:
    """A text taken apart; None where it is of another kind, or its mark can be read in two ways.

    >>> split_unit("-0,25 m/s", DecimalStyle())
    NumberAndUnit(digits='-0.25', sign='-', rest=' m/s')
    >>> split_unit("1,234", DecimalStyle()), split_unit("about 2", DecimalStyle())
    (None, None)
    """
    found = _COMMON.fullmatch(typed)
    if found is None:
        return None
    sign, whole, mark, decimals, rest = found.groups("")
    if len(decimals) == _GROUP and not _is_decimal_mark(mark, style):
        return None
    return NumberAndUnit(f"{sign}{whole}{decimals and '.'}{decimals}", sign, rest)


def _is_decimal_mark(mark: str, style: DecimalStyle) -> bool:
    """Whether a mark before three digits certainly stands before decimals."""
    if mark == ",":
        return style.comma == "decimal" and not style.comma_reason
    return style.point == "decimal" and not style.point_reason
