"""The velocity pole of a body: where it lies, from the velocity of one point and the rotation."""

from __future__ import annotations

import re
from collections.abc import Iterator

from kinegrade.expressions.expression import Call, Name
from kinegrade.language.message import Message
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.quantities.functions import find_motion_calls
from kinegrade.worked.document import Block, Display
from kinegrade.worked.formulas.numbers import double, write_number, write_short
from kinegrade.worked.steps.findings import Findings, write_point_symbol
from kinegrade.worked.steps.points import find_point, find_vector
from kinegrade.worked.steps.summands import write_component
from kinegrade.worked.words.solution_case import Case


def name_pole(body: str, case: Case) -> str:
    """The letter of a body's pole: the one by which an ask names it, else P, or a letter that no
    point has.
    """
    for ask in case.template.asks.values():
        named = re.match(r"[xy]_\{?([A-Z])\}?$", ask.symbol)
        if named and Call("pole", (Name(body),)) in find_motion_calls(ask.quantity):
            return named[1]
    letter = next((name for name in "PSQZ" if name not in case.motion.points), "P")
    bodies = sorted(
        {
            call.arguments[0].name
            for ask in case.template.asks.values()
            for call in find_motion_calls(ask.quantity)
            if call.function == "pole" and isinstance(call.arguments[0], Name)
        }
    )
    return f"{letter}{bodies.index(body) + 1}" if len(bodies) > 1 and body in bodies else letter


def explain_pole(body: str, case: Case, findings: Findings) -> Iterator[Block]:
    """Where the pole of a body lies; derived only once."""
    if body in findings.poles:
        return
    name = findings.poles[body] = name_pole(body, case)
    if case.arithmetic.is_zero(case.motion.omega(body)):
        yield case.say(Message("solution.pole-far", body=case.naming.body(body)))
        return
    base = case.motion.frames.bases[body]
    symbol = write_point_symbol(base.point, "velocity", case)
    yield from find_point(base.chain, symbol, case, "velocity", findings)
    letter = case.naming.point(name)
    yield case.say(Message("solution.pole-of", body=case.naming.body(body), pole=letter))
    velocity = find_vector(base.chain, case.motion, "velocity")
    yield Display(tuple(_write_pole_line(axis, letter, body, velocity, case) for axis in "xy"))


def _write_pole_line(axis: str, letter: str, body: str, velocity: Vector, case: Case) -> str:
    """x_P = x_A - v_Ay / omega, y_P = y_A + v_Ax / omega, with the body's base point A and its
    velocity.
    """
    along, across, other, sign = (0, 1, "y", "-") if axis == "x" else (1, 0, "x", "+")
    base, rate = case.motion.frames.bases[body].point, case.motion.omega(body)
    point, at = case.naming.point(base), case.motion.points[base]
    pole = case.motion.pole(body, case.arithmetic)
    moved = (
        rf"{write_short(at[along])} {sign} "
        rf"\frac{{{write_short(velocity[across])}}}{{{write_short(rate)}}} = "
    )
    numbers = moved if double(velocity[across]) else ""
    speed = write_component(write_point_symbol(base, "velocity", case), other)
    return (
        rf"{axis}_{{{letter}}} &= {axis}_{{{point}}} {sign} \frac{{{speed}}}"
        rf"{{{case.naming.omega(body)}}} = {numbers}{write_number(pole[along], 'm')}"
    )
