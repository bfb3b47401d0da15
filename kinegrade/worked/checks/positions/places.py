"""Checks of positions: distances that are given, from coordinates; direction cosines, from the
angle; sums of angles, and right angles.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from math import cos, degrees, radians, sin
from typing import Any, Literal, assert_never

from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation, find_names, walk
from kinegrade.language.message import Message
from kinegrade.problem.template.template import Ask
from kinegrade.worked.answers.pose_working import AXIS_X, AXIS_Y
from kinegrade.worked.case import Case
from kinegrade.worked.checks.arms import point_from
from kinegrade.worked.checks.check import Check, compare
from kinegrade.worked.checks.positions.angle_sums import list_angle_sums
from kinegrade.worked.checks.positions.cosines import list_circles_on_lines, list_cosine_checks
from kinegrade.worked.checks.positions.right_angles import list_right_angles
from kinegrade.worked.checks.sides import Side
from kinegrade.worked.formulas.atoms import ZERO, add_squares
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.functions import Function
from kinegrade.worked.formulas.measures import length
from kinegrade.worked.formulas.numbers import measure, state_angle, state_quantity
from kinegrade.worked.formulas.symbols import read_symbol
from kinegrade.worked.positions.instance import make_instance
from kinegrade.worked.vectors.arms import find_stated_length

_X, _Y = Call("", AXIS_X), Call("", AXIS_Y)


@dataclass(frozen=True)
class _Distance:
    """The distance of two points as it is given."""

    first: str
    second: str
    given: Expression

    def check(self, case: Case) -> Check:
        """The same distance by coordinates."""
        start, end = (case.motion.points[point] for point in (self.first, self.second))
        sides = [state_difference(*pair) for pair in zip(start, end, strict=True)]
        across = [side for side in sides if side != ZERO]
        numbers = add_squares(across) if len(across) > 1 else across[0]
        pair = point_from(self.first, self.second, case).pair.values()
        letters = add_squares(one.letters for one in pair)
        value = length(end - start, case.arithmetic)
        first, second = map(case.naming.point, (self.first, self.second))
        way = Message("solution.check-distance", first=first, second=second)
        return compare(way, Side(numbers, value, letters), self._state(case), "m")

    def _state(self, case: Case) -> Side:
        """By the symbol of the statement, else as it is made of what is given: letters of its own
        may have been worked out from the coordinates themselves.
        """
        instance = make_instance(case)
        value = instance.value(self.given)
        symbol = find_stated_length(self.first, self.second, case)
        if symbol is not None:
            return Side(measure(value, "m"), value, symbol)
        return Side(instance.numbers(self.given), value, instance.formula(self.given))


def list_place_checks(asked: Sequence[Ask], case: Case) -> Iterator[Check]:
    """The checks by the law of cosines, those of distances, then those of direction cosines. Of a
    point that a line and a circle have given, the circle's equation has led to its coordinates: it
    would be put back into it.
    """
    yield from list_cosine_checks(case)
    solved = {frozenset(ends) for ends in list_circles_on_lines(case)}
    for distance in (*_list_on_circles(case), *_list_lengths(asked, case)):
        if frozenset((distance.first, distance.second)) not in solved:
            yield distance.check(case)
    for angle in asked:
        for cosine in asked:
            yield from _check_cosine(angle, cosine, case)
    yield from list_angle_sums(asked, case)
    yield from list_right_angles(case)


def _list_on_circles(case: Case) -> Iterator[_Distance]:
    """The distances of points placed on a circle from its centre: of two circles the second one
    comes first, since the first one has led to the point.
    """
    for step in reversed(case.construction):
        for call in reversed(tuple(walk(step.tree))):
            match call:
                case Call(function="circle", arguments=(Name(centre), radius, *_)):
                    if step.point in case.motion.points:
                        yield _Distance(centre, step.point, radius)
                case Name() | Number() | Operation() | Call():
                    continue
                case _:
                    assert_never(call)


def _list_lengths(asked: Sequence[Ask], case: Case) -> tuple[_Distance, ...]:
    """The distances that are given, those first of a point of which a coordinate is asked for; none
    at which a point was placed, as that is put back into it.
    """
    calls = (call for ask in asked for call in walk(ask.quantity))
    sought = {name for call in calls for name in _find_located(call)}
    given = [one for one in _list_stated(case) if not _has_placed(one, case)]
    return tuple(sorted(given, key=lambda one: not sought & {one.first, one.second}))


def _has_placed(distance: _Distance, case: Case) -> bool:
    """Whether one of the two points has been placed by that given, and by no intersection."""
    ends, given = {distance.first, distance.second}, set(find_names(distance.given))
    trees = [step.tree for step in case.construction if step.point in ends]
    placing = [tree for tree in trees if not _is_intersection(tree)]
    return any(not given.isdisjoint(find_names(tree)) for tree in placing)


def _is_intersection(tree: Expression) -> bool:
    match tree:
        case Call(function=function):
            return function == "meet"
        case Name() | Number() | Operation():
            return False
        case _:
            assert_never(tree)


def _list_stated(case: Case) -> Iterator[_Distance]:
    """The distances for which the statement has a given."""
    symbols = case.symbols
    for first, second in combinations(case.template.scheme.points, 2):
        stated = find_stated_length(first, second, case)
        for name in case.template.parameters:
            if stated is not None and symbols[name].looks_like(stated):
                yield _Distance(first, second, Name(name))


def _find_located(call: Expression) -> tuple[str, ...]:
    """The point whose coordinate an expression is."""
    match call:
        case Call(function="x" | "y", arguments=(Name(point),)):
            return (point,)
        case Name() | Number() | Operation() | Call():
            return ()
        case _:
            assert_never(call)


def state_difference(start: Any, end: Any) -> Formula:
    """The difference of two coordinates in numbers, of which the square is taken; where one is zero
    the other one.
    """
    before, after = measure(start, "m"), measure(end, "m")
    if ZERO in (before, after):
        return after if before == ZERO else before
    return after - before


def _check_cosine(angle: Ask, cosine: Ask, case: Case) -> Iterator[Check]:
    """A component of the unit vector along a direction, or normal to it, by the angle of that
    direction from the x axis.
    """
    whole, part = angle.quantity, cosine.quantity
    if not (isinstance(whole, Call) and whole.function == "angle" and whole.arguments[0] == _X):
        return
    if not (isinstance(part, Call) and part.function == "along" and part.arguments[0] in (_X, _Y)):
        return
    axis, along = part.arguments
    turned = along == Call("turned", (whole.arguments[1],))
    if not turned and along != whole.arguments[1]:
        return
    found, answer = (case.solution.answers[ask.name] for ask in (angle, cosine))
    turn = found.value if found.measure.degrees else degrees(found.value)
    ratio: Literal["sin", "cos"] = "cos" if turned == (axis == _Y) else "sin"
    sign = -1 if turned and axis == _X else 1
    value = sign * {"cos": cos, "sin": sin}[ratio](radians(turn))
    *_, decimal = state_quantity(answer)
    symbols = [read_symbol(ask.symbol) for ask in (cosine, angle)]
    names = map(case.text, symbols)
    way = Message("solution.check-cosine", cosine=next(names), angle=next(names))
    side, letters = (Function(ratio, one).signed(sign) for one in (state_angle(turn), symbols[1]))
    left = Side(decimal.right, answer.value, symbols[0])
    yield compare(way, left, Side(side, value, letters), "1")
