"""Rolling without slipping."""

from __future__ import annotations

from dataclasses import dataclass
from typing import assert_never

from kinegrade.language.message import Message
from kinegrade.mechanics.geometry import foot
from kinegrade.mechanics.laws.reason import Reason
from kinegrade.mechanics.laws.turning import Arm, Turning, add_up, measure_arm
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.shapes import Circle, Line, Shape
from kinegrade.mechanics.shares import Shares
from kinegrade.mechanics.vector import Vector


@dataclass(frozen=True)
class NoSlip(Reason):
    """A circle of `body`, its centre at `centre`, rolls on a line or circle of the body `of`.

    `rate` is that of its centre along the track. `joint` numbers the joints of the mechanism.
    """

    joint: int
    body: str
    circle: Circle
    of: str
    on: Shape
    inside: bool
    rate: Rate
    centre: Vector

    def describe(self, element: Message) -> Message:
        """That the rolling is without slip."""
        return Message("mechanics.no-slip", rolling=element)

    @property
    def is_given(self) -> bool:
        """No: it links the rotation with the motion of the centre."""
        return False

    def list_factors(self, shares: Shares) -> Turning:
        """The centre's motion along the track plus the relative rotation about it is zero.

        On a line: s u.u + omega_r u.(k x CF) = 0; on a circle of radius R: rate of the centre plus
        omega_r times -r/(R + r) outside, r/(R - r) inside (F the contact, C the centre of the
        rolling circle, r its radius); a forgotten r leaves -r/R.
        """
        match self.on:
            case Line(direction=along):
                arm = foot(self.centre, self.on) - self.centre
                slip = along.dot(arm.turned()) / along.squared()
                carried = slip * shares.carried
            case Circle(radius=other):
                radius = self.circle.radius * shares.find_sense(inside=self.inside)
                distance = other + shares.arm * shares.carried * radius
                radius, distance = shares.relate(radius, distance)
                slip = carried = -radius / distance
            case _:
                assert_never(self.on)
        return ((self.rate, 1), *add_up((self.body, slip), (self.of, -carried)))

    def list_arms(self, shares: Shares) -> tuple[Arm, ...]:
        """That of the rolling circle's centre about the centre of a circular track."""
        if not isinstance(self.on, Circle):
            return ()
        return (measure_arm(self.circle, self.on, self.inside, shares),)


def find_rolling(law: Reason | None) -> NoSlip | None:
    """The rolling without slipping that a law is; None where it is something else."""
    return law if isinstance(law, NoSlip) else None
