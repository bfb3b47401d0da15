"""The fixed centrode of a body where it is a circle: by a proof where one applies, else poles in
several positions, and the circle through them.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice

from kinegrade.expressions.tree import find_names
from kinegrade.language.math.tree import Letter, Text
from kinegrade.language.message import Message
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.centrode import Centrodes, find_circle
from kinegrade.problem.quantities.functions import find_motion_calls
from kinegrade.problem.template.template import Ask
from kinegrade.worked.answers.centrode_proofs import describe_proof, find_proof, state_radius
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block
from kinegrade.worked.formulas.atoms import Measured, Number, Symbol
from kinegrade.worked.formulas.equation import Equation, Link
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.numbers import round_number, state_number, state_quantity
from kinegrade.worked.formulas.symbols import read_symbol
from kinegrade.worked.formulas.tuples import Tuple
from kinegrade.worked.steps.poles.poles import explain_pole, name_pole

_SHOWN = 4
_RADIUS = Symbol((Letter("rho"),))


def explain_centrode(ask: Ask, case: Case) -> Iterator[Block]:
    """How a quantity of the circle on which a pole moves is found; the circle itself is derived
    only once.
    """
    call = next(
        call for call in find_motion_calls(ask.quantity) if call.function == "circle_of_poles"
    )
    body, angle = (next(find_names(argument)) for argument in call.arguments)
    yield from explain_pole(body, case)
    if body not in case.findings.circles:
        case.findings.circles.add(body)
        proof = find_proof(body, case)
        if proof is None:
            yield from _explain_circle(body, angle, case)
        else:
            yield case.say(describe_proof(proof, body, case))
            yield case.show(state_radius(_RADIUS, proof, body, case))
    symbol = read_symbol(ask.symbol)
    if symbol != _RADIUS:
        yield case.show(Equation(symbol, state_quantity(case.solution.answers[ask.name])))


def _explain_circle(body: str, angle: str, case: Case) -> Iterator[Block]:
    """The poles in the given position and in neighbouring ones, and the circle through them."""
    values = {name: case.solution.assembly.values[name] for name in case.template.parameters}
    arithmetic = case.arithmetic.fork()
    poles = list(
        islice(
            Centrodes(case.template, values, case.motion.plan).poles(body, angle, arithmetic),
            _SHOWN,
        )
    )
    letter = case.naming.letter(name_pole(body, case))
    yield case.say(
        Message(
            "solution.centrode",
            body=case.naming.body(body),
            angle=case.text(case.symbols[angle]),
        )
    )
    yield case.show(
        *(
            _locate(letter ** Tuple((Number(str(number)),)), pole)
            for number, pole in enumerate(poles, start=1)
        )
    )
    circle = find_circle(poles[0], poles[1], poles[2], arithmetic)
    yield case.say(Message("solution.centrode-circle"))
    centre = Symbol((Text(case.write(Message("solution.centre-of-circle"))),))
    yield case.show(
        Equation(_RADIUS, state_number(circle.radius, "m")), _locate(centre, circle.centre, "m")
    )


def _locate(name: Formula, point: Vector, unit: str = "1") -> Equation:
    """The coordinates of a point in metres."""
    place = Tuple((round_number(point.x), round_number(point.y)))
    return Equation(name, (Link(":", Measured(place, unit)),))
