"""A smooth contact of two profiles."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Self

from kinegrade.language.message import Message
from kinegrade.mechanics.joints.constraint import Constraint
from kinegrade.mechanics.joints.touching import Touching
from kinegrade.mechanics.laws import Condition, GuidedPoint, Law
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.sentence import CIRCLE, INSIDE, OF, ON_SHAPE, JointParts
from kinegrade.mechanics.shapes import Circle, Shape
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic


@dataclass(frozen=True)
class Contact(Constraint):
    """A circle of `body` touches a line or circle of the body `of` and may slide on it (smooth
    contact).

    `inside` is for two circles only: one lies within the other.
    """

    PATTERN = rf"{CIRCLE} touches {ON_SHAPE}{OF}{INSIDE}"
    EXAMPLE = "... touches ..."
    SLIPS = ()
    TOUCHES = True

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

    def list_turning_bodies(self) -> tuple[str, ...]:
        """The body that carries the line or circle."""
        return (self.of,)

    def list_points(self) -> tuple[str, ...]:
        """The centres of the circles."""
        return self._touching.list_centres()

    def describe(self) -> Message:
        """It, as messages name it."""
        return Message("mechanics.contact", body=self.body, of=self.of)

    def list_shapes(self) -> tuple[Shape, ...]:
        """The circle and what it runs on."""
        return self.circle, self.on

    def list_conditions(self) -> tuple[Condition, ...]:
        """The centre is guided at its distance from the other profile."""
        return (GuidedPoint(self.circle.centre, self.body, self.of, self.on),)

    def relate_rates(
        self, number: int, points: Mapping[str, Vector], guided: Rate | None
    ) -> Law | None:
        """Not at all."""
        return None

    def find_misfits(
        self, points: Mapping[str, Vector], arithmetic: Arithmetic
    ) -> Iterator[Message]:
        """That the two profiles do not touch."""
        return self._touching.find_misfits(points, arithmetic)

    @property
    def _touching(self) -> Touching:
        return Touching(self.circle, self.on, self.inside)
