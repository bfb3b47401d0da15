"""What a parser may make of a file: numbers digit by digit, and nothing absurdly large or deep."""

from __future__ import annotations

from collections.abc import Iterable

MOST_DIGITS = 60  # of a whole number
DEEPEST = 30  # no file of ours nests deeper than eight
TOO_DEEP = "nested too deeply: write it more simply"
TOO_LARGE = f"a whole number of more than {MOST_DIGITS} digits: round it"


class Digits(str):
    """A number with a point or a power of ten, digit by digit as it stands in the file; "nan" and
    "inf" too.
    """

    __slots__ = ()


class Unbounded(ValueError):
    """A content that is nested too deeply or holds an absurdly large number; the message says
    which.
    """


def require_bounded(content: object) -> None:
    """Raises Unbounded where tables and lists are nested deeper than DEEPEST, or a whole number has
    more than MOST_DIGITS digits.
    """
    level = [content]
    for _ in range(DEEPEST):
        parts = [part for outer in level for part in _parts(outer)]
        if any(isinstance(part, int) and abs(part) >= 10**MOST_DIGITS for part in parts):
            raise Unbounded(TOO_LARGE)
        level = [part for part in parts if isinstance(part, dict | list)]
    if level:
        raise Unbounded(TOO_DEEP)


def _parts(value: object) -> Iterable[object]:
    """What stands directly in a table or a list."""
    match value:
        case dict():
            return value.values()
        case list():
            return value
        case _:
            return ()
