"""A driven rotation."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Self

from kinegrade.language.message import Message
from kinegrade.mechanics.drivers.driving_constraint import DrivingConstraint, FindChain
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import ImposedRotation
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.sentence import DriverParts
from kinegrade.mechanics.shares import RIGHT
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic, Number


@dataclass(frozen=True)
class Rotation(DrivingConstraint):
    """Rotation of `body` relative to the body `of`: rad/s and rad/s^2, counter-clockwise
    positive.
    """

    PATTERN = r"(?P<body>\w+) turns(?: relative to (?P<of>\w+))?"
    FORM = "BODY turns [relative to BODY]"
    EXAMPLES = ("OA turns", "AB turns relative to OA")
    TURNS = True

    body: str
    velocity: Number
    acceleration: Number
    of: str = GROUND

    @classmethod
    def make(cls, parts: DriverParts) -> Self:
        """The driver that a sentence states."""
        return cls(parts.body, parts.velocity, parts.acceleration, parts.of)

    def list_bodies(self) -> tuple[str, ...]:
        """The body that turns, then the other one."""
        return self.body, self.of

    def list_turning_bodies(self) -> tuple[str, ...]:
        """Both bodies."""
        return self.list_bodies()

    def list_points(self) -> tuple[str, ...]:
        """None."""
        return ()

    def describe(self) -> Message:
        """It, as messages name it."""
        if self.of == GROUND:
            return Message("mechanics.rotation", body=self.body)
        return Message("mechanics.relative-rotation", body=self.body, of=self.of)

    def find_driven_point(self) -> tuple[str, str] | None:
        """None."""
        return None

    def state(
        self,
        number: int,
        find_chain: FindChain,
        points: Mapping[str, Vector],
        arithmetic: Arithmetic,
    ) -> Relation:
        """The difference of the two angular velocities."""
        law = ImposedRotation(number, self.body, self.of)
        return Relation(
            self,
            turning=law.list_factors(RIGHT),
            velocity=self.velocity,
            acceleration=self.acceleration,
            source=law,
        )
