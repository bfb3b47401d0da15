"""What a parser accepts from a file: numbers digit by digit, and nothing absurdly large or deep."""

from __future__ import annotations

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
    level: list[object] = [content]
    for _ in range(_DEEPEST):
        tables = [part for part in level if isinstance(part, dict)]
        lists = [part for part in level if isinstance(part, list)]
        parts = chain(chain.from_iterable(map(dict.values, tables)), chain.from_iterable(lists))
        level = [part for part in parts if not isinstance(part, str)]  # most are texts
        if any(isinstance(part, int) and abs(part) >= 10**_MOST_DIGITS for part in level):
            raise Unbounded(TOO_LARGE)
    if any(isinstance(part, dict | list) for part in level):
        raise Unbounded(TOO_DEEP)
