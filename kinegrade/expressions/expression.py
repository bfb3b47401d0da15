"""Safe reading of arithmetic: with a small grammar, bounded in size and power, never with Python's
`eval`.

    sum     = product (("+" | "-") product)*
    product = signed (("*" | "/") signed)*
    signed  = ("+" | "-") signed | power
    power   = atom ["**" signed]
    atom    = number | name | name "(" [sum ("," sum)*] ")" | "(" sum ["," sum] ")"

`read_expression` gives a tree, `evaluate` computes its value in any arithmetic (`Field`, `Balls`,
`Floats`). Templates, the command line and the key are read with it; points and constructions are
names and calls like any other.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Literal, TypeVar, assert_never

from flint import fmpq

from kinegrade.errors import ExpressionError
from kinegrade.expressions.faults import (
    SLIPS,
    explain_no_value,
    explain_unknown_function,
    explain_unknown_name,
)
from kinegrade.language.message import Message, Quoted, Text
from kinegrade.numbers.angle import Inexact
from kinegrade.numbers.number import Arithmetic
from kinegrade.numbers.surd import MAX_HEIGHT, Surd, height

MAX_LENGTH = 400
MAX_DEPTH = 40
_MAX_DIGITS = 60
_MAX_POWER = 16
_TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d{1,2})?)"
    r"|(?P<name>[A-Za-z_]\w*)|(?P<mark>\*\*|[-+*/(),]))",
    re.ASCII,
)
Mark = Literal["+", "-", "*", "/"]
Operator = Literal["+", "-", "*", "/", "**"]
SUMS: tuple[Mark, ...] = ("+", "-")
PRODUCTS: tuple[Mark, ...] = ("*", "/")
_Taken = TypeVar("_Taken", bound=str)


@dataclass(frozen=True)
class Number:
    """A rational literal."""

    value: Any


@dataclass(frozen=True)
class Name:
    """A parameter, a point, a body or `pi`."""

    name: str


@dataclass(frozen=True)
class Operation:
    """left sign right; sign is one of + - * / **."""

    sign: Operator
    left: Expression
    right: Expression


@dataclass(frozen=True)
class Call:
    """A function or construction applied to its arguments; the pair (x, y) is the call of ""."""

    function: str
    arguments: tuple[Expression, ...]


Expression = Number | Name | Operation | Call


def list_parts(tree: Expression) -> tuple[Expression, ...]:
    """The direct parts of an expression, in order; none for a number or a name."""
    match tree:
        case Number() | Name():
            return ()
        case Operation(left=left, right=right):
            return (left, right)
        case Call(arguments=arguments):
            return arguments
        case _:
            assert_never(tree)


def walk(tree: Expression) -> Iterator[Expression]:
    """The expression itself and, depth first, all its parts."""
    yield tree
    for part in list_parts(tree):
        yield from walk(part)


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
                expected=SLIPS.get(self.token, expected),
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
            return Call(token, self.arguments(depth)) if self.take("(") else Name(token)
        if self.take("("):
            parts = self.arguments(depth)
            if len(parts) not in (1, 2):
                raise self.fail(Message("expression.value-or-pair"))
            return parts[0] if len(parts) == 1 else Call("", parts)
        raise self.fail(Message("expression.number-name-or-bracket"))

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


def find_names(tree: Expression) -> Iterator[str]:
    """The names (not the functions) that occur, in order."""
    return (part.name for part in walk(tree) if isinstance(part, Name))


def evaluate(
    tree: Expression,
    values: Mapping[str, Any],
    functions: Mapping[str, Callable[..., Any]],
    arithmetic: Arithmetic,
) -> Any:
    """The value of the tree; `values` gives the known names, `functions` what may be called.

    Raises ExpressionError for unknown names and functions, wrong numbers of arguments, division by
    zero, roots of negative numbers and combinations that make no sense (a point plus a number);
    Inexact for exact values that no small field contains.
    """
    match tree:
        case Number():
            return arithmetic.number(tree.value)
        case Name():
            if tree.name not in values:
                raise ExpressionError(explain_unknown_name(tree.name, values))
            return values[tree.name]
        case Call():
            arguments = [evaluate(part, values, functions, arithmetic) for part in tree.arguments]
            return _call_function(tree.function, arguments, functions)
        case Operation(sign=sign):
            left = evaluate(tree.left, values, functions, arithmetic)
            match sign:
                case "**":
                    return _raise_power(left, tree.right, arithmetic)
                case "+" | "-" | "*" | "/":
                    right = evaluate(tree.right, values, functions, arithmetic)
                    return _combine(sign, left, right, tree)
                case _:
                    assert_never(sign)
        case _:
            assert_never(tree)


def _call_function(
    name: str, arguments: list[Any], functions: Mapping[str, Callable[..., Any]]
) -> Any:
    """A function's value; its errors become ExpressionErrors."""
    if not name and name not in functions:
        raise ExpressionError(Message("expression.pair"))
    if name not in functions:
        raise ExpressionError(explain_unknown_function(name, filter(None, functions)))
    try:
        return functions[name](*arguments)
    except (TypeError, AttributeError) as error:
        function = name or Message("expression.a-pair")
        raise ExpressionError(Message("expression.arguments", function=function)) from error
    except ValueError as error:
        reason = explain_no_value(error)
        raise ExpressionError(
            Message("expression.no-value", function=name, reason=reason)
        ) from error
    except ZeroDivisionError as error:
        raise ExpressionError(Message("expression.zero-in-function", function=name)) from error


def _raise_power(base: Any, exponent: Expression, arithmetic: Arithmetic) -> Any:
    """base ** whole number, at most MAX_POWER in size. Raises Inexact where the digits would grow
    without bound.
    """
    power = read_whole_power(exponent)
    negative, size = power < 0, abs(power)
    if isinstance(base, (fmpq, Surd)) and height(base) * size > MAX_HEIGHT:
        raise Inexact  # a power of too many digits
    try:
        raised = base**size
    except TypeError as error:
        raise ExpressionError(Message("expression.power-of-no-number")) from error
    except OverflowError as error:
        raise ExpressionError(Message("expression.power-too-large")) from error
    return _combine("/", arithmetic.number(fmpq(1)), raised, exponent) if negative else raised


def read_whole_power(exponent: Expression) -> int:
    """The whole number of an exponent. Raises ExpressionError for anything else, and for more than
    MAX_POWER.
    """
    negative = (
        isinstance(exponent, Operation)
        and exponent.sign == "-"
        and exponent.left == Number(fmpq(0))
    )
    literal = exponent.right if negative and isinstance(exponent, Operation) else exponent
    if not isinstance(literal, Number) or literal.value.q != 1 or literal.value > _MAX_POWER:
        raise ExpressionError(Message("expression.no-whole-power", most=_MAX_POWER))
    return -int(literal.value) if negative else int(literal.value)


def _combine(mark: Mark, left: Any, right: Any, tree: Expression) -> Any:
    """left mark right for + - * /."""
    try:
        match mark:
            case "+":
                return left + right
            case "-":
                return -right if is_literal_zero(tree) else left - right
            case "*":
                return left * right
            case "/":
                return left / right
            case _:
                assert_never(mark)
    except ZeroDivisionError as error:
        raise ExpressionError(Message("expression.division-by-zero")) from error
    except (TypeError, AttributeError) as error:
        raise ExpressionError(Message("expression.not-together", mark=Quoted(mark))) from error


def is_literal_zero(tree: Expression) -> bool:
    """Whether the tree is the zero of a sign: 0 - x, which points and vectors may have too."""
    return isinstance(tree, Operation) and tree.left == Number(fmpq(0))


def make_elementary_functions(arithmetic: Arithmetic) -> dict[str, Callable[..., Any]]:
    """The functions of numbers and angles, in one arithmetic."""

    def tangent(angle: Any) -> Any:
        return arithmetic.sin(angle) / arithmetic.cos(angle)

    def complement(value: Any) -> Any:
        return arithmetic.sqrt(1 - value * value)

    return {
        "sqrt": arithmetic.sqrt,
        "sin": arithmetic.sin,
        "cos": arithmetic.cos,
        "tan": tangent,
        "abs": abs,
        "asin": lambda value: arithmetic.arctangent(value, complement(value)),
        "acos": lambda value: arithmetic.arctangent(complement(value), value),
        "atan": lambda value: arithmetic.arctangent(value, arithmetic.number(1)),
        "atan2": arithmetic.arctangent,
    }
