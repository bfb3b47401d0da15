"""The directions of vectors that the solution has found, and the angle from one to another."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.expressions.tree import Call
from kinegrade.language.math.tree import Letter
from kinegrade.worked.answers.asked_vectors import find_fact, is_vector_call
from kinegrade.worked.answers.pose_angles import tell_quadrant
from kinegrade.worked.answers.projections import Working
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block
from kinegrade.worked.findings import Fact
from kinegrade.worked.formulas.atoms import AXES, Measured, Number, Symbol, add_terms
from kinegrade.worked.formulas.equation import Equation, approximate, equate
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.functions import Function
from kinegrade.worked.formulas.measures import bearing, double
from kinegrade.worked.formulas.numbers import measure, state_angle, state_number
from kinegrade.worked.formulas.symbols import name_angle
from kinegrade.worked.vectors.components import find_heading
from kinegrade.worked.vectors.slopes.inclination import Inclination
from kinegrade.worked.vectors.summands import name_component

_X = Symbol((Letter("x"),))
_FULL, RIGHT = 360.0, 90.0  # degrees
_DIGITS, _EXACT = 2, 1e-9  # of an angle in degrees


def is_turn(tree: Call) -> bool:
    """Whether a call is the angle from one vector of the motion to another."""
    return tree.function == "angle" and all(map(is_vector_call, tree.arguments))


def explain_turn(tree: Call, case: Case) -> Iterator[Block]:
    """The directions of both vectors, counter-clockwise from the x axis."""
    for argument in tree.arguments:
        fact = find_fact(argument, case)
        heading = None if len(fact.parts) > 1 else find_heading(fact.parts[0], case)
        if fact.by_components or heading is None:
            yield from _explain_by_components(fact, case)
        else:
            degrees = _measure(fact)
            symbols, numbers = _add_right_angles(heading, degrees), state_angle(degrees)
            yield case.show(Equation(_name(fact), equate(symbols, numbers)))


def state_turn(tree: Call, case: Case) -> Working:
    """The difference of the directions, with a full turn where the answer has one."""
    first, second = (find_fact(argument, case) for argument in tree.arguments)
    symbols: tuple[Formula, ...] = (_name(second), -_name(first))
    sizes = _measure(second), _measure(first)
    numbers: tuple[Formula, ...] = (state_angle(sizes[0]), -state_angle(sizes[1]))
    if abs(sizes[0] - sizes[1]) > _FULL / 2:
        turn = _state_degrees(_FULL).signed(-1 if sizes[0] > sizes[1] else 1)
        symbols, numbers = (*symbols, turn), (*numbers, turn)
    return Working(add_terms(symbols), add_terms(numbers))


def _name(fact: Fact) -> Symbol:
    return name_angle(_X, Symbol(fact.symbol.print()))


def _measure(fact: Fact) -> float:
    """The direction in degrees, more than -180 and at most 180."""
    return _FULL / 2 - (_FULL / 2 - bearing(fact.value)) % _FULL


def _explain_by_components(fact: Fact, case: Case) -> Iterator[Block]:
    """By the tangent and the quadrant."""
    x, y = map(double, fact.value)
    label, degrees = _name(fact), _measure(fact)
    if x and y:
        names = [name_component(fact.symbol, axis) for axis in AXES]
        along, up = (measure(part, fact.symbol.unit) for part in fact.value)
        working = equate(names[1] / names[0], up / along)
        links = (*working, *state_number(fact.value.y / fact.value.x, "1"))
        yield case.show(Equation(Function("tan", label), links))
    yield case.say(tell_quadrant((_find_sign(x), _find_sign(y)), case.text(label)))
    exact = abs(degrees - round(degrees, _DIGITS)) < _EXACT
    yield case.show(Equation(label, (equate if exact else approximate)(state_angle(degrees))))


def _find_sign(number: float) -> int:
    return (number > 0) - (number < 0)


def _add_right_angles(heading: Inclination, degrees: float) -> Formula:
    """A direction of so many degrees as a named angle and right angles."""
    quarters = round((degrees - heading.sign * heading.value) / RIGHT)
    turned = _state_degrees(abs(quarters) * RIGHT).signed(1 if quarters >= 0 else -1)
    angles = () if heading.angle is None else (heading.angle.signed(heading.sign),)
    return add_terms((*angles, *((turned,) if quarters or not angles else ())))


def _state_degrees(degrees: float) -> Formula:
    return Measured(Number(f"{degrees:g}"), "deg")
