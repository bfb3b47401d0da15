"""A driven motion of a point along a direction."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Self

from kinegrade.language.message import Message
from kinegrade.mechanics.drivers.driving_constraint import DrivingConstraint, FindChain
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import ImposedMotion
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.sentence import DriverParts
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic, Number


@dataclass(frozen=True)
class Component(DrivingConstraint):
    """Motion of `point` of `body` along the unit vector `direction`, relative to the body `of`: m/s
    and m/s^2.

    For a point that moves on a straight path this is its motion along the path.
    """

    PATTERN = (
        r"(?P<point>\w+) of (?P<body>\w+) moves along (?P<along>.+?)(?: relative to (?P<of>\w+))?"
    )
    FORM = "POINT of BODY moves along +x|-x|+y|-y|ANGLE [relative to BODY]"
    EXAMPLES = ("B of AB moves along +x", "M of M moves along direction(O, A) relative to AE")
    TURNS = False

    point: str
    body: str
    direction: Vector
    velocity: Number
    acceleration: Number
    of: str = GROUND

    @classmethod
    def make(cls, parts: DriverParts) -> Self:
        """The driver that a sentence states."""
        return cls(
            parts.point,
            parts.body,
            parts.direction,
            parts.velocity,
            parts.acceleration,
            parts.of,
        )

    def list_bodies(self) -> tuple[str, ...]:
        """The body of the point, then the other one."""
        return self.body, self.of

    def list_turning_bodies(self) -> tuple[str, ...]:
        """The body relative to which the point moves."""
        return (self.of,)

    def list_points(self) -> tuple[str, ...]:
        """The point."""
        return (self.point,)

    def describe(self) -> Message:
        """It, as messages name it."""
        return Message("mechanics.component", point=self.point, body=self.body)

    def find_driven_point(self) -> tuple[str, str] | None:
        """The point and its body."""
        return self.point, self.body

    def find_frame(self) -> str | None:
        """That of the component."""
        return self.of

    def state(
        self,
        number: int,
        find_chain: FindChain,
        points: Mapping[str, Vector],
        arithmetic: Arithmetic,
    ) -> Relation:
        """The component of the point's motion relative to the body `of`."""
        return Relation(
            self,
            find_chain(self.body, self.point),
            find_chain(self.of, self.point),
            self.direction,
            velocity=self.velocity,
            acceleration=self.acceleration,
            frame=self.of,
            source=ImposedMotion(number, self.point, self.of, self.direction),
        )
