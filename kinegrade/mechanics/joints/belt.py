"""A belt about two pulleys."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Self

from kinegrade.language.message import Message
from kinegrade.mechanics.geometry import round_short, size
from kinegrade.mechanics.joints.carried_pair import CarriedPair
from kinegrade.mechanics.laws import EqualBeltSpeed, Law
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.sentence import CIRCLE, JointParts
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic


@dataclass(frozen=True)
class Belt(CarriedPair):
    """A taut belt runs without slipping about two pulleys with their centres on one `carrier`;
    `crossed` when its strands cross between them, so that the pulleys turn in opposite senses.
    """

    PATTERN = (
        rf"(?:(?P<crossed>crossed)|open) belt: {CIRCLE}, (?P<on>circle\(.+?\)) of (?P<of>\w+) "
        r"on (?P<carrier>\w+)"
    )
    FORM = "open|crossed belt: CIRCLE of BODY, CIRCLE of BODY on BODY"
    EXAMPLES = ("open belt: circle(A, r1) of I, circle(B, r2) of II on ground",)
    SLIPS = ("crossing", "carried", "ratio")

    crossed: bool = False

    @classmethod
    def make(cls, parts: JointParts) -> Self:
        """The joint that a sentence states."""
        crossed = "crossed" in parts.options
        return cls(parts.body, parts.circle, parts.of, parts.on, parts.carrier, crossed)

    def describe(self) -> Message:
        """It, as messages name it."""
        return Message("mechanics.belt", body=self.body, of=self.of)

    def relate_rates(
        self, number: int, points: Mapping[str, Vector], guided: Rate | None
    ) -> Law | None:
        """The rotations relative to the carrier go together."""
        return EqualBeltSpeed(
            number, self.body, self.circle, self.of, self.on, self.carrier, self.crossed
        )

    def find_misfits(
        self, points: Mapping[str, Vector], arithmetic: Arithmetic
    ) -> Iterator[Message]:
        """That the pulleys are too near: a crossed belt runs between them, an open one needs that
        neither lies within the other.
        """
        first, second = self.list_points()
        other = self.on.radius if self.crossed else -self.on.radius
        least = self.circle.radius + other
        square = (points[first] - points[second]).squared()
        room = square - least * least
        if arithmetic.is_zero(room) or arithmetic.sign(room) < 0:
            shape = "crossed" if self.crossed else "open"
            yield Message(
                f"mechanics.belt-too-near-{shape}",
                first=first,
                second=second,
                distance=round_short(size(square) ** 0.5),
                least=round_short(abs(least)),
            )
