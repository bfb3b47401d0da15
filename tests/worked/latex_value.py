"""The value of a LaTeX formula, read by the rules of print alone: a second opinion on what a
formula says.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping

TOKEN = re.compile(r"\\(?:left|right)|\\[A-Za-z]+|\\,|\\ |\d+(?:\.\d+)?|[A-Za-z]_\{\w+\}|\S")
FUNCTIONS: Mapping[str, Callable[[float], float]] = {
    r"\sin": math.sin,
    r"\cos": math.cos,
    r"\tan": math.tan,
    r"\arcsin": math.asin,
    r"\arccos": math.acos,
    r"\arctan": math.atan,
}


class Unreadable(Exception):
    """The formula holds something that has no value here."""


def value_of(latex: str, values: Mapping[str, float]) -> float:
    """The value of a formula; `values` gives those of the symbols like `v_{3}`. Raises
    Unreadable.
    """
    bars = latex.replace(r"\left|", "<").replace(r"\right|", ">")
    reader = Reader(
        [
            token
            for token in TOKEN.findall(bars)
            if token not in (r"\,", r"\ ", r"\left", r"\right")
        ],
        values,
    )
    value = reader.sum()
    if reader.tokens:
        raise Unreadable(reader.tokens[0])
    return value


class Reader:
    """Sums of products of powers; a function takes the factors that follow it without a mark in
    between.
    """

    def __init__(self, tokens: list[str], values: Mapping[str, float]) -> None:
        self.tokens, self.values = tokens, values

    def next(self) -> str:
        return self.tokens[0] if self.tokens else ""

    def take(self, *expected: str) -> bool:
        if self.next() in expected:
            self.tokens.pop(0)
            return True
        return False

    def sum(self) -> float:
        total = -self.product() if self.take("-") else self.product()
        while self.next() in ("+", "-"):
            total += self.product() if self.tokens.pop(0) == "+" else -self.product()
        return total

    def product(self) -> float:
        total = self.power()
        while self.next() and self.next() not in ("+", "-", ")", "}", ">"):
            self.take(r"\cdot")
            total *= self.power()
        return total

    def power(self) -> float:
        if self.next() in FUNCTIONS:
            return self.function()
        base = self.atom()
        if self.take("^"):
            if self.next() == r"\circ":
                self.tokens.pop(0)
                return math.radians(base)
            return float(base ** self.group())
        return base

    def function(self) -> float:
        work = FUNCTIONS[self.tokens.pop(0)]
        exponent = self.group() if self.take("^") else 1.0
        if self.next() == "(":
            return float(work(self.atom()) ** exponent)
        argument = self.power()
        while (
            self.next()
            and (self.next()[0].isalpha() or self.next()[0] == "\\")
            and self.next() not in (*FUNCTIONS, r"\cdot", r"\frac", r"\sqrt")
        ):
            argument *= self.power()
        return float(work(argument) ** exponent)

    def group(self) -> float:
        if not self.take("{"):
            return self.atom()
        value = self.sum()
        if not self.take("}"):
            raise Unreadable(self.next())
        return value

    def atom(self) -> float:
        token = self.tokens.pop(0) if self.tokens else ""
        if token in ("(", "<"):
            value = self.sum()
            if not self.take(")" if token == "(" else ">"):
                raise Unreadable(self.next())
            return abs(value) if token == "<" else value
        if token == r"\frac":
            return self.group() / self.group()
        if token == r"\sqrt":
            return math.sqrt(self.group())
        if token == r"\pi":
            return math.pi
        if token[:1].isdigit():
            return float(token)
        if token in self.values:
            return self.values[token]
        raise Unreadable(token)
