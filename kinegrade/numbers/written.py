"""Numbers as they stand in files, read exactly and within bounds: the one way from a file to a
fraction.

`Fraction("1e9999999999")` would compute for days for a number that no exam contains. Every reader
of folders, downloads, banks and policies that does not bound its numbers by a pattern calls this.
"""

from __future__ import annotations

import re
from decimal import Decimal
from fractions import Fraction

from kinegrade.errors import FieldError
from kinegrade.language.message import Message, Part, Quoted

_MOST_DIGITS = 600
_LARGEST_POWER = 300  # of ten: the range of doubles
_LONGEST_SHOWN = 40
_NUMBER = re.compile(
    r"[+-]?(?P<whole>[0-9]*)(?:\.(?P<decimals>[0-9]*))?(?:[eE](?P<power>[+-]?[0-9]{1,4}))?"
)
_RATIO = re.compile(r"[+-]?[0-9]+/[0-9]*[1-9][0-9]*")
_LIMIT = Fraction(10**_LARGEST_POWER)


class NumberError(FieldError, ValueError):
    """A text or value that is not a number: what it is and what was expected."""


def read_number(found: object) -> Fraction:
    """A number of JSON, TOML or CSV, a decimal or a plain fraction, exactly; a fraction is one
    already.

    Raises NumberError.

    >>> read_number("-1.25e1"), read_number(0.1), read_number("2/3")
    (Fraction(-25, 2), Fraction(1, 10), Fraction(2, 3))
    """
    if isinstance(found, Fraction):
        return found
    if isinstance(found, bool) or not isinstance(found, str | int | float | Decimal):
        raise _refuse(Quoted(type(found).__name__))
    if isinstance(found, int) and found.bit_length() > 4 * _LARGEST_POWER:
        raise _refuse(Message("exact.whole-number", bits=found.bit_length()))
    text = str(found)
    if len(text) > _MOST_DIGITS or not _is_number(text):
        raise _refuse(Quoted(_cut(text)))
    # A decimal is as exact, in half the time
    value = Fraction(text) if "/" in text else Fraction(Decimal(text))
    if abs(value) > _LIMIT:
        raise _refuse(Quoted(_cut(text)))
    return value


def _refuse(found: Part) -> NumberError:
    expected = Message("exact.number", power=_LARGEST_POWER)
    return NumberError(Message("exact.found", found=found), expected)


def _cut(text: str) -> str:
    """The text, or its beginning."""
    return text if len(text) <= _LONGEST_SHOWN else f"{text[:_LONGEST_SHOWN]}…"


def _is_number(text: str) -> bool:
    """Whether a text spells a number whose power of ten is bounded."""
    if _RATIO.fullmatch(text):
        return True
    match = _NUMBER.fullmatch(text)
    if match is None or not (match["whole"] or match["decimals"]):
        return False
    return abs(int(match["power"] or 0)) <= _LARGEST_POWER + _MOST_DIGITS
