"""A smooth contact of two profiles."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from kinegrade.language.message import Message
from kinegrade.mechanics.joints.touching_pair import TouchingPair
from kinegrade.mechanics.laws import Law
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.sentence import CIRCLE, INSIDE, OF, ON_SHAPE
from kinegrade.mechanics.vector import Vector


@dataclass(frozen=True)
class Contact(TouchingPair):
    """A circle of `body` touches a line or circle of the body `of` and may slide on it (smooth
    contact).
    """

    PATTERN = rf"{CIRCLE} touches {ON_SHAPE}{OF}{INSIDE}"
    FORM = "CIRCLE of BODY touches LINE|CIRCLE [of BODY] [inside]"
    EXAMPLES = ("circle(C, R) of cam touches line(A, 0) of BC",)
    SLIPS = ()
    TOUCHES = True

    def list_turning_bodies(self) -> tuple[str, ...]:
        """The body that carries the line or circle."""
        return (self.of,)

    def describe(self) -> Message:
        """It, as messages name it."""
        return Message("mechanics.contact", body=self.body, of=self.of)

    def relate_rates(
        self, number: int, points: Mapping[str, Vector], guided: Rate | None
    ) -> Law | None:
        """Not at all."""
        return None
