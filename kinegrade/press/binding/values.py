"""The values that PDF files are made of, read from their text and written as such.

Names, numbers and strings stay as they are spelled: whoever binds files has no need to know more.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple, TypeAlias


class Reference(NamedTuple):
    """Another object of the same file."""

    number: int


Value: TypeAlias = dict[bytes, "Value"] | list["Value"] | Reference | bytes
Dictionary: TypeAlias = dict[bytes, Value]

_INSIDE = rb"[^()\\]++|\\."
#: A string in parentheses, with more of them inside, escaped or not, two deep at most.
STRING = rb"\((?:%b|\((?:%b|\((?:%b)*+\))*+\))*+\)" % (_INSIDE, _INSIDE, _INSIDE)
_TOKEN = re.compile(
    rb"(?P<reference>\d+) 0 R\b|<<|>>|\[|\]|" + STRING + rb"|<[^<>]*>|/?[^\s<>\[\]()/]+", re.DOTALL
)


def read_value(text: bytes) -> Value:
    """The value that a text spells."""
    return _read(_TOKEN.finditer(text))


def read_dictionary(text: bytes) -> Dictionary:
    """The dictionary that a text spells; an empty one where it spells another value."""
    value = read_value(text)
    return value if isinstance(value, dict) else {}


def write_value(value: Value) -> bytes:
    """A text that spells the value."""
    match value:
        case Reference(number):
            return b"%d 0 R" % number
        case dict():
            return b"<<%b>>" % b" ".join(
                b"%b %b" % (key, write_value(each)) for key, each in value.items()
            )
        case list():
            return b"[%b]" % b" ".join(map(write_value, value))
        case bytes():
            return value


def _read(tokens: Iterator[re.Match[bytes]]) -> Value:
    """The next value of a text."""
    token = next(tokens)
    if token["reference"]:
        return Reference(int(token["reference"]))
    match token[0]:
        case b"[":
            return list(_read_until(b"]", tokens))
        case b"<<":
            entries = list(_read_until(b">>", tokens))
            names = [name for name in entries[::2] if isinstance(name, bytes)]
            return dict(zip(names, entries[1::2], strict=True))
        case plain:
            return plain


def _read_until(end: bytes, tokens: Iterator[re.Match[bytes]]) -> Iterator[Value]:
    """The values before the end of what encloses them."""
    while (value := _read(tokens)) != end:
        yield value
