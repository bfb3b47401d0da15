"""Lengths and coordinates in the formula of an answer, with the letters of velocity poles."""

from __future__ import annotations

from collections.abc import Sequence
from typing import assert_never

from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation
from kinegrade.mechanics.vector import AxisName, Vector
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.atoms import AXES, Symbol, add_squares, add_terms
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.functions import Function
from kinegrade.worked.formulas.leaves import formulate
from kinegrade.worked.formulas.measures import bearing, double, tidy
from kinegrade.worked.formulas.numbers import measure, state_angle
from kinegrade.worked.formulas.symbols import name_coordinate, name_point
from kinegrade.worked.steps.poles.poles import name_pole
from kinegrade.worked.vectors.slopes.cosines import find_cosine
from kinegrade.worked.vectors.slopes.inclination import Inclination

RIGHT, CLOSE = 90.0, 1e-7  # degrees


def state_place(tree: Expression, case: Case) -> Formula:
    """A length, coordinate or constant in symbols, poles by their letters."""
    letters = {name: name_point(name) for name in case.findings.poles.values()}
    symbols = {**case.symbols, **letters}
    points = (*case.motion.points, *letters)
    return formulate(symbols, points).state(_name_poles(tree, case))


def is_pole(tree: Expression, case: Case) -> bool:
    """Whether a point is the pole of a body that turns at the instant."""
    match tree:
        case Call(function="pole", arguments=(Name(body), *_)):
            return not case.arithmetic.is_zero(case.motion.omega(body))
        case Call() | Name() | Number() | Operation():
            return False
        case _:
            assert_never(tree)


def state_distance(
    ends: Sequence[tuple[Expression, Vector]], case: Case
) -> tuple[Formula, Formula]:
    """The distance of two points, each with its place, by their coordinates: in symbols and in
    numbers.
    """
    sides = [
        _state_difference(axis, ends, case)
        for number, axis in enumerate(AXES)
        if double(ends[0][1][number] - ends[1][1][number])
    ]
    if len(sides) == 1:
        return sides[0]
    symbols, numbers = zip(*sides, strict=True)
    return add_squares(symbols), add_squares(numbers)


def state_component(
    ends: Sequence[tuple[Expression, Vector]],
    direction: Vector,
    case: Case,
    named: Inclination | None,
) -> tuple[Formula, Formula]:
    """The component along a direction, `named` by an angle where one is known, of the vector to the
    first of two points from the second, by their coordinates: in symbols and in numbers.
    """
    symbols, numbers = list[Formula](), list[Formula]()
    for number, (axis, quarter) in enumerate(zip(AXES, (0.0, RIGHT), strict=True)):
        apart = abs((bearing(direction) - quarter + 180) % 360 - 180)
        if abs(apart - RIGHT) < CLOSE or not double(ends[0][1][number] - ends[1][1][number]):
            continue
        cosine = find_cosine(Inclination(1, None, 0.0, number), named) if named else None
        if cosine is not None:
            for told, size in zip((symbols, numbers), _subtract(axis, ends, case), strict=True):
                told.append((size * cosine.state(told is numbers)).signed(cosine.sign))
            continue
        acute, sign = tidy(min(apart, 180 - apart)), (1 if apart < RIGHT else -1)
        for told, size in zip((symbols, numbers), _subtract(axis, ends, case), strict=True):
            told.append(_turn(size, axis, acute).signed(sign))
    return add_terms(symbols), add_terms(numbers)


def _turn(size: Formula, axis: AxisName, acute: float) -> Formula:
    """A coordinate times the cosine of the acute angle of its axis with a direction; of y the sine
    of what is left to a right angle.
    """
    if acute < CLOSE:
        return size
    match axis:
        case "x":
            return size * Function("cos", state_angle(acute))
        case "y":
            return size * Function("sin", state_angle(tidy(RIGHT - acute)))
        case _:
            assert_never(axis)


def _state_difference(
    axis: AxisName, ends: Sequence[tuple[Expression, Vector]], case: Case
) -> tuple[Formula, Formula]:
    """How far one point lies beyond the other along an axis; a coordinate that is zero is left
    out.
    """
    return _subtract(axis, sorted(ends, key=lambda end: -double(end[1][AXES.index(axis)])), case)


def _subtract(
    axis: AxisName, ends: Sequence[tuple[Expression, Vector]], case: Case
) -> tuple[Formula, Formula]:
    """The coordinate of the first of two points less that of the second; one that is zero is left
    out.
    """
    symbols, numbers = list[Formula](), list[Formula]()
    for sign, (tree, place) in zip((1, -1), ends, strict=True):
        value = place[AXES.index(axis)]
        if double(value):
            letter = Symbol(state_place(tree, case).print())
            symbols.append(name_coordinate(axis, letter).signed(sign))
            numbers.append(measure(value, "m").signed(sign))
    return add_terms(symbols), add_terms(numbers)


def _name_poles(tree: Expression, case: Case) -> Expression:
    """The expression with every velocity pole as a named point."""
    match tree:
        case Call(function="pole", arguments=(Name(body), *_)):
            return Name(name_pole(body, case))
        case Call(function=function, arguments=arguments):
            return Call(function, tuple(_name_poles(argument, case) for argument in arguments))
        case Operation(sign=sign, left=left, right=right):
            return Operation(sign, _name_poles(left, case), _name_poles(right, case))
        case Number() | Name():
            return tree
        case _:
            assert_never(tree)
