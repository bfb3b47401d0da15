"""A driven motion of a point on a circular path."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Self

from kinegrade.errors import MechanismError
from kinegrade.language.message import Fault, Message
from kinegrade.mechanics.drivers.driving_constraint import DrivingConstraint, FindChain
from kinegrade.mechanics.laws import ImposedCircling
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.sentence import DriverParts
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic, Number


@dataclass(frozen=True)
class Circulation(DrivingConstraint):
    """Motion of `point` of `body` along its circular path about the fixed point `centre`.

    Velocity in m/s and tangential acceleration in m/s^2, counter-clockwise about the centre
    positive.
    """

    PATTERN = r"(?P<point>\w+) of (?P<body>\w+) circles (?P<centre>\w+)"
    FORM = "POINT of BODY circles POINT"
    EXAMPLES = ("A of W circles O",)
    TURNS = False

    point: str
    body: str
    centre: str
    velocity: Number
    acceleration: Number

    @classmethod
    def make(cls, parts: DriverParts) -> Self:
        """The driver that a sentence states."""
        return cls(parts.point, parts.body, parts.centre, parts.velocity, parts.acceleration)

    def list_bodies(self) -> tuple[str, ...]:
        """The body of the point."""
        return (self.body,)

    def list_turning_bodies(self) -> tuple[str, ...]:
        """None: a particle may circle."""
        return ()

    def list_points(self) -> tuple[str, ...]:
        """The point and the centre."""
        return self.point, self.centre

    def describe(self) -> Message:
        """It, as messages name it."""
        return Message(
            "mechanics.circulation", point=self.point, body=self.body, centre=self.centre
        )

    def find_nonsense(self) -> Iterator[Message]:
        """Nothing: it names one body alone."""
        return iter(())

    def find_driven_point(self) -> tuple[str, str] | None:
        """The point and its body."""
        return self.point, self.body

    def state(
        self,
        number: int,
        find_chain: FindChain,
        points: Mapping[str, Vector],
        arithmetic: Arithmetic,
    ) -> Relation:
        """The component of the point's motion along its path."""
        return Relation(
            self,
            find_chain(self.body, self.point),
            along=self._find_direction(points, arithmetic),
            velocity=self.velocity,
            acceleration=self.acceleration,
            source=ImposedCircling(number, self.point, self.centre),
        )

    def _find_direction(self, points: Mapping[str, Vector], arithmetic: Arithmetic) -> Vector:
        """The unit vector along the path, counter-clockwise. Raises MechanismError at the
        centre.
        """
        arm = points[self.point] - points[self.centre]
        if arithmetic.is_zero(arm.squared()):
            what = Message("mechanics.at-centre", point=self.point)
            raise MechanismError(Fault(self.describe(), what))
        tangent: Vector = arm.turned() / arithmetic.sqrt(arm.squared())
        return tangent
