"""An expression in other letters: those that count the other way."""

from __future__ import annotations

from collections.abc import Set
from typing import assert_never

from flint import fmpq

from kinegrade.expressions.tree import (
    Call,
    Expression,
    Name,
    Number,
    Operation,
    is_literal_zero,
)


def negate_names(tree: Expression, names: Set[str]) -> Expression:
    """An expression with a minus before each of these names; two of them are none.

    >>> negate_names(Operation("-", Number(fmpq(0)), Name("omega")), {"omega"})
    Name(name='omega')

    A cosine and a square take the letter without the minus.

    >>> negate_names(Call("cos", (Name("phi"),)), {"phi"})
    Call(function='cos', arguments=(Name(name='phi'),))
    """
    match tree:
        case Number():
            return tree
        case Name(name):
            return Operation("-", Number(fmpq(0)), tree) if name in names else tree
        case Operation("-", _, Name(name) as named) if is_literal_zero(tree) and name in names:
            return named
        case Operation("**", left, Number(value)) if value == 2:
            return Operation("**", _drop_minus(negate_names(left, names)), tree.right)
        case Operation(sign, left, right):
            return Operation(sign, negate_names(left, names), negate_names(right, names))
        case Call("cos", (angle,)):
            return Call("cos", (_drop_minus(negate_names(angle, names)),))
        case Call():
            return negate_arguments(tree, names)
        case _:
            assert_never(tree)


def negate_arguments(call: Call, names: Set[str]) -> Call:
    """A call with a minus before each of these names in its arguments."""
    return Call(call.function, tuple(negate_names(part, names) for part in call.arguments))


def _drop_minus(tree: Expression) -> Expression:
    return tree.right if isinstance(tree, Operation) and is_literal_zero(tree) else tree
