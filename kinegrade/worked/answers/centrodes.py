"""The fixed centrode of a body where it is a circle: poles in several positions, and the circle
through them.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice

from kinegrade.expressions.expression import Name
from kinegrade.language.message import Message
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.centrode import Centrodes, find_circle
from kinegrade.problem.quantities.functions import find_motion_calls
from kinegrade.problem.template.template import Ask
from kinegrade.worked.document import Block, Display
from kinegrade.worked.formulas.expression import collect_symbols
from kinegrade.worked.formulas.numbers import write_number, write_quantity, write_short
from kinegrade.worked.steps.findings import Findings
from kinegrade.worked.steps.poles import explain_pole, name_pole
from kinegrade.worked.words.solution_case import Case

_SHOWN = 4
_RADIUS = r"\rho"


def explain_centrode(ask: Ask, case: Case, findings: Findings) -> Iterator[Block]:
    """How a quantity of the circle on which a pole moves is found; the circle itself is derived
    only once.
    """
    call = next(
        call for call in find_motion_calls(ask.quantity) if call.function == "circle_of_poles"
    )
    body, angle = (argument.name for argument in call.arguments if isinstance(argument, Name))
    yield from explain_pole(body, case, findings)
    if (circle := f"circle {body}") not in findings.poles:
        findings.poles[circle] = ""
        yield from _explain_circle(body, angle, case)
    if ask.symbol != _RADIUS:
        yield Display((f"{ask.symbol} &= {write_quantity(case.solution.answers[ask.name])}",))


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
    letter = case.naming.point(name_pole(body, case))
    yield case.say(
        Message(
            "solution.centrode",
            body=case.naming.body(body),
            angle=collect_symbols(case.template)[angle],
        )
    )
    yield Display(
        tuple(
            f"{letter}^{{({number})}} &: ({_write_coordinates(pole)})"
            for number, pole in enumerate(poles, start=1)
        )
    )
    circle = find_circle(poles[0], poles[1], poles[2], arithmetic)
    yield case.say(Message("solution.centrode-circle"))
    radius = write_number(circle.radius, "m")
    yield Display(
        (
            f"{_RADIUS} &= {radius}",
            rf"\text{{{case.write(Message('solution.centre-of-circle'))}}} &: "
            rf"({_write_coordinates(circle.centre)})\,\unit{{m}}",
        )
    )


def _write_coordinates(point: Vector) -> str:
    """The coordinates of a point in metres."""
    return rf"{write_short(point.x)},\ {write_short(point.y)}"
