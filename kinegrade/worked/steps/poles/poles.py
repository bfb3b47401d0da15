"""The velocity pole of a body: where it lies, from the velocity of one point and the rotation."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.language.message import Message
from kinegrade.mechanics.vector import AxisName, Vector
from kinegrade.problem.pole_names import choose_pole_letter, find_poles, name_asked_pole
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block
from kinegrade.worked.formulas.atoms import AXES, OTHER, ZERO, add_terms
from kinegrade.worked.formulas.equation import Equation, drop_repetition, equate
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.formulas.numbers import measure, state_number
from kinegrade.worked.formulas.symbols import name_coordinate
from kinegrade.worked.positions.algebra import ZERO as NOTHING
from kinegrade.worked.positions.axes import choose_axes
from kinegrade.worked.unlettered import is_lettered
from kinegrade.worked.vectors.components import find_known, list_component
from kinegrade.worked.vectors.points import find_point, find_vector
from kinegrade.worked.vectors.summands import PLACES
from kinegrade.worked.vectors.vectors import name_point_vector


def name_pole(body: str, case: Case) -> str:
    """The name of a body's pole: the letter by which an ask names it, else one that no point has,
    numbered where answers are about several poles.
    """
    asked = name_asked_pole(body, case.template)
    if asked:
        return asked
    letter = choose_pole_letter(case.template)
    bodies = sorted(find_poles(case.template.asks.values()))
    return f"{letter}{bodies.index(body) + 1}" if len(bodies) > 1 and body in bodies else letter


def explain_pole(body: str, case: Case) -> Iterator[Block]:
    """Where the pole of a body lies; derived only once."""
    if body in case.findings.poles:
        return
    name = case.findings.poles[body] = name_pole(body, case)
    if case.arithmetic.is_zero(case.motion.omega(body)):
        yield case.say(Message("solution.pole-far", body=case.naming.body(body)))
        return
    base = case.motion.frames.bases[body]
    symbol = name_point_vector(base.point, "velocity", case)
    yield from find_point(base.chain, symbol, case, "velocity")
    velocity = find_vector(base.chain, case.motion, "velocity")
    yield case.say(_say_where(name, body, velocity, case))
    vanishing = (_state_vanishing(axis, name, body, velocity, case) for axis in AXES)
    yield case.show(*filter(None, vanishing))
    yield case.show(*(_state_coordinate(axis, name, body, velocity, case) for axis in AXES))


def _say_where(pole: str, body: str, velocity: Vector, case: Case) -> Message:
    """That the pole lies where the velocity vanishes, and on which line through the base point it
    does where that moves along an axis.
    """
    base, name = case.motion.frames.bases[body].point, case.naming.body(body)
    start, letter = case.naming.point(base), case.naming.point(pole)
    if is_lettered(base, case) and double(velocity.squared()):
        if not double(velocity.y):
            return Message("solution.pole-on-vertical", body=name, pole=letter, base=start)
        if not double(velocity.x):
            return Message("solution.pole-on-horizontal", body=name, pole=letter, base=start)
    return Message("solution.pole-of", body=name, pole=letter, base=start)


def _state_vanishing(
    axis: AxisName, pole: str, body: str, velocity: Vector, case: Case
) -> Equation | None:
    """v_Ax - omega (y_P - y_A) = 0, v_Ay + omega (x_P - x_A) = 0; None for the component that
    vanishes as the pole lies on an axis through A.
    """
    other, across = OTHER[axis], {"x": -1, "y": 1}[axis]
    base = case.motion.frames.bases[body].point
    known = find_known(name_point_vector(base, "velocity", case), velocity, case)
    shares = [one.in_symbols for one in list_component(known, axis, case)]
    if not shares:
        return None
    arm: Formula = name_coordinate(other, case.naming.letter(pole))
    if choose_axes(case.construction).coordinate(other, base) != NOTHING:
        arm = arm - name_coordinate(other, case.naming.letter(base))
    turned = (case.naming.omega(body) * arm).signed(across)
    return Equation(add_terms((*shares, turned)), equate(ZERO))


def _state_coordinate(
    axis: AxisName, pole: str, body: str, velocity: Vector, case: Case
) -> Equation:
    """x_P = x_A - v_Ay / omega, y_P = y_A + v_Ax / omega, with the body's base point A and its
    velocity.
    """
    other = OTHER[axis]
    sign = {"x": -1, "y": 1}[axis]
    base, rate = case.motion.frames.bases[body].point, case.motion.omega(body)
    known = find_known(name_point_vector(base, "velocity", case), velocity, case)
    shares = tuple(list_component(known, other, case))
    start = name_coordinate(axis, case.naming.letter(base))
    place, across = case.motion.points[base][PLACES[axis]], velocity[PLACES[other]]
    symbols, numbers = (
        [_divide(speed.signed(sign), by) for speed in speeds]
        for speeds, by in (
            ((one.in_symbols for one in shares), case.naming.omega(body)),
            ((one.in_numbers for one in shares if one.counts), measure(rate, "rad/s")),
        )
    )
    if choose_axes(case.construction).coordinate(axis, base) != NOTHING:
        symbols, numbers = [start, *symbols], [measure(place, "m"), *numbers]
    sums = map(add_terms, (symbols, numbers) if double(across) else (symbols,))
    place = case.motion.pole(body, case.arithmetic)[PLACES[axis]]
    left = name_coordinate(axis, case.naming.letter(pole))
    return Equation(left, drop_repetition(equate(*sums), state_number(place, "m")))


def _divide(speed: Formula, rate: Formula) -> Formula:
    """A speed over a rate, the sign of the speed before the fraction."""
    return (speed.size / rate).signed(speed.sign)
