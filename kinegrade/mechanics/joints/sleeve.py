"""A sleeve: one body slides along another without turning in it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Self

from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.joints.constraint import Unrelated
from kinegrade.mechanics.laws import Condition, EqualRotation, GuidedBody
from kinegrade.mechanics.sentence import JointParts
from kinegrade.mechanics.shapes import Line, Shape
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic


@dataclass(frozen=True)
class Sleeve(Unrelated):
    """`body` slides along `line` in the body `of` and does not turn relative to it."""

    PATTERN = r"(?P<body>\w+) slides through (?P<of>\w+) along (?P<on>line\(.+\))"
    FORM = "BODY slides through BODY along LINE"
    EXAMPLES = ("AB slides through sleeve along line(O, A)",)
    SLIPS = ()

    body: str
    line: Line
    of: str

    @classmethod
    def make(cls, parts: JointParts) -> Self:
        """The joint that a sentence states."""
        return cls(parts.body, parts.on, parts.of)

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
        return Message("mechanics.sleeve", body=self.body, of=self.of)

    def list_shapes(self) -> tuple[Shape, ...]:
        """The line."""
        return (self.line,)

    def list_conditions(self) -> tuple[Condition, ...]:
        """Every point of the body is guided, and the two bodies turn together."""
        return (
            GuidedBody(self.body, self.of, self.line),
            EqualRotation(self.body, self.of, is_sole=False),
        )

    def find_misfits(
        self, points: Mapping[str, Vector], arithmetic: Arithmetic
    ) -> Iterator[Message]:
        """None: it says nothing about where its bodies are."""
        return iter(())

    def find_nonsense(self) -> Iterator[Message]:
        """Also that the ground would slide."""
        yield from super().find_nonsense()
        if self.body == GROUND:
            yield Message("mechanics.sliding-ground")
