"""Rolling without slipping."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from kinegrade.language.message import Message
from kinegrade.mechanics.joints.touching_pair import TouchingPair
from kinegrade.mechanics.laws import Law, NoSlip
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.sentence import CIRCLE, INSIDE, OF, ON_SHAPE
from kinegrade.mechanics.vector import Vector


@dataclass(frozen=True)
class Roll(TouchingPair):
    """A circle of `body` rolls without slipping on a line or circle of the body `of`."""

    PATTERN = rf"{CIRCLE} rolls on {ON_SHAPE}{OF}{INSIDE}"
    FORM = "CIRCLE of BODY rolls on LINE|CIRCLE [of BODY] [inside]"
    EXAMPLES = (
        "circle(A, r) of wheel rolls on line(O, 0)",
        "circle(A, r2) of II rolls on circle(O, r1) inside",
    )
    SLIPS = ("meshing", "carried", "arm", "ratio", "centre")

    def list_turning_bodies(self) -> tuple[str, ...]:
        """Both bodies."""
        return self.body, self.of

    def describe(self) -> Message:
        """It, as messages name it."""
        return Message("mechanics.roll", body=self.body, of=self.of)

    def relate_rates(
        self, number: int, points: Mapping[str, Vector], guided: Rate | None
    ) -> Law | None:
        """The rotation goes with the motion of the centre."""
        if guided is None:
            return None
        centre = points[self.circle.centre]
        return NoSlip(number, self.body, self.circle, self.of, self.on, self.inside, guided, centre)
