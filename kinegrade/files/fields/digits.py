"""What a parser accepts from a file: numbers digit by digit, and nothing absurdly large or deep."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import chain

from kinegrade.language.message import Message

_MOST_DIGITS = 60  # of a whole number
_DEEPEST = 30  # our deepest file has eight levels
TOO_DEEP = Message("fields.too-deep")
TOO_LARGE = Message("fields.too-many-digits", most=_MOST_DIGITS)


class Digits(str):
    """A number with a decimal point or exponent, digit by digit as it stands in the file; also
    "nan" and "inf".
    """

    __slots__ = ()


class Unbounded(ValueError):
    """Content that is too deeply nested, or holds an absurdly large number; `reason` says which."""

    def __init__(self, reason: Message) -> None:
        self.reason = reason
        super().__init__(reason)


def require_bounded(content: object) -> None:
    """Raises Unbounded where tables and lists are nested deeper than DEEPEST, or a whole number has
    more than MOST_DIGITS digits.
    """
    level = [content]
    for _ in range(_DEEPEST):
        parts = chain.from_iterable(map(_parts, level))
        others = [part for part in parts if not isinstance(part, str)]  # most are texts
        if any(isinstance(part, int) and abs(part) >= 10**_MOST_DIGITS for part in others):
            raise Unbounded(TOO_LARGE)
        level = [part for part in others if isinstance(part, dict | list)]
    if level:
        raise Unbounded(TOO_DEEP)


def _parts(value: object) -> Iterable[object]:
    """The items directly inside a table or list."""
    match value:
        case dict():
            return value.values()
        case list():
            return value
        case _:
            return ()
