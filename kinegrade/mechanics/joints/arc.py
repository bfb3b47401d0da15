"""A pin in a circular slot or on a circular path."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Self

from kinegrade.language.message import Message
from kinegrade.mechanics.joints.constraint import Unrelated
from kinegrade.mechanics.joints.touching import find_wrong_distance
from kinegrade.mechanics.laws import Condition, GuidedPoint
from kinegrade.mechanics.sentence import OF, JointParts
from kinegrade.mechanics.shapes import Circle, Shape
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic


@dataclass(frozen=True)
class Arc(Unrelated):
    """`point` of `body` stays on a circle fixed in the body `of`; the centre is a point of `of`."""

    PATTERN = rf"(?P<point>\w+) of (?P<body>\w+) stays on (?P<on>circle\(.+\)){OF}"
    FORM = "POINT of BODY stays on CIRCLE [of BODY]"
    EXAMPLES = ("M of AB stays on circle(O1, R) of ring",)
    SLIPS = ()

    point: str
    body: str
    circle: Circle
    of: str

    @classmethod
    def make(cls, parts: JointParts) -> Self:
        """The joint that a sentence states."""
        return cls(parts.point, parts.body, parts.on, parts.of)

    def list_bodies(self) -> tuple[str, ...]:
        """The moving body, then the other one."""
        return self.body, self.of

    def list_turning_bodies(self) -> tuple[str, ...]:
        """The body that carries the line or circle."""
        return (self.of,)

    def list_points(self) -> tuple[str, ...]:
        """The point and the centre."""
        return self.point, self.circle.centre

    def describe(self) -> Message:
        """It, as messages name it."""
        return Message(
            "mechanics.arc", point=self.point, body=self.body, centre=self.circle.centre, of=self.of
        )

    def list_shapes(self) -> tuple[Shape, ...]:
        """The circle."""
        return (self.circle,)

    def list_conditions(self) -> tuple[Condition, ...]:
        """The point is guided."""
        return (GuidedPoint(self.point, self.body, self.of, self.circle),)

    def find_misfits(
        self, points: Mapping[str, Vector], arithmetic: Arithmetic
    ) -> Iterator[Message]:
        """That the point is not at the radius from the centre."""
        ends = (self.point, self.circle.centre)
        yield from find_wrong_distance(ends, self.circle.radius, points, arithmetic)
