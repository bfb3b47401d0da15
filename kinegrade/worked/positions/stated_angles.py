"""Directions that are stated: by an angle of the givens, from one point to another that is
constructed on a ray from it, or marked in the figure, or by an angle of a triangle.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterator, Mapping, Sequence
from math import degrees, nan, pi
from typing import Any, assert_never

from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation, walk
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.angle import Angle
from kinegrade.worked.case import Case
from kinegrade.worked.construction_steps import Step
from kinegrade.worked.findings import Seen, Stated
from kinegrade.worked.formulas.atoms import add_terms
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.leaves import formulate
from kinegrade.worked.formulas.measures import bearing, tidy
from kinegrade.worked.formulas.numbers import state_angle
from kinegrade.worked.positions.marked_angles import find_marked_angle
from kinegrade.worked.positions.right_angles import split_right_angles

_WORK: Mapping[str, Callable[[float, float], float]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": operator.truediv,
    "**": operator.pow,
}
_RIGHT = 90.0


def find_stated_angle(ends: tuple[str, str], case: Case) -> Stated | None:
    """The angle that states the line through two points: in symbols and without right angles, the
    sign with which it counts counter-clockwise from +x, and its degrees; None where none does.
    """
    stated = case.findings.stated
    if ends not in stated:
        stated[ends] = _find_among_givens(ends, case)
    seen = _find_seen(ends, case)
    if stated[ends] is not None or seen is None:
        return stated[ends]
    sign, plain, _ = split_right_angles(seen.tree)
    return _state(sign, plain, case, seen)


def find_stated_tree(ends: tuple[str, str], case: Case) -> tuple[int, Expression] | None:
    """The given angle that states the line through two points, as an expression without right
    angles, with the sign with which it counts counter-clockwise; None where none does.
    """
    given = (one for one in _list_stated(ends, case.construction) if _is_given(one, case))
    angle = next(given, None)
    if angle is None:
        return find_marked_angle(ends, case)
    sign, plain, _ = split_right_angles(angle)
    return sign, plain


def _find_among_givens(ends: tuple[str, str], case: Case) -> Stated | None:
    """The same by the construction, or by the marks of the figure."""
    angles = (find_given_angle(angle, case) for angle in _list_stated(ends, case.construction))
    given = next((angle for angle in angles if angle is not None), None)
    marked = find_marked_angle(ends, case) if given is None else None
    return _state(*marked, case) if marked is not None else given


def find_given_angle(angle: Expression, case: Case) -> Stated | None:
    """An angle that is made of givens, without right angles and with its sign; None for others."""
    if not _is_given(angle, case):
        return None
    sign, plain, _ = split_right_angles(angle)
    return _state(sign, plain, case)


def _state(sign: int, angle: Expression, case: Case, seen: Seen | None = None) -> Stated:
    """An angle of givens, and of one that a triangle has given."""
    symbols, values = dict(case.symbols), dict(case.solution.assembly.values)
    if seen is not None:
        symbols[seen.name], values[seen.name] = seen.symbol, seen.value
    formula = formulate(symbols).state(angle, True)
    return formula, sign, tidy(degrees(_evaluate(angle, values)))


def state_bearing(heading: Vector, term: Term | None, case: Case) -> Formula:
    """The angle of a direction from +x: by the letters of its line where these give it."""
    track, direction = find_track_angle(term, case) if term else None, bearing(heading)
    if track is None:
        return state_angle(direction)
    angle, sign, value = track
    quarters = round((direction - sign * value) / _RIGHT) % 4
    right = (state_angle(quarters * _RIGHT),) if quarters else ()
    return add_terms((*right, angle.signed(sign)))


def find_track_angle(term: Term, case: Case) -> Stated | None:
    """The angle of givens that gives the line along which a point slides: in symbols and without
    right angles, its sign counter-clockwise from +x, and its degrees; None where none does.
    """
    sentence = case.joint(term) if term.kind == "sliding" else None
    if sentence is None or sentence.on is None or len(sentence.on.arguments) != 2:
        return None
    return find_given_angle(sentence.on.arguments[1], case)


def _find_seen(ends: tuple[str, str], case: Case) -> Seen | None:
    """The direction that a triangle has given, by angles with letters alone."""
    pairs = tuple(map(Name, ends)), tuple(map(Name, reversed(ends)))
    found = (one for pair, one in case.findings.seen.items() if pair in pairs)
    return next((one for one in found if _is_given(one.tree, case)), None)


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


def _evaluate(angle: Expression, values: Mapping[str, Any]) -> float:
    """An angle made of givens and of what has been found, in radians."""
    match angle:
        case Name("pi"):
            return pi
        case Name(name):
            value = values[name]
            return float(value.ball() if isinstance(value, Angle) else value)
        case Number(value=value):
            return float(value)
        case Operation(sign=sign, left=left, right=right):
            return _WORK[sign](_evaluate(left, values), _evaluate(right, values))
        case Call():
            return nan
        case _:
            assert_never(angle)
