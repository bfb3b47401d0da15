"""The fixed centrode of a body where it is a circle: poles in several positions, and the circle
through them.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice

from kinegrade.expression import Name
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.centrode import Centrodes, through
from kinegrade.problem.template import Ask
from kinegrade.worked.document import Block, Display, Prose
from kinegrade.worked.formula_text import symbols_of
from kinegrade.worked.needed_rates import calls
from kinegrade.worked.numbers import short, stated, stated_quantity
from kinegrade.worked.phrases import phrase
from kinegrade.worked.points import Findings
from kinegrade.worked.poles import pole_blocks, pole_name
from kinegrade.worked.solution_case import Case

SHOWN = 4
RADIUS = r"\rho"


def centrode_blocks(ask: Ask, case: Case, findings: Findings) -> Iterator[Block]:
    """How a quantity of the circle on which a pole moves is found; the circle itself is derived
    only once.
    """
    call = next(call for call in calls(ask.quantity) if call.function == "circle_of_poles")
    body, angle = (argument.name for argument in call.arguments if isinstance(argument, Name))
    yield from pole_blocks(body, case, findings)
    if (circle := f"circle {body}") not in findings.poles:
        findings.poles[circle] = ""
        yield from circle_blocks(body, angle, case)
    if ask.symbol != RADIUS:
        yield Display((f"{ask.symbol} &= {stated_quantity(case.solution.answers[ask.name])}",))


def circle_blocks(body: str, angle: str, case: Case) -> Iterator[Block]:
    """The poles in the given position and in neighbouring ones, and the circle through them."""
    values = {name: case.solution.assembly.values[name] for name in case.template.parameters}
    arithmetic = case.arithmetic.fork()
    poles = list(
        islice(
            Centrodes(case.template, values, case.motion.plan).poles(body, angle, arithmetic), SHOWN
        )
    )
    letter = case.naming.point(pole_name(body, case))
    yield Prose(
        phrase(
            "centrode",
            case.language,
            body=case.naming.body(body),
            angle=symbols_of(case.template)[angle],
        )
    )
    yield Display(
        tuple(
            f"{letter}^{{({number})}} &: ({coordinates(pole)})"
            for number, pole in enumerate(poles, start=1)
        )
    )
    circle = through(poles[0], poles[1], poles[2], arithmetic)
    yield Prose(phrase("centrode_circle", case.language))
    radius = stated(circle.radius, "m")
    yield Display(
        (
            f"{RADIUS} &= {radius}",
            rf"\text{{{phrase('centre', case.language)}}} &: "
            rf"({coordinates(circle.centre)})\,\unit{{m}}",
        )
    )


def coordinates(point: Vector) -> str:
    """The coordinates of a point in metres."""
    return rf"{short(point.x)},\ {short(point.y)}"
