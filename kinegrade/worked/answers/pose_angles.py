"""Angles between vectors: from their tangent and their quadrant, or from their cosine."""

from __future__ import annotations

from dataclasses import replace

from kinegrade.expressions.tree import Call, Expression, Name, Operation
from kinegrade.language.math.tree import Letter, Row
from kinegrade.language.message import Message
from kinegrade.numbers.angle import Angle
from kinegrade.worked.answers.pose_working import AXIS_X, AXIS_Y, Working
from kinegrade.worked.formulas.atoms import Symbol
from kinegrade.worked.formulas.functions import Function
from kinegrade.worked.formulas.symbols import name_angle, name_vector
from kinegrade.worked.positions.algebra import Pair, cross, dot, over, times
from kinegrade.worked.positions.axes import length_of
from kinegrade.worked.positions.instance import DEGREE, PURE, Instance

_FULL = 1.0  # radians: angles that differ by more differ by a full turn
_BETWEEN_LETTERS = name_angle(name_vector("u"), name_vector("v"))


def tell_quadrant(signs: tuple[int, int], angle: str) -> Message:
    """Where an angle lies, by the signs of its cosine and of its sine."""
    return {
        (1, 1): Message("solution.first-quadrant", angle=angle),
        (-1, 1): Message("solution.second-quadrant", angle=angle),
        (-1, -1): Message("solution.third-quadrant", angle=angle),
        (1, -1): Message("solution.fourth-quadrant", angle=angle),
        (1, 0): Message("solution.angle-zero", angle=angle),
        (-1, 0): Message("solution.angle-straight", angle=angle),
        (0, 1): Message("solution.angle-right", angle=angle),
        (0, -1): Message("solution.angle-minus-right", angle=angle),
    }[signs]


def find_angle(
    first: Expression, second: Expression, working: Working
) -> tuple[Expression, Working]:
    """The angle from one vector to another."""
    if working.pair(first) in (AXIS_X, AXIS_Y):
        return _find_angle_from_axis(first, second, working)
    start, lines, lettered = working.lettered("u", first)
    end, more, lettered = lettered.lettered("v", second)
    label = working.symbol or _BETWEEN_LETTERS
    sentence = Message(
        "solution.angle-of-vectors",
        angle=working.text(label),
        first=working.phrase(first, "u"),
        second=working.phrase(second, "v"),
    )
    return _settle(label, lettered.said(sentence), lines + more, (start, end))


def _find_angle_from_axis(
    first: Expression, second: Expression, working: Working
) -> tuple[Expression, Working]:
    """The angle from an axis, by the coordinates of the other vector."""
    start, end = working.pair(first), working.pair(second)
    axis = Symbol((Letter("x" if start == AXIS_X else "y"),))
    simple = (
        isinstance(second, Operation)
        and isinstance(second.left, Name)
        and isinstance(second.right, Name)
    )
    other = _print_symbol(second, working) if simple else name_vector("v")
    phrase = working.phrase(second, "" if simple or working.symbol else "v")
    label = working.symbol or name_angle(axis, other)
    sentence = Message(
        "solution.angle-from-axis",
        angle=working.text(label),
        first=working.phrase(first),
        second=phrase,
    )
    ends = _list_ends(second)
    seen = working.instance.case.findings.seen.get(ends) if ends else None
    if seen is not None and start == AXIS_X and working.symbol:
        known = working.instance.named(seen.name, seen.symbol, seen.value)
        if _is_turn(known, seen.tree, Call("atan2", (end[1], end[0]))):
            return seen.tree, replace(working.said(sentence), instance=known)
    return _settle(label, working.said(sentence), (), (start, end))


def _list_ends(vector: Expression) -> tuple[Expression, Expression] | None:
    """The start and the end of a vector between two points, None for any other."""
    return (vector.right, vector.left) if isinstance(vector, Operation) else None


def _is_turn(instance: Instance, angle: Expression, other: Expression) -> bool:
    """Whether two angles are worth the same, and not a full turn apart."""
    one, another = (_find_radians(tree, instance) for tree in (angle, other))
    return abs(one - another) < _FULL


def _find_radians(angle: Expression, instance: Instance) -> float:
    value = instance.value(angle)
    return float(value.ball() if isinstance(value, Angle) else value)


def _print_symbol(vector: Expression, working: Working) -> Symbol:
    """The vector between two points as one symbol."""
    return Symbol(working.instance.formula(vector).print(working.instance.case.notation))


def _settle(
    label: Symbol, working: Working, lines: tuple[Row, ...], vectors: tuple[Pair, Pair]
) -> tuple[Expression, Working]:
    """The angle from one vector to another, by its tangent and its quadrant."""
    cosine, sine = dot(*vectors), cross(*vectors)
    instance = working.instance
    signs = instance.sign(cosine), instance.sign(sine)
    if signs[0] and signs[1]:
        lines += instance.equation(Function("tan", label), over(sine, cosine), PURE)
    name, working = working.denote("angle", label, Call("atan2", (sine, cosine)))
    working = working.shown(lines).said(tell_quadrant(signs, working.text(label)))
    if working.symbol is None:
        working = working.shown(working.instance.equation(label, name, DEGREE))
    return name, working


def find_angle_between(
    first: Expression, second: Expression, working: Working
) -> tuple[Expression, Working]:
    """The angle between two vectors, from its cosine."""
    pairs = working.pair(first), working.pair(second)
    sizes = [length_of(vector, working.instance.axes) for vector in (first, second)]
    product, area = dot(*pairs), Call("abs", (cross(*pairs),))
    label = working.symbol or _BETWEEN_LETTERS
    letters = ("", "") if working.symbol else ("u", "v")
    lines, working = working.sized(*sizes)
    cosine = over(product, times(*sizes))
    lines += working.instance.equation(Function("cos", label), cosine, PURE)
    sentence = Message(
        "solution.angle-between",
        first=working.phrase(first, letters[0]),
        second=working.phrase(second, letters[1]),
    )
    name, working = working.denote("angle", label, Call("atan2", (area, product)))
    return name, working.said(sentence).shown(lines)
