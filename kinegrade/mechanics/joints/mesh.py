"""Meshing gears."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Self

from kinegrade.language.message import Message
from kinegrade.mechanics.joints.carried_pair import CarriedPair
from kinegrade.mechanics.joints.touching import Touching
from kinegrade.mechanics.laws import EqualPitchSpeed, Law
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.sentence import CIRCLE, INSIDE, JointParts
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic


@dataclass(frozen=True)
class Mesh(CarriedPair):
    """Two gears with their centres on one `carrier`; `inside` when one of them is a ring gear
    around the other.
    """

    PATTERN = (
        rf"{CIRCLE} meshes with (?P<on>circle\(.+?\)) of (?P<of>\w+) "
        rf"on (?P<carrier>\w+){INSIDE}"
    )
    FORM = "CIRCLE of BODY meshes with CIRCLE of BODY on BODY [inside]"
    EXAMPLES = ("circle(A, r1) of I meshes with circle(B, r2) of II on arm",)
    SLIPS = ("meshing", "carried", "arm", "ratio", "centre")

    inside: bool = False

    @classmethod
    def make(cls, parts: JointParts) -> Self:
        """The joint that a sentence states."""
        return cls(
            parts.body, parts.circle, parts.of, parts.on, parts.carrier, "inside" in parts.options
        )

    def describe(self) -> Message:
        """It, as messages name it."""
        return Message("mechanics.mesh", body=self.body, of=self.of)

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
        touching = Touching(self.circle, self.on, self.inside)
        return touching.find_misfits(points, arithmetic)
