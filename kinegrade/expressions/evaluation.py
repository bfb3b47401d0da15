"""The value of an expression in any arithmetic: `Field`, `Balls` or `Floats`."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, assert_never

from flint import fmpq

from kinegrade.errors import ExpressionError
from kinegrade.expressions.faults import (
    explain_no_value,
    explain_unknown_function,
    explain_unknown_name,
)
from kinegrade.expressions.tree import (
    Call,
    Expression,
    Mark,
    Name,
    Number,
    Operation,
    is_literal_zero,
)
from kinegrade.language.message import Message, Quoted
from kinegrade.numbers.number import Arithmetic
from kinegrade.numbers.pi_multiple import PiMultiple
from kinegrade.numbers.refusals import Inexact
from kinegrade.numbers.surd import MAX_HEIGHT, Surd, height

MAX_POWER = 16


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
    if isinstance(base, (fmpq, Surd, PiMultiple)) and height(base) * size > MAX_HEIGHT:
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
    if not isinstance(literal, Number) or literal.value.q != 1 or literal.value > MAX_POWER:
        raise ExpressionError(Message("expression.no-whole-power", most=MAX_POWER))
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
