"""Mechanisms written shortly: numbers as texts, points as pairs, bodies as words."""

from __future__ import annotations

from typing import Any

from flint import fmpq

from kinegrade.expressions.evaluation import evaluate, make_elementary_functions
from kinegrade.expressions.reading import read_expression
from kinegrade.mechanics.drivers import Circulation, Component, Driver, Rotation
from kinegrade.mechanics.joints import Circle, Joint, Line
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.motion import Motion, solve_motion
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.field import Field

X, Y = (1, 0), (0, 1)  # the directions of the axes


class Paper:
    """One exact field with short ways of writing into it."""

    def __init__(self) -> None:
        self.field = Field()

    def number(self, value: Any) -> Any:
        """A whole number, or an expression as text."""
        if isinstance(value, str):
            return evaluate(
                read_expression(value),
                {"pi": self.field.turns(1)},
                make_elementary_functions(self.field),
                self.field,
            )
        return fmpq(value) if isinstance(value, int) else value

    def vector(self, x: Any, y: Any) -> Vector:
        return Vector(self.number(x), self.number(y))

    def line(self, x: Any, y: Any, along: tuple[Any, Any]) -> Line:
        """The line through (x, y) along a direction."""
        return Line(self.vector(x, y), self.vector(*along))

    def circle(self, centre: str, radius: Any) -> Circle:
        return Circle(centre, self.number(radius))

    def turns(self, body: str, velocity: Any, acceleration: Any = 0, **of: str) -> Rotation:
        return Rotation(body, self.number(velocity), self.number(acceleration), **of)

    def moves(
        self,
        point: str,
        body: str,
        along: tuple[Any, Any],
        velocity: Any,
        acceleration: Any = 0,
        **of: str,
    ) -> Component:
        return Component(
            point, body, self.vector(*along), self.number(velocity), self.number(acceleration), **of
        )

    def circles(
        self, point: str, body: str, centre: str, velocity: Any, acceleration: Any = 0
    ) -> Circulation:
        return Circulation(point, body, centre, self.number(velocity), self.number(acceleration))

    def mechanism(
        self,
        points: dict[str, tuple[Any, Any]],
        bodies: dict[str, str],
        joints: list[Joint],
        drivers: list[Driver],
    ) -> Mechanism:
        """Bodies are their points in a row; `particle M` for a particle."""
        found = []
        for name, words in bodies.items():
            marked = words.split()
            particle = marked[0] == "particle"
            found.append(Body(name, tuple(marked[particle:]), particle))
        places = {name: self.vector(*place) for name, place in points.items()}
        return Mechanism(places, tuple(found), tuple(joints), tuple(drivers))

    def motion(self, *parts: Any) -> Motion:
        """The exact motion of a mechanism."""
        return solve_motion(self.mechanism(*parts), self.field)
