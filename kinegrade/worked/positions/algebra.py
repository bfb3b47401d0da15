"""Sums and products of expressions, as short as a textbook writes them: without zeros, ones and
double signs.
"""

from __future__ import annotations

from typing import TypeAlias, TypeGuard, assert_never

from kinegrade.expressions.reading import read_expression
from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation, is_literal_zero

Pair: TypeAlias = tuple[Expression, Expression]
ZERO, ONE, TWO = read_expression("0"), read_expression("1"), read_expression("2")


def is_negated(tree: Expression) -> TypeGuard[Operation]:
    """Whether an expression starts with a minus sign that applies to all of it."""
    return isinstance(tree, Operation) and tree.sign == "-" and is_literal_zero(tree)


def plus(left: Expression, right: Expression) -> Expression:
    """left + right, without zeros and double signs."""
    if ZERO in (left, right):
        return right if left == ZERO else left
    if is_negated(right):
        return minus(left, right.right)
    return Operation("+", left, right)


def minus(left: Expression, right: Expression) -> Expression:
    """left - right, without zeros and double signs."""
    if right in (ZERO, left):
        return ZERO if left == right else left
    if is_negated(right):
        return plus(left, right.right)
    match left:
        case Operation(sign="+", left=same, right=rest) if same == right:
            return rest
        case Operation(sign="-", left=same, right=rest) if same == right:
            return minus(ZERO, rest)
        case Number() | Name() | Operation() | Call():
            return Operation("-", left, right)
        case _:
            assert_never(left)


def times(left: Expression, right: Expression) -> Expression:
    """left * right, without ones and zeros."""
    if ZERO in (left, right):
        return ZERO
    if ONE in (left, right):
        return right if left == ONE else left
    if is_negated(left) or is_negated(right):
        product = times(*(part.right if is_negated(part) else part for part in (left, right)))
        return product if is_negated(left) and is_negated(right) else minus(ZERO, product)
    for factor, other in ((left, right), (right, left)):
        if isinstance(factor, Operation) and factor.sign == "/" and factor.right == other:
            return factor.left
    return square(left) if left == right else Operation("*", left, right)


def over(left: Expression, right: Expression) -> Expression:
    """left / right, without ones and zeros."""
    if left == ZERO or right == ONE:
        return left
    return Operation("/", left, right)


def square(base: Expression) -> Expression:
    """The square of an expression, without its sign."""
    if is_negated(base):
        base = base.right
    match base:
        case Number(value=value):
            return Number(value * value)
        case Name() | Operation() | Call():
            return Operation("**", base, TWO)
        case _:
            assert_never(base)


def root(base: Expression) -> Expression:
    """The positive square root; the root of a square is an absolute value."""
    if isinstance(base, Operation) and base.sign == "**" and base.right == TWO:
        return Call("abs", (base.left,))
    return base if base in (ZERO, ONE) else Call("sqrt", (base,))


def dot(first: Pair, second: Pair) -> Expression:
    """The scalar product."""
    return plus(times(first[0], second[0]), times(first[1], second[1]))


def cross(first: Pair, second: Pair) -> Expression:
    """The out-of-plane component of the vector product."""
    return minus(times(first[0], second[1]), times(first[1], second[0]))


def make_positive(tree: Expression, sign: int) -> Expression:
    """An expression of that sign, taken the way in which it is positive: y - x for x - y."""
    if sign >= 0:
        return tree
    if isinstance(tree, Operation) and tree.sign == "-":
        return minus(tree.right, tree.left)
    return minus(ZERO, tree)
