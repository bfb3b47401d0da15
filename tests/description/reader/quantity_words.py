"""Quantities as they are asked, `along(velocity(B), B - A)`, taken apart."""

from __future__ import annotations

import re
from dataclasses import dataclass

TOKEN = re.compile(r"\s*(->|\*\*|\d+(?:\.\d+)?|[A-Za-z_][\w']*|[-+*/(),])")


@dataclass(frozen=True)
class Call:
    """A function of its arguments; a pair of coordinates is a function without name."""

    function: str
    arguments: tuple[Word, ...]


@dataclass(frozen=True)
class Operation:
    """Two quantities with a sign between them."""

    sign: str
    first: Word
    second: Word


@dataclass(frozen=True)
class Name:
    """The name of a point, a body, a number or a side."""

    text: str


@dataclass(frozen=True)
class Constant:
    """A number."""

    value: float


@dataclass(frozen=True)
class Beside:
    """A side of the line from one point to another."""

    side: str
    start: str
    end: str


Word = Call | Operation | Name | Constant | Beside


class QuantityReader:
    """Reads one quantity by recursive descent."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.tokens = self.split(text)
        self.place = 0

    def split(self, text: str) -> list[str]:
        """The tokens of the text."""
        found: list[str] = []
        place = 0
        text = text.strip()
        while place < len(text):
            token = TOKEN.match(text, place)
            if token is None:
                raise ValueError(f"quantity not understood: {text}")
            found.append(token[1])
            place = token.end()
        return found

    def next(self) -> str:
        """The token to come, empty at the end."""
        return self.tokens[self.place] if self.place < len(self.tokens) else ""

    def take(self, *wanted: str) -> str:
        """The token to come where it is one of those wanted, else nothing."""
        token = self.next()
        if wanted and token not in wanted:
            return ""
        self.place += 1
        return token

    def expect(self, wanted: str) -> None:
        """Reads that token."""
        if not self.take(wanted):
            raise ValueError(f"quantity not understood: {self.text} before {self.next()!r}")

    def read(self) -> Word:
        """The whole quantity."""
        found = self.sum()
        if self.next():
            raise ValueError(f"quantity not understood: {self.text} before {self.next()!r}")
        return found

    def sum(self) -> Word:
        """Terms with their signs."""
        found = self.product()
        while sign := self.take("+", "-"):
            found = Operation(sign, found, self.product())
        return found

    def product(self) -> Word:
        """Factors."""
        found = self.signed()
        while sign := self.take("*", "/"):
            found = Operation(sign, found, self.signed())
        return found

    def signed(self) -> Word:
        """A factor with its sign."""
        if self.take("-"):
            return Operation("*", Constant(-1.0), self.signed())
        return self.power()

    def power(self) -> Word:
        """A quantity with its exponent."""
        found = self.primary()
        return Operation("**", found, self.signed()) if self.take("**") else found

    def primary(self) -> Word:
        """A number, a name, a call, a pair or a group."""
        if self.take("("):
            parts = self.arguments()
            return parts[0] if len(parts) == 1 else Call("", parts)
        token = self.take()
        if token and token[0].isdigit():
            return Constant(float(token))
        if not token or not (token[0].isalpha() or token[0] == "_"):
            raise ValueError(f"quantity not understood: {self.text} at {token!r}")
        if self.take("("):
            return Call(token, self.arguments())
        if self.take("of"):
            start = self.take()
            self.expect("->")
            return Beside(token, start, self.take())
        return Name(token)

    def arguments(self) -> tuple[Word, ...]:
        """What stands between the brackets."""
        found = [self.sum()]
        while self.take(","):
            found.append(self.sum())
        self.expect(")")
        return tuple(found)


def quantity(text: str) -> Word:
    """The quantity that the text stands for."""
    return QuantityReader(text).read()
