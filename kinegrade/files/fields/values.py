"""Readers of single values: each gives the value of a key, typed and exact, or raises FieldError.

`Table` calls them and notes where the refused values stand.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from datetime import date, time
from fractions import Fraction
from typing import TypeVar

from kinegrade.errors import FieldError
from kinegrade.files.fields.digits import Digits
from kinegrade.language.lines import shorten
from kinegrade.language.message import Message, Part, Text, list_choices

_Value = TypeVar("_Value")
_Word = TypeVar("_Word", bound=str)
Read = Callable[[object], _Value]

_LONGEST_SHOWN = 80
_DECIMAL = r"[0-9]{1,9}(?:\.[0-9]{1,12})?"
_AMOUNT = re.compile(_DECIMAL)
_PERCENTAGE = re.compile(rf"({_DECIMAL})\s*%")
_RATIO = re.compile(r"([0-9]{1,15})\s*/\s*([0-9]{0,14}[1-9][0-9]{0,14})")


def text(value: object) -> str:
    """A text that is not blank."""
    if isinstance(value, str) and not isinstance(value, Digits) and value.strip():
        return value
    raise FieldError(found(value), Message("fields.a-text"))


def flag(value: object) -> bool:
    """True or false."""
    if isinstance(value, bool):
        return value
    raise FieldError(found(value), Message("fields.true-or-false"))


def whole(least: int, most: int) -> Read[int]:
    """A reader of whole numbers from `least` to `most`."""

    def read(value: object) -> int:
        if isinstance(value, int) and not isinstance(value, bool) and least <= value <= most:
            return value
        raise FieldError(found(value), Message("fields.a-whole-number", least=least, most=most))

    return read


def amount(value: object) -> Fraction:
    """A number of zero or more, exactly.

    >>> amount(3), amount(Digits("0.10"))
    (Fraction(3, 1), Fraction(1, 10))
    """
    written = _written(value)
    if _AMOUNT.fullmatch(written):
        return Fraction(written)
    raise FieldError(found(value), Message("fields.an-amount"))


def share(value: object) -> Fraction:
    """A share from 0 to 1, exactly.

    >>> share(Digits("0.5")), share("50 %"), share("1/2")
    (Fraction(1, 2), Fraction(1, 2), Fraction(1, 2))
    """
    part = _part(_written(value))
    if part is not None and part <= 1:
        return part
    raise FieldError(found(value), Message("fields.a-share"))


def choice(words: Sequence[_Word], otherwise: Text = "") -> Read[_Word]:
    """A reader of one word out of several; `otherwise` says what else is allowed there."""
    choices: Sequence[Part] = [*words, otherwise] if otherwise else words
    expected = Message("fields.one-of", choices=list_choices(choices))

    def read(value: object) -> _Word:
        for word in words:
            if value == word:
                return word
        raise FieldError(found(value), expected)

    return read


def date_text(value: object) -> str:
    """A date as it will be printed: a text, or a TOML date."""
    if isinstance(value, date):
        return str(value)
    if isinstance(value, str) and not isinstance(value, Digits):
        return value
    raise FieldError(found(value), Message("fields.a-date"))


def found(value: object) -> Text:
    """What stands in a file, as messages show it: texts in quotation marks; of tables and lists
    only the kind.

    >>> found("1 %"), found(True), found([1])
    ('"1 %"', 'true', Message('fields.a-list'))
    """
    match value:
        case bool():
            return str(value).lower()
        case Digits() | int() | date() | time():
            return shorten(str(value), _LONGEST_SHOWN)
        case str():
            return f'"{shorten(value, _LONGEST_SHOWN)}"'
        case dict():
            return Message("fields.a-table")
        case list():
            return Message("fields.a-list")
        case _:
            return Message("fields.nothing")


def _written(value: object) -> str:
    """The digits of a number, or a text that may spell one; "" for anything else."""
    plain = isinstance(value, str | int) and not isinstance(value, bool)
    return str(value).strip() if plain else ""


def _part(written: str) -> Fraction | None:
    if _AMOUNT.fullmatch(written):
        return Fraction(written)
    if percentage := _PERCENTAGE.fullmatch(written):
        return Fraction(percentage[1]) / 100
    if ratio := _RATIO.fullmatch(written):
        return Fraction(int(ratio[1]), int(ratio[2]))
    return None
