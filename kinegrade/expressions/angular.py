"""Which expressions are angles: the power of "angle" in a tree, by the names that have it."""

from __future__ import annotations

from collections.abc import Collection
from typing import assert_never

from kinegrade.expressions.tree import SUMS, Call, Expression, Name, Number, Operation, Operator

TURNING = frozenset({"atan2", "direction", "angle"})  # right up to full turns
ANGLES = frozenset({"asin", "acos", "atan", "between"}) | TURNING


def is_angle(tree: Expression, angles: frozenset[str]) -> bool:
    """Whether the expression has the dimension of an angle, given the names that have it; `pi` is
    an angle.
    """
    return find_angular_degree(tree, angles) == 1


def find_angular_degree(tree: Expression, angles: frozenset[str]) -> int:
    """The power of "angle" in the expression: phi/2 has 1, 180*phi/pi has 0."""
    match tree:
        case Number():
            return 0
        case Name(name):
            return int(name == "pi" or name in angles)
        case Call("abs", (argument, *_)):
            return find_angular_degree(argument, angles)
        case Call(function):
            return int(function in ANGLES)
        case Operation(sign, left, right):
            degrees = find_angular_degree(left, angles), find_angular_degree(right, angles)
            return _combine_degrees(sign, *degrees)
        case _:
            assert_never(tree)


def turns_round(tree: Expression, angles: Collection[str] = ()) -> bool:
    """Whether the expression is the angle of a position, itself or with others added: one that
    full turns leave the same. Names are such `angles`, or no angles.
    """
    match tree:
        case Number():
            return False
        case Name(name):
            return name in angles
        case Call(function):
            return function in TURNING
        case Operation(sign, left, right):
            return sign in SUMS and any(turns_round(each, angles) for each in (left, right))
        case _:
            assert_never(tree)


def _combine_degrees(sign: Operator, left: int, right: int) -> int:
    """The power of "angle" in a combination of two expressions, given the power in each."""
    match sign:
        case "+" | "-":
            return max(left, right)
        case "*":
            return left + right
        case "/":
            return left - right
        case "**":
            return 0
        case _:
            assert_never(sign)
