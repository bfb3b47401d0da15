"""Directions that a template states by an angle of its givens: from one point to another that is
constructed on a ray from it.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterator, Mapping, Sequence
from math import degrees, nan, pi
from typing import assert_never

from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation, Operator, walk
from kinegrade.numbers.angle import Angle
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.leaves import count_quarter_turns, formulate
from kinegrade.worked.formulas.measures import tidy
from kinegrade.worked.formulas.symbols import collect_symbols
from kinegrade.worked.positions.construction_steps import Step, list_steps

_OPPOSITE: Mapping[Operator, Operator] = {"+": "-", "-": "+"}
_WORK: Mapping[str, Callable[[float, float], float]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": operator.truediv,
    "**": operator.pow,
}


def find_stated_angle(ends: tuple[str, str], case: Case) -> tuple[Formula, int, float] | None:
    """The angle that states the line through two points: in symbols and without right angles, the
    sign with which it counts counter-clockwise from +x, and its degrees; None where none does.
    """
    steps = list_steps(case.template)
    angle = next((angle for angle in _list_stated(ends, steps) if _is_given(angle, case)), None)
    if angle is None:
        return None
    sign, plain = _drop_right_angles(angle)
    symbols = formulate(collect_symbols(case.template)).state(plain, True)
    return symbols, sign, tidy(degrees(_evaluate(plain, case)))


def _list_stated(ends: tuple[str, str], steps: Sequence[Step]) -> Iterator[Expression]:
    """The angles that state the line through two points, or one parallel or normal to it."""
    for step in steps:
        yield from _list_angles(step.point, step.tree, ends)
    trees = {step.point: step.tree for step in steps}
    match [trees.get(end) for end in ends]:
        case [
            Call("polar", (centre, _, angle)),
            Call("polar", (other, _, same)),
        ] if (centre, angle) == (other, same):
            yield angle
    for point, base in (ends, ends[::-1]):
        match trees.get(point):
            case Operation(
                "+", Name(start), Call("turned", (Operation("-", Name(last), Name(first)),))
            ) if start == base:
                yield from _list_stated((first, last), steps)


def _is_given(angle: Expression, case: Case) -> bool:
    """Whether an angle is made of givens alone; a line may have a point in its place."""
    points = case.template.scheme.points
    names = {part.name for part in walk(angle) if isinstance(part, Name)}
    return not names & set(points) and not any(isinstance(part, Call) for part in walk(angle))


def _list_angles(point: str, tree: Expression, ends: tuple[str, str]) -> Iterator[Expression]:
    """The angles of the rays and lines from one end on which a construction places the other end,
    and of a line to which it draws the perpendicular from one end.
    """
    match tree:
        case Call(function="polar", arguments=(Name(base), _, angle)):
            placed = [(base, angle)]
        case Call(function="meet", arguments=(first, second, *_)):
            placed = [*_read_line(first), *_read_line(second)]
        case Call(function="foot", arguments=(Name(base), line)):
            placed = [*_read_line(line), *((base, angle) for _, angle in _read_line(line))]
        case Call() | Name() | Number() | Operation():
            placed = []
        case _:
            assert_never(tree)
    for base, angle in placed:
        if {point, base} == {*ends}:
            yield angle


def _read_line(tree: Expression) -> Iterator[tuple[str, Expression]]:
    """The point and the direction of a line."""
    if isinstance(tree, Call) and tree.function == "line":
        through, direction = tree.arguments
        if isinstance(through, Name):
            yield through.name, direction


def _drop_right_angles(angle: Expression) -> tuple[int, Expression]:
    """What remains of a sum without right angles, and the sign with which it counts."""
    if not isinstance(angle, Operation) or angle.sign not in ("+", "-"):
        return 1, angle
    if count_quarter_turns(angle.right) is not None:
        return _drop_right_angles(angle.left)
    if count_quarter_turns(angle.left) is None:
        sign, left = _drop_right_angles(angle.left)
        joined = _OPPOSITE[angle.sign] if sign < 0 else angle.sign
        return sign, Operation(joined, left, angle.right)
    sign, rest = _drop_right_angles(angle.right)
    return sign * {"+": 1, "-": -1}[angle.sign], rest


def _evaluate(angle: Expression, case: Case) -> float:
    """An angle made of givens, in radians."""
    match angle:
        case Name("pi"):
            return pi
        case Name(name):
            value = case.solution.assembly.values[name]
            return float(value.ball() if isinstance(value, Angle) else value)
        case Number(value=value):
            return float(value)
        case Operation(sign=sign, left=left, right=right):
            return _WORK[sign](_evaluate(left, case), _evaluate(right, case))
        case Call():
            return nan
        case _:
            assert_never(angle)
