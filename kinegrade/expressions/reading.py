"""Safe reading of arithmetic: with a small grammar, bounded in size and power, never with Python's
`eval`.

    sum     = product (("+" | "-") product)*
    product = signed (("*" | "/") signed)*
    signed  = ("+" | "-") signed | power
    power   = atom ["**" signed]
    atom    = number | name | name "(" [sum ("," sum)*] ")" | "(" sum ["," sum] ")" | side
    side    = ("left" | "right") "of" name "->" name

Templates, the command line and the key are read with it; points and constructions are names and
calls like any other.
"""

from __future__ import annotations

import re
from typing import Any, TypeVar

from flint import fmpq

from kinegrade.errors import ExpressionError
from kinegrade.expressions.faults import (
    SLIPS,
    spell_greek,
)
from kinegrade.expressions.tree import (
    PRODUCTS,
    SIDES_OF,
    SUMS,
    Call,
    Expression,
    Name,
    Number,
    Operation,
)
from kinegrade.language.message import Message, Quoted, Text

MAX_LENGTH = 400
MAX_DEPTH = 40
_MAX_DIGITS = 60
_TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d{1,2})?)"
    r"|(?P<name>[A-Za-z_]\w*)|(?P<mark>\*\*|->|[-+*/(),]))",
    re.ASCII,
)
_Taken = TypeVar("_Taken", bound=str)


def read_expression(text: str) -> Expression:
    """The tree of an expression. Raises ExpressionError with the position and what was expected
    there.

    >>> read_expression("2*(x - 1)").sign
    '*'
    """
    if len(text) > MAX_LENGTH:
        raise ExpressionError(Message("expression.too-long", length=len(text), most=MAX_LENGTH))
    reader = _Reader(text)
    tree = reader.sum(0)
    reader.finish()
    return tree


class _Reader:
    """Recursive descent over one text; `place` is where the next token begins."""

    def __init__(self, text: str) -> None:
        self.text, self.place = text, 0
        self.kind, self.token, self.start = "", "", 0
        self._advance()

    def _advance(self) -> None:
        """Go to the next token; an unknown character is an error."""
        match = _TOKEN.match(self.text, self.place)
        if match is None:
            self.start = len(self.text) - len(self.text[self.place :].lstrip())
            self.kind, self.token = (
                ("end", "") if self.start == len(self.text) else ("unknown", self.text[self.start])
            )
            return
        self.kind, self.token = str(match.lastgroup), str(match.group(str(match.lastgroup)))
        self.start, self.place = match.start(str(match.lastgroup)), match.end()

    def fail(self, expected: Text) -> ExpressionError:
        """The error at this place."""
        return ExpressionError(
            Message(
                "expression.found",
                text=Quoted(self.text),
                place=self.start + 1,
                found=Quoted(self.token) if self.token else Message("expression.end"),
                expected=SLIPS.get(self.token) or spell_greek(self.token) or expected,
            )
        )

    def take(self, *marks: _Taken) -> _Taken | None:
        """The mark at this place if it is one of `marks`, and moves past it; else None."""
        for mark in marks:
            if self.kind == "mark" and self.token == mark:
                self._advance()
                return mark
        return None

    def finish(self) -> None:
        """Raises ExpressionError where anything follows."""
        if self.kind != "end":
            raise self.fail(Message("expression.operator-or-end"))

    def sum(self, depth: int) -> Expression:
        """sum = product (("+" | "-") product)*"""
        if depth > MAX_DEPTH:
            raise ExpressionError(
                Message("expression.too-deep", text=Quoted(self.text), most=MAX_DEPTH)
            )
        tree = self.product(depth)
        while mark := self.take(*SUMS):
            tree = Operation(mark, tree, self.product(depth))
        return tree

    def product(self, depth: int) -> Expression:
        """product = signed (("*" | "/") signed)*"""
        tree = self.signed(depth)
        while mark := self.take(*PRODUCTS):
            tree = Operation(mark, tree, self.signed(depth))
        return tree

    def signed(self, depth: int) -> Expression:
        """signed = ("+" | "-") signed | power"""
        negative = False
        while mark := self.take("+", "-"):
            negative ^= mark == "-"
        tree = self.power(depth)
        return Operation("-", Number(fmpq(0)), tree) if negative else tree

    def power(self, depth: int) -> Expression:
        """power = atom ["**" signed]"""
        base = self.atom(depth)
        return Operation("**", base, self.signed(depth + 1)) if self.take("**") else base

    def atom(self, depth: int) -> Expression:
        """A number, a name, a call, or a pair or sum in brackets."""
        kind, token = self.kind, self.token
        if kind == "number":
            self._advance()
            return Number(read_rational(token))
        if kind == "name":
            self._advance()
            if token in SIDES_OF and (self.kind, self.token) == ("name", "of"):
                return self.side(SIDES_OF[token])
            return Call(token, self.arguments(depth)) if self.take("(") else Name(token)
        if self.take("("):
            parts = self.arguments(depth)
            if len(parts) not in (1, 2):
                raise self.fail(Message("expression.value-or-pair"))
            return parts[0] if len(parts) == 1 else Call("", parts)
        raise self.fail(Message("expression.number-name-or-bracket"))

    def side(self, function: str) -> Expression:
        """The side of a directed line through two named points, as the call of a function."""
        self._advance()
        start = self.name()
        if not self.take("->"):
            raise self.fail(Message("expression.arrow"))
        return Call(function, (start, self.name()))

    def name(self) -> Name:
        """A name."""
        if self.kind != "name":
            raise self.fail(Message("expression.point-name"))
        token = self.token
        self._advance()
        return Name(token)

    def arguments(self, depth: int) -> tuple[Expression, ...]:
        """The arguments up to the closing bracket."""
        if self.take(")"):
            return ()
        parts = [self.sum(depth + 1)]
        while self.take(","):
            parts.append(self.sum(depth + 1))
        if not self.take(")"):
            raise self.fail(Message("expression.comma-or-bracket"))
        return tuple(parts)


def read_rational(digits: str) -> Any:
    """An exact rational from decimal digits, with point and exponent.

    >>> read_rational("1.25e1")
    25/2
    """
    mantissa, _, exponent = digits.lower().partition("e")
    whole, _, decimals = mantissa.partition(".")
    if len(whole) + len(decimals) > _MAX_DIGITS:
        raise ExpressionError(
            Message("expression.too-many-digits", beginning=digits[:20], most=_MAX_DIGITS)
        )
    return fmpq(int(whole + decimals or "0")) * fmpq(10) ** (int(exponent or "0") - len(decimals))
