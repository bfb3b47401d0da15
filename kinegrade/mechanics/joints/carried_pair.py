"""What gears in mesh and pulleys on a belt have in common: two round bodies on one carrier."""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.mechanics.joints.constraint import Constraint
from kinegrade.mechanics.laws import Condition, SharedPoint
from kinegrade.mechanics.shapes import Circle, Shape


@dataclass(frozen=True)
class CarriedPair(Constraint):
    """The circle of `body` and the circle `on` of the body `of`, with their centres pinned to
    `carrier`.
    """

    body: str
    circle: Circle
    of: str
    on: Circle
    carrier: str

    def list_bodies(self) -> tuple[str, ...]:
        """The round bodies, then the carrier."""
        return self.body, self.of, self.carrier

    def list_turning_bodies(self) -> tuple[str, ...]:
        """All three bodies."""
        return self.list_bodies()

    def list_points(self) -> tuple[str, ...]:
        """The centres of the circles."""
        return self.circle.centre, self.on.centre

    def list_shapes(self) -> tuple[Shape, ...]:
        """The two circles."""
        return self.circle, self.on

    def list_conditions(self) -> tuple[Condition, ...]:
        """None: the carrier holds the centres."""
        return ()

    def list_needed_pins(self) -> tuple[SharedPoint, ...]:
        """Each round body turns about its centre on the carrier."""
        return (
            SharedPoint(self.circle.centre, (self.body, self.carrier)),
            SharedPoint(self.on.centre, (self.of, self.carrier)),
        )
