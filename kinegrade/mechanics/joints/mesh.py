"""Meshing gears."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Self

from kinegrade.language.message import Message
from kinegrade.mechanics.joints.constraint import Constraint
from kinegrade.mechanics.joints.touching import Touching
from kinegrade.mechanics.laws import Condition, EqualPitchSpeed, Law
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.sentence import CIRCLE, INSIDE, JointParts
from kinegrade.mechanics.shapes import Circle, Shape
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic


@dataclass(frozen=True)
class Mesh(Constraint):
    """Two gears with their centres on one `carrier`; `inside` when one of them is a ring gear
    around the other.
    """

    KIND = "mesh"
    PATTERN = (
        rf"{CIRCLE} meshes with (?P<on>circle\(.+?\)) of (?P<of>\w+) "
        rf"on (?P<carrier>\w+){INSIDE}"
    )
    EXAMPLE = "... meshes with ... on ..."

    body: str
    circle: Circle
    of: str
    on: Circle
    carrier: str
    inside: bool = False

    @classmethod
    def make(cls, parts: JointParts) -> Self:
        """The joint that a sentence states."""
        return cls(parts.body, parts.circle, parts.of, parts.on, parts.carrier, parts.inside)

    def list_bodies(self) -> tuple[str, ...]:
        """The gears, then the carrier."""
        return self.body, self.of, self.carrier

    def list_turning_bodies(self) -> tuple[str, ...]:
        """All three bodies."""
        return self.list_bodies()

    def list_points(self) -> tuple[str, ...]:
        """The centres of the circles."""
        return self._touching.list_centres()

    def describe(self) -> Message:
        """It, as messages name it."""
        return Message("mechanics.mesh", body=self.body, of=self.of)

    def list_shapes(self) -> tuple[Shape, ...]:
        """The circle and what it runs on."""
        return self.circle, self.on

    def list_conditions(self) -> tuple[Condition, ...]:
        """None: the carrier holds the centres."""
        return ()

    def relate_rates(
        self, number: int, points: Mapping[str, Vector], guided: Rate | None
    ) -> Law | None:
        """The rotations relative to the carrier go together."""
        return EqualPitchSpeed(
            number, self.body, self.circle, self.of, self.on, self.carrier, self.inside
        )

    def find_misfits(
        self, points: Mapping[str, Vector], arithmetic: Arithmetic
    ) -> Iterator[Message]:
        """That the two profiles do not touch."""
        return self._touching.find_misfits(points, arithmetic)

    @property
    def _touching(self) -> Touching:
        return Touching(self.circle, self.on, self.inside)
