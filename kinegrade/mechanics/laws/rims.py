"""Circles with equal rim speeds: gears in mesh, and pulleys in a belt."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass
from typing import ClassVar

from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws.reason import Reason
from kinegrade.mechanics.laws.turning import Arm, Turning, add_up, measure_arm
from kinegrade.mechanics.shapes import Circle
from kinegrade.mechanics.shares import Shares
from kinegrade.numbers.number import Number


@dataclass(frozen=True)
class EqualRimSpeed(Reason):
    """Two circles with their centres on one `carrier` have equal rim speeds relative to it. `joint`
    numbers the joints of the mechanism; `is_belt` tells a belt from gears in mesh.
    """

    is_belt: ClassVar[bool] = False
    joint: int
    body: str
    circle: Circle
    of: str
    on: Circle
    carrier: str

    def describe(self, element: Message) -> Message:
        """The joint's own name."""
        return element

    @property
    def is_given(self) -> bool:
        """No: it links two rotations."""
        return False

    @property
    @abstractmethod
    def is_opposite(self) -> bool:
        """Whether the two turn in opposite senses, seen from the carrier."""

    @abstractmethod
    def select_share(self, shares: Shares) -> Number:
        """What is taken of their sense."""

    def list_factors(self, shares: Shares) -> Turning:
        """r1 (omega_1 - c omega_c) + r2 (omega_2 - omega_c), with -r2 where both turn in the same
        sense; c is the share of the carrier's rotation that is taken into account, at the second
        circle where the first one is the ground's.
        """
        sense = self.select_share(shares)
        radius, other = shares.relate(self.circle.radius, self.on.radius)
        other = other * (sense if self.is_opposite else -sense)
        first, second = (shares.carried, 1) if self.body != GROUND else (1, shares.carried)
        return add_up(
            (self.body, radius),
            (self.carrier, -radius * first),
            (self.of, other),
            (self.carrier, -other * second),
        )


@dataclass(frozen=True)
class EqualPitchSpeed(EqualRimSpeed):
    """The circles roll on each other as gears do; `inside` where one lies within the other."""

    inside: bool

    @property
    def is_opposite(self) -> bool:
        """Where they touch from outside."""
        return not self.inside

    def select_share(self, shares: Shares) -> Number:
        """That of inside for outside."""
        return shares.meshing

    def list_arms(self, shares: Shares) -> tuple[Arm, ...]:
        """That of the first centre about the second one."""
        return (measure_arm(self.circle, self.on, self.inside, shares),)


@dataclass(frozen=True)
class EqualBeltSpeed(EqualRimSpeed):
    """A belt runs about the circles; `crossed` where its strands cross between them."""

    is_belt: ClassVar[bool] = True
    crossed: bool

    @property
    def is_opposite(self) -> bool:
        """Where the belt is crossed."""
        return self.crossed

    def select_share(self, shares: Shares) -> Number:
        """That of open for crossed."""
        return shares.crossing


def find_rims(law: Reason | None) -> EqualRimSpeed | None:
    """The rims of equal speed that a law is; None where it is something else."""
    return law if isinstance(law, EqualRimSpeed) else None
