"""What contacts and rolling have in common: a circle of one body on a line or circle of another."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Self

from kinegrade.language.message import Message
from kinegrade.mechanics.joints.constraint import Constraint
from kinegrade.mechanics.joints.touching import Touching
from kinegrade.mechanics.laws import Condition, GuidedPoint
from kinegrade.mechanics.sentence import JointParts
from kinegrade.mechanics.shapes import Circle, Shape
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic


@dataclass(frozen=True)
class TouchingPair(Constraint):
    """The circle of `body` and the line or circle `on` of the body `of`.

    `inside` is for two circles only: one lies within the other.
    """

    body: str
    circle: Circle
    of: str
    on: Shape
    inside: bool = False

    @classmethod
    def make(cls, parts: JointParts) -> Self:
        """The joint that a sentence states."""
        return cls(parts.body, parts.circle, parts.of, parts.on, "inside" in parts.options)

    def list_bodies(self) -> tuple[str, ...]:
        """The moving body, then the other one."""
        return self.body, self.of

    def list_points(self) -> tuple[str, ...]:
        """The centres of the circles."""
        return self._touching.list_centres()

    def list_shapes(self) -> tuple[Shape, ...]:
        """The circle and what it runs on."""
        return self.circle, self.on

    def list_conditions(self) -> tuple[Condition, ...]:
        """The centre is guided at its distance from the other profile."""
        return (GuidedPoint(self.circle.centre, self.body, self.of, self.on),)

    def find_misfits(
        self, points: Mapping[str, Vector], arithmetic: Arithmetic
    ) -> Iterator[Message]:
        """That the two profiles do not touch."""
        return self._touching.find_misfits(points, arithmetic)

    @property
    def _touching(self) -> Touching:
        return Touching(self.circle, self.on, self.inside)
