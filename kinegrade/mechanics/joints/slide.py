"""A pin in a straight slot, guide or sleeve."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Self

from kinegrade.language.message import Message
from kinegrade.mechanics.joints.constraint import Unrelated
from kinegrade.mechanics.laws import Condition, GuidedPoint
from kinegrade.mechanics.sentence import OF, JointParts
from kinegrade.mechanics.shapes import Line, Shape
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic


@dataclass(frozen=True)
class Slide(Unrelated):
    """`point` of `body` stays on a straight line fixed in the body `of` (a guide, a slot, a sleeve
    about a pin).
    """

    PATTERN = rf"(?P<point>\w+) of (?P<body>\w+) slides on (?P<on>line\(.+\)){OF}"
    FORM = "POINT of BODY slides on LINE [of BODY]"
    EXAMPLES = ("B of AB slides on line(O, 0)", "A of AB slides on line(O, A) of OC")
    SLIPS = ()

    point: str
    body: str
    line: Line
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
        """The point."""
        return (self.point,)

    def describe(self) -> Message:
        """It, as messages name it."""
        return Message("mechanics.slide", point=self.point, body=self.body, of=self.of)

    def list_shapes(self) -> tuple[Shape, ...]:
        """The line."""
        return (self.line,)

    def list_conditions(self) -> tuple[Condition, ...]:
        """The point is guided."""
        return (GuidedPoint(self.point, self.body, self.of, self.line, in_slot=True),)

    def find_misfits(
        self, points: Mapping[str, Vector], arithmetic: Arithmetic
    ) -> Iterator[Message]:
        """That the point does not lie on the line."""
        across = self.line.direction.cross(points[self.point] - self.line.point)
        if not arithmetic.is_zero(across):
            yield Message("mechanics.off-line", point=self.point)
