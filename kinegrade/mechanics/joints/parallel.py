"""Bodies that turn together."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Self

from kinegrade.language.message import Message
from kinegrade.mechanics.joints.constraint import Unrelated
from kinegrade.mechanics.laws import Condition, EqualRotation
from kinegrade.mechanics.sentence import JointParts
from kinegrade.mechanics.shapes import Shape
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic


@dataclass(frozen=True)
class Parallel(Unrelated):
    """`body` does not turn relative to the body `of`; with the ground: it translates."""

    PATTERN = r"(?P<body>\w+) (?:translates|turns with (?P<of>\w+))"
    FORM = "BODY translates|turns with BODY"
    EXAMPLES = ("BC translates", "rod turns with arm")
    SLIPS = ()

    body: str
    of: str

    @classmethod
    def make(cls, parts: JointParts) -> Self:
        """The joint that a sentence states."""
        return cls(parts.body, parts.of)

    def list_bodies(self) -> tuple[str, ...]:
        """The moving body, then the other one."""
        return self.body, self.of

    def list_turning_bodies(self) -> tuple[str, ...]:
        """Both bodies."""
        return self.body, self.of

    def list_points(self) -> tuple[str, ...]:
        """None."""
        return ()

    def describe(self) -> Message:
        """It, as messages name it."""
        return Message("mechanics.parallel", body=self.body, of=self.of)

    def list_shapes(self) -> tuple[Shape, ...]:
        """None."""
        return ()

    def list_conditions(self) -> tuple[Condition, ...]:
        """The two bodies turn together."""
        return (EqualRotation(self.body, self.of, is_sole=True),)

    def find_misfits(
        self, points: Mapping[str, Vector], arithmetic: Arithmetic
    ) -> Iterator[Message]:
        """None: it says nothing about where its bodies are."""
        return iter(())
