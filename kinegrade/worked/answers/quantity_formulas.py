"""The quantity of an ask as a formula of quantities found before: in symbols, and with numbers."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, assert_never

from kinegrade.expressions.evaluation import evaluate
from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.vector import AxisName, Vector
from kinegrade.problem.quantities.functions import find_motion_calls, make_quantities
from kinegrade.problem.quantities.reader import find_body_names
from kinegrade.worked.answers.asked_vectors import (
    find_fact,
    find_level,
    is_rotation_call,
    is_vector_call,
)
from kinegrade.worked.answers.dimensions import find_unit
from kinegrade.worked.answers.directions import is_turn, state_turn
from kinegrade.worked.answers.places import is_pole, state_component, state_distance, state_place
from kinegrade.worked.answers.projections import Working, name_known_axis, project, project_on
from kinegrade.worked.case import Case
from kinegrade.worked.findings import Fact
from kinegrade.worked.formulas.atoms import AXES, ZERO, Measured, add_squares, add_terms
from kinegrade.worked.formulas.atoms import Number as Numeral
from kinegrade.worked.formulas.formula import Absolute, Formula
from kinegrade.worked.formulas.functions import Function, Root
from kinegrade.worked.formulas.measures import bearing, double, length
from kinegrade.worked.formulas.numbers import measure, round_number, state_angle
from kinegrade.worked.rates.speeds import find_rotation_value, name_rotation
from kinegrade.worked.vectors.by_components import split
from kinegrade.worked.vectors.components import find_heading, list_component, state_signed
from kinegrade.worked.vectors.slopes.inclination import Inclination
from kinegrade.worked.vectors.summands import name_component
from kinegrade.worked.vectors.vectors import UNITS

_MEASURES = frozenset({"magnitude", "x", "y", "along", "angle", "between"})
_ENCLOSING: Mapping[str, Callable[[Formula], Formula]] = {"abs": Absolute, "sqrt": Root}
_AXES: tuple[tuple[AxisName, Vector], ...] = (("x", Vector(1, 0)), ("y", Vector(0, 1)))


def work_out(tree: Expression, case: Case) -> Working:
    """An expression that is a number."""
    match tree:
        case Call(function=function, arguments=(vector, *_)) if (
            function in _MEASURES and is_vector_call(vector)
        ):
            return _measure(tree, case)
        case Call(function="distance", arguments=ends) if any(is_pole(end, case) for end in ends):
            return Working(*state_distance([(end, find_value(end, case)) for end in ends], case))
        case Call(function="along", arguments=(Operation("-", end, start), direction)) if any(
            is_pole(each, case) for each in (end, start)
        ):
            places = [(each, find_value(each, case)) for each in (end, start)]
            value = find_value(direction, case)
            named = name_known_axis(direction, value, case)
            return Working(*state_component(places, value, case, named))
        case Call() if is_rotation_call(tree):
            return _state_rotation(tree, case)
        case Call(function="abs" | "sqrt" as function, arguments=(argument,)) if any(
            find_motion_calls(argument)
        ):
            return _enclose(_ENCLOSING[function], work_out(argument, case))
        case Operation(left=left) if not isinstance(left, Number):
            return _combine(tree, case)
        case Operation(sign="-", right=right):
            inner = work_out(right, case)
            return Working(-inner.symbols, inner.numbers and -inner.numbers)
        case Number() | Name() | Call() | Operation():
            return Working(state_place(tree, case))
        case _:
            assert_never(tree)


def _enclose(enclose: Callable[[Formula], Formula], inner: Working) -> Working:
    """The size or the root of what is worked out."""
    return Working(enclose(inner.symbols), inner.numbers and enclose(inner.numbers))


def _measure(tree: Call, case: Case) -> Working:
    """The magnitude, a component or the direction of a vector of the motion."""
    fact = find_fact(tree.arguments[0], case)
    match tree.function:
        case "magnitude":
            return _state_magnitude(fact, case)
        case "x" | "y" as axis:
            return _state_component(fact, axis, case)
        case "along":
            direction = find_value(tree.arguments[1], case)
            named = name_known_axis(tree.arguments[1], direction, case)
            return project(fact, direction, case, named)
        case _:
            return state_turn(tree, case) if is_turn(tree) else _state_angle(tree, case)


def _state_magnitude(fact: Fact, case: Case) -> Working:
    """The magnitude of a vector, from its components or its normal and tangential parts."""
    if fact.symbol in case.findings.sized:
        return Working(fact.symbol)
    if fact.by_components:
        return _state_magnitude_of_components(fact)
    pieces = [piece for piece in fact.parts if double(piece.value.squared())] or fact.parts[:1]
    if len(pieces) > 1:
        return Working(
            add_squares(piece.symbol for piece in pieces),
            add_squares(state_signed(piece, case) for piece in pieces),
        )
    (piece,) = pieces
    negative = double(piece.value.dot(piece.positive)) < 0
    return Working(abs(piece.symbol) if negative else piece.symbol)


def _state_magnitude_of_components(fact: Fact) -> Working:
    """The root of the squares of both components, or the one that is not zero with its sign."""
    names = [
        name_component(fact.symbol, axis)
        for axis, number in zip(AXES, fact.value, strict=True)
        if double(number)
    ]
    if len(names) > 1:
        unit = fact.symbol.unit
        return Working(add_squares(names), add_squares(measure(part, unit) for part in fact.value))
    if double(sum(fact.value)) < 0:
        return Working(-names[0])
    return Working(add_terms(names))


def _state_component(fact: Fact, axis: AxisName, case: Case) -> Working:
    """A component along an axis of the frame."""
    if fact.by_components:
        return Working(name_component(fact.symbol, axis))
    summands = tuple(list_component(fact, axis, case))
    own = name_component(fact.symbol, axis)
    slanting = any(find_heading(piece, case) is None for piece in fact.pieces)
    known = len(fact.pieces) > 1 or slanting
    if not known or any(one.symbol == own for one in summands):
        return project(fact, dict(_AXES)[axis], case)
    numbers = add_terms(one.in_numbers for one in summands if one.counts)
    symbols = add_terms(one.in_symbols for one in summands)
    return Working(symbols, None if numbers.is_decimal else numbers)


def _state_angle(tree: Call, case: Case) -> Working:
    """The angle from one vector to another, or between them, from their directions; between a
    vector known by its components and a line, from its projection on that.
    """
    projected = find_projected(tree, case)
    if projected is not None:
        fact, axis = projected
        symbols, numbers = project_on(split(fact), axis, case)
        size = measure(length(fact.value, case.arithmetic), fact.symbol.unit)
        shares = symbols / fact.symbol, numbers / size
        return Working(*(Function("arccos", share) for share in shares))
    first, second = (bearing(find_value(argument, case)) for argument in tree.arguments)
    if tree.function == "between" and second < first:
        first, second = second, first
    difference = state_angle(second) - state_angle(first)
    if tree.function == "angle" or second - first <= 180:
        return Working(difference)
    return Working(Measured(Numeral("360"), "deg") - difference)


def find_projected(tree: Call, case: Case) -> tuple[Fact, Inclination] | None:
    """The vector known by its components and its magnitude whose angle with a line is told by its
    projection on that, and the line's direction; None where the directions of both tell the angle.
    """
    vector, direction = tree.arguments
    if tree.function != "between" or is_vector_call(direction) or not is_vector_call(vector):
        return None
    axis = name_known_axis(direction, find_value(direction, case), case)
    if axis is None or axis.angle is None:
        return None
    fact = find_fact(vector, case)
    return (fact, axis) if fact.by_components and fact.symbol in case.findings.sized else None


def _state_rotation(tree: Call, case: Case) -> Working:
    """An angular velocity or acceleration, absolute or relative."""
    level = find_level(tree)
    names = [argument.name for argument in tree.arguments if isinstance(argument, Name)]
    if len(names) == 1 or names[1] == GROUND:
        return Working(name_rotation(names[0], case, level))
    first, second = (name_rotation(name, case, level) for name in names)
    rates = [find_rotation_value(name, case, level) for name in names]
    symbols = first - second
    if not any(map(double, rates)):
        return Working(symbols)
    of, base = (measure(rate, UNITS[level, True]) for rate in rates)
    return Working(symbols, of - base if base != ZERO else None)


def _combine(tree: Operation, case: Case) -> Working:
    """A formula of two numbers."""
    sides = (tree.left, tree.right)
    left, right = (work_out(side, case).symbols for side in sides)
    first, second = (_state_number(side, case) for side in sides)
    return Working(_join(tree, left, right), _join(tree, first, second))


def _join(tree: Operation, left: Formula, right: Formula) -> Formula:
    """Two sides joined as an operation does."""
    match tree.sign:
        case "/":
            return left / right
        case "**":
            return left**right
        case "+":
            return left + right
        case "-":
            return left - right
        case "*":
            return left.dot(right)
        case _:
            assert_never(tree.sign)


def _state_number(tree: Expression, case: Case) -> Formula:
    """The value of a side; a literal as it is."""
    match tree:
        case Number(value=value):
            return round_number(value)
        case Name() | Operation() | Call():
            return measure(find_value(tree, case), find_unit(tree, case.template))
        case _:
            assert_never(tree)


def find_value(tree: Expression, case: Case) -> Any:
    """The exact value of a part of the quantity."""
    arithmetic, assembly = case.arithmetic.fork(), case.solution.assembly
    values = {**find_body_names(assembly.mechanism), **assembly.values}
    functions = {**assembly.functions, **make_quantities(case.motion, arithmetic)}
    return evaluate(tree, values, functions, arithmetic)
