"""A pin: bodies that share a point."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Self

from kinegrade.language.message import Message, list_all
from kinegrade.mechanics.joints.constraint import Unrelated
from kinegrade.mechanics.laws import Condition, SharedPoint
from kinegrade.mechanics.sentence import JointParts
from kinegrade.mechanics.shapes import Shape
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic


@dataclass(frozen=True)
class Pin(Unrelated):
    """Two or more bodies (the ground may be one) share `point`."""

    PATTERN = r"pin (?P<point>\w+): (?P<bodies>\w+(?:[ ,]+\w+)+)"
    FORM = "pin POINT: BODY BODY ..."
    EXAMPLES = ("pin A: OA AB", "pin O: ground OA")
    SLIPS = ("pole",)

    point: str
    bodies: tuple[str, ...]

    @classmethod
    def make(cls, parts: JointParts) -> Self:
        """The joint that a sentence states."""
        return cls(parts.point, parts.bodies)

    def list_bodies(self) -> tuple[str, ...]:
        """All bodies."""
        return self.bodies

    def list_turning_bodies(self) -> tuple[str, ...]:
        """None: a particle may be pinned."""
        return ()

    def list_points(self) -> tuple[str, ...]:
        """The point."""
        return (self.point,)

    def describe(self) -> Message:
        """It, as messages name it."""
        return Message("mechanics.pin", point=self.point, bodies=list_all(self.bodies))

    def list_shapes(self) -> tuple[Shape, ...]:
        """None."""
        return ()

    def list_conditions(self) -> tuple[Condition, ...]:
        """The bodies share the point."""
        return (SharedPoint(self.point, self.bodies),)

    def find_misfits(
        self, points: Mapping[str, Vector], arithmetic: Arithmetic
    ) -> Iterator[Message]:
        """None: it says nothing about where its bodies are."""
        return iter(())
