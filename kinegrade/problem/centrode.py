"""The fixed centrode: the curve that a body's velocity pole describes while one parameter of the
template changes.

A curve is asked for where it is a circle. The mechanism is assembled and solved at further values
of the parameter, the circle goes through three poles, and a fourth must lie on it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from itertools import islice
from typing import Any

from flint import fmpq

from kinegrade.errors import ExpressionError, MechanismError
from kinegrade.language.message import Message
from kinegrade.mechanics.geometry import Round
from kinegrade.mechanics.motion import solve_motion
from kinegrade.mechanics.plan import Plan
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic
from kinegrade.problem.assembling.assemble import assemble
from kinegrade.problem.quantities.reader import BodyName
from kinegrade.problem.template.template import Template

_STEPS = (
    0,
    1,
    -1,
    2,
    -2,
    3,
    -3,
    4,
    -4,
)  # of 15 degrees from the instant: multiples of 15 stay in a small field


@dataclass(frozen=True)
class Centrodes:
    """Finds centrodes of a template at the values of an instance (SI)."""

    template: Template
    values: Mapping[str, Any]
    plan: Plan | None
    known: dict[tuple[str, str], Round] = field(default_factory=dict)

    def functions(self, arithmetic: Arithmetic) -> dict[str, Callable[..., Any]]:
        """The functions of centrodes that a quantity may call."""
        return {"circle_of_poles": lambda body, angle: self.circle(body, angle, arithmetic)}

    def circle(self, body: Any, angle: Any, arithmetic: Arithmetic) -> Round:
        """The circle on which the pole of `body` moves while the parameter `angle` changes.

        Raises MechanismError when fewer than four configurations can be reached, or the curve is
        not a circle.
        """
        if not isinstance(body, BodyName):
            raise ExpressionError(Message("template.poles-of-a-body"))
        key = (body.name, self.parameter(angle))
        if key not in self.known:
            self.known[key] = self.find(*key, arithmetic)
        found = self.known[key]
        centre = Vector(arithmetic.embed(found.centre.x), arithmetic.embed(found.centre.y))
        return Round(centre, arithmetic.embed(found.radius))

    def find(self, body: str, parameter: str, arithmetic: Arithmetic) -> Round:
        """The circle through three poles, a fourth of which lies on it."""
        poles = list(islice(self.poles(body, parameter, arithmetic), 4))
        if len(poles) < 4:
            raise MechanismError(
                Message("template.centrode-too-short", body=body, parameter=parameter)
            )
        circle = find_circle(poles[0], poles[1], poles[2], arithmetic)
        if not arithmetic.is_zero(
            (poles[3] - circle.centre).squared() - (poles[0] - circle.centre).squared()
        ):
            raise MechanismError(Message("template.centrode-no-circle", body=body))
        return circle

    def parameter(self, angle: Any) -> str:
        """The angular parameter whose value this is."""
        for name, value in self.values.items():
            if value is angle and name in self.template.angles:
                return name
        raise ExpressionError(Message("template.poles-by-an-angle"))

    def poles(self, body: str, parameter: str, arithmetic: Arithmetic) -> Iterator[Vector]:
        """The poles at the instant and at the neighbouring configurations that can be reached."""
        for step in _STEPS:
            changed = self.values[parameter] + arithmetic.turns(fmpq(step, 12))
            try:
                mechanism = assemble(
                    self.template, {**self.values, parameter: changed}, arithmetic
                ).mechanism
                yield solve_motion(mechanism, arithmetic, self.plan).pole(body, arithmetic)
            except MechanismError:
                continue


def find_circle(first: Vector, second: Vector, third: Vector, arithmetic: Arithmetic) -> Round:
    """The circle through three points. Raises MechanismError when they lie on one line."""
    across, along = second - first, third - first
    area = across.cross(along) * 2
    if arithmetic.is_zero(area):
        raise MechanismError(Message("template.poles-on-a-line"))
    offset = (along.turned() * across.squared() - across.turned() * along.squared()) / -area
    return Round(first + offset, arithmetic.sqrt(offset.squared()))
