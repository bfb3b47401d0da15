"""An expression without the quotients x/|x| and the sizes |x| by which templates lay out a
mechanism to either side: a drawn x has a sign, and readers see what follows from it.
"""

from __future__ import annotations

from collections.abc import Callable
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

_ZERO, _ONE = Number(fmpq(0)), Number(fmpq(1))


def fold_signs(tree: Expression, is_negative: Callable[[Expression], bool]) -> Expression:
    """The expression with each factor x/abs(x) and each abs(x) worked out; `is_negative` says so of
    x.

    >>> n = Name("n")
    >>> beside = Operation("/", Operation("*", Name("l"), n), Call("abs", (n,)))
    >>> fold_signs(beside, lambda part: False)
    Name(name='l')
    >>> fold_signs(Operation("-", Name("r"), beside), lambda part: True)
    Operation(sign='+', left=Name(name='r'), right=Name(name='l'))

    >>> fold_signs(Call("abs", (n,)), lambda part: True)
    Operation(sign='-', left=Number(value=0), right=Name(name='n'))

    An angle that is mirrored so is counted from where it is counted usually.

    >>> half = Operation("/", Name("pi"), Number(fmpq(2)))
    >>> left = Operation("*", Operation("-", half, Name("phi")), n)
    >>> turned = Operation("/", left, Call("abs", (n,)))
    >>> fold_signs(Operation("-", half, turned), lambda part: False)
    Name(name='phi')
    >>> fold_signs(Operation("-", half, turned), lambda part: True)
    Operation(sign='-', left=Name(name='pi'), right=Name(name='phi'))
    """
    match tree:
        case Number() | Name():
            return tree
        case Call("abs", (part,)):
            folded = fold_signs(part, is_negative)
            return _turn(folded) if is_negative(part) else folded
        case Call(function, arguments):
            return Call(function, tuple(fold_signs(part, is_negative) for part in arguments))
        case Operation("/", left, Call("abs", (part,))) if _has_factor(left, part):
            rest = fold_signs(_take_out(left, part), is_negative)
            return _negate(rest) if is_negative(part) else rest
        case Operation(sign, left, right):
            folded = Operation(sign, fold_signs(left, is_negative), fold_signs(right, is_negative))
            return _mirror(_combine(folded))
        case _:
            assert_never(tree)


def _has_factor(tree: Expression, factor: Expression) -> bool:
    """Whether a product has that factor above its fraction bar."""
    match tree:
        case Operation("*", left, right):
            return _has_factor(left, factor) or _has_factor(right, factor)
        case Operation("/", left):
            return _has_factor(left, factor)
        case _:
            return tree == factor


def _take_out(tree: Expression, factor: Expression) -> Expression:
    """The product without one such factor."""
    match tree:
        case Operation("*", left, right) if right == factor:
            return left
        case Operation("*", left, right) if left == factor:
            return right
        case Operation("*", left, right) if _has_factor(left, factor):
            return Operation("*", _take_out(left, factor), right)
        case Operation("*", left, right):
            return Operation("*", left, _take_out(right, factor))
        case Operation("/", left, right):
            return Operation("/", _take_out(left, factor), right)
        case _:
            return _ONE


def _negate(tree: Expression) -> Expression:
    """The expression with a minus; two are none."""
    if isinstance(tree, Operation) and is_literal_zero(tree):
        return tree.right
    return Operation("-", _ZERO, tree)


def _turn(tree: Expression) -> Expression:
    """The expression with a minus: before the angle of a sine or tangent, which has a letter."""
    match tree:
        case Call("sin" | "tan" as odd, (angle,)):
            return Call(odd, (_negate(angle),))
        case _:
            return _negate(tree)


def _combine(tree: Operation) -> Expression:
    """The same without a minus after another sign."""
    right = tree.right
    if not (isinstance(right, Operation) and is_literal_zero(right)):
        return tree
    match tree.sign:
        case "-" if is_literal_zero(tree):
            return right.right
        case "-":
            return Operation("+", tree.left, right.right)
        case "+":
            return Operation("-", tree.left, right.right)
        case "*" | "/" | "**":
            return tree
        case _:
            assert_never(tree.sign)


def _mirror(tree: Expression) -> Expression:
    """The same with an angle that is counted from its half way, a/2 -+ (a/2 - b), as b or a - b."""
    match tree:
        case Operation("-", middle, Operation("-", other, angle)) if middle == other:
            return angle
        case Operation("+", Operation("/", whole, two), Operation("-", other, angle)) if (
            tree.left == other and two == Number(fmpq(2))
        ):
            return Operation("-", whole, angle)
        case _:
            return tree
