"""Right angles in an angle: with them taken out, sines and cosines have the given angle alone."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import assert_never

from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation, Operator
from kinegrade.worked.formulas.leaves import count_quarter_turns
from kinegrade.worked.positions.algebra import (
    ONE,
    ZERO,
    Pair,
    is_negated,
    minus,
    over,
    plus,
    times,
)

_COMBINED: Mapping[Operator, Callable[[Expression, Expression], Expression]] = {
    "+": plus,
    "-": minus,
    "*": times,
    "/": over,
    "**": lambda base, exponent: Operation("**", base, exponent),
}


def split_right_angles(angle: Expression) -> tuple[int, Expression, int]:
    """An angle as a sign times what remains of it, plus right angles, of which there are 0 to 3.

    >>> from kinegrade.expressions.reading import read_expression
    >>> split_right_angles(read_expression("pi/2 - phi"))
    (-1, Name(name='phi'), 1)
    """
    quarters = count_quarter_turns(angle)
    if quarters is not None:
        return 1, ZERO, quarters
    if is_negated(angle):
        sign, rest, quarters = split_right_angles(angle.right)
        return -sign, rest, -quarters % 4
    match angle:
        case Operation(sign="+" | "-" as joined, left=left, right=right):
            return _join(left, right, {"+": 1, "-": -1}[joined])
        case Number() | Name() | Operation() | Call():
            return 1, angle, 0
        case _:
            assert_never(angle)


def _join(left: Expression, right: Expression, joined: int) -> tuple[int, Expression, int]:
    """What remains of a sum, or of a difference where `joined` is -1."""
    sign, first, quarters = split_right_angles(left)
    other, second, more = split_right_angles(right)
    quarters, other = (quarters + joined * more) % 4, joined * other
    if ZERO in (first, second):
        return (sign, first, quarters) if second == ZERO else (other, second, quarters)
    return sign, Operation("+" if sign == other else "-", first, second), quarters


def make_unit(angle: Expression) -> Pair:
    """The unit vector in a direction; along an axis it is worked out."""
    sign, rest, quarters = split_right_angles(angle)
    pair: Pair = (ONE, ZERO) if rest == ZERO else (Call("cos", (rest,)), Call("sin", (rest,)))
    x, y = pair if sign > 0 else (pair[0], minus(ZERO, pair[1]))
    for _ in range(quarters):
        x, y = minus(ZERO, y), x
    return x, y


def turn_back(tree: Expression) -> Expression:
    """An expression whose sines and cosines have no negative angle: -sin(phi) for sin(-phi)."""
    match tree:
        case Call("sin" | "cos" as function, (angle,)) if is_negated(angle):
            cosine, sine = make_unit(angle)
            return {"sin": sine, "cos": cosine}[function]
        case Operation(sign, left, right) if not is_negated(tree):
            before, after = turn_back(left), turn_back(right)
            unchanged = (before, after) == (left, right)
            return tree if unchanged else _COMBINED[sign](before, after)
        case Operation(_, _, right):
            return minus(ZERO, turn_back(right))
        case Number() | Name() | Call():
            return tree
        case _:
            assert_never(tree)
