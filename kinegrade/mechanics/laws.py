"""The laws: why the rates of a mechanism are related, each a value that a relation carries.

A law of turning rates gives their factors, from shares that a student may take of its parts: all of
them are 1 where it is right.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from typing import ClassVar, Self, assert_never

from kinegrade.language.message import Message
from kinegrade.mechanics.geometry import foot
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.rates import Rate, make_turning
from kinegrade.mechanics.shapes import Circle, Line, Shape
from kinegrade.mechanics.shares import Shares
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Number

Turning = tuple[tuple[Rate, Number], ...]
# The point of a carried centre, the centre about which it runs, and the share of their distance
Arm = tuple[str, str, Number]


@dataclass(frozen=True)
class Reason(ABC):
    """What every law can say, and whether it `keeps_parallel` two bodies.

    The factors of a law of turning rates are the same in every position, so that they hold for the
    angles themselves.
    """

    keeps_parallel: ClassVar[bool] = False

    @abstractmethod
    def describe(self, element: Message) -> Message:
        """The relation in messages, given the name of the joint or driver that states it."""

    @property
    @abstractmethod
    def is_given(self) -> bool:
        """Whether it only states what is given."""

    @abstractmethod
    def list_factors(self, shares: Shares) -> Turning:
        """The factors of the turning rates and of a guided centre's rate; none for an equation of
        vectors.
        """

    def list_arms(self, shares: Shares) -> tuple[Arm, ...]:
        """The arms that carry wheels on circles, with the shares that are taken of them: none."""
        return ()

    def find_guided_body(self) -> str | None:
        """The moving body whose point it guides; None where it guides none."""
        return None

    def find_rolling(self) -> NoSlip | None:
        """The rolling without slipping that it is; None where it is something else."""
        return None

    def find_rims(self) -> EqualRimSpeed | None:
        """The rims of equal speed that it is; None where it is something else."""
        return None

    def find_imposed_direction(self) -> Vector | None:
        """The direction along which a driver imposes a motion; None where none does."""
        return None

    def find_imposed_circle(self) -> tuple[str, str] | None:
        """The point that a driver moves on a circle, and its centre; None where none does."""
        return None

    def map(self, number: Callable[[Number], Number]) -> Self:
        """The law with `number` applied to its vectors, lines and circles."""
        parts = {each.name: getattr(self, each.name) for each in fields(self)}
        mapped = {
            name: part.map(number)
            for name, part in parts.items()
            if isinstance(part, (Vector, Line, Circle))
        }
        return replace(self, **mapped) if mapped else self


class _OfVectors(Reason):
    """A law of vectors, which names no turning rate itself."""

    def describe(self, element: Message) -> Message:
        """The joint's or driver's own name."""
        return element

    def list_factors(self, shares: Shares) -> Turning:
        """None."""
        return ()


@dataclass(frozen=True)
class SharedPoint(_OfVectors):
    """Two or more bodies have the velocity and acceleration of one point in common."""

    point: str
    bodies: tuple[str, ...]

    @property
    def is_given(self) -> bool:
        """No: it closes a loop."""
        return False


@dataclass(frozen=True)
class GuidedPoint(_OfVectors):
    """`point` of `body` moves along a line, or about the centre of a circle, of the body `of`.

    `in_slot` where a pin at the point itself slides in a straight slot or guide.
    """

    point: str
    body: str
    of: str
    track: Shape
    in_slot: bool = False

    @property
    def is_given(self) -> bool:
        """No: it closes a loop."""
        return False

    def find_guided_body(self) -> str | None:
        """The body of the point, unless that is fixed."""
        return self.body if self.body != GROUND else None


@dataclass(frozen=True)
class GuidedBody:
    """Every point of `body` moves along a line of the body `of`, if it moves at all."""

    body: str
    of: str
    line: Line


@dataclass(frozen=True)
class EqualRotation(Reason):
    """`body` does not turn relative to the body `of`; `is_sole` where the joint states nothing
    else.
    """

    body: str
    of: str
    is_sole: bool
    keeps_parallel = True

    def describe(self, element: Message) -> Message:
        """That the two rotations are equal."""
        return Message("mechanics.equal-rotation", body=self.body, of=self.of)

    @property
    def is_given(self) -> bool:
        """Where it is all that the joint states."""
        return self.is_sole

    def list_factors(self, shares: Shares) -> Turning:
        """The angular velocity of the one minus that of the other."""
        return _relate((self.body, 1), (self.of, -1))


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
        return ((self.rate, 1), *_relate((self.body, slip), (self.of, -carried)))

    def find_rolling(self) -> NoSlip | None:
        """Itself."""
        return self

    def list_arms(self, shares: Shares) -> tuple[Arm, ...]:
        """That of the rolling circle's centre about the centre of a circular track."""
        if not isinstance(self.on, Circle):
            return ()
        return (_measure_arm(self.circle, self.on, self.inside, shares),)


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

    def find_rims(self) -> EqualRimSpeed:
        """Itself."""
        return self

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
        return _relate(
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
        return (_measure_arm(self.circle, self.on, self.inside, shares),)


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


class _Imposed(Reason):
    """What a driver imposes."""

    def describe(self, element: Message) -> Message:
        """The driver's own name."""
        return element

    @property
    def is_given(self) -> bool:
        """Yes."""
        return True


@dataclass(frozen=True)
class ImposedRotation(_Imposed):
    """The rotation of `body` relative to the body `of`. `driver` numbers the drivers."""

    driver: int
    body: str
    of: str

    def list_factors(self, shares: Shares) -> Turning:
        """The angular velocity of the one minus that of the other."""
        return _relate((self.body, 1), (self.of, -1 * shares.carried))


@dataclass(frozen=True)
class ImposedMotion(_Imposed):
    """The motion of `point` along a direction, relative to a body. `driver` numbers the drivers."""

    driver: int
    point: str
    of: str
    direction: Vector

    def find_imposed_direction(self) -> Vector | None:
        """That of the point's motion."""
        return self.direction

    def list_factors(self, shares: Shares) -> Turning:
        """None: it is a component of a vector."""
        return ()


@dataclass(frozen=True)
class ImposedCircling(_Imposed):
    """The motion of `point` about the fixed point `centre`. `driver` numbers the drivers."""

    driver: int
    point: str
    centre: str

    def find_imposed_circle(self) -> tuple[str, str] | None:
        """The point and the centre."""
        return self.point, self.centre

    def list_factors(self, shares: Shares) -> Turning:
        """None: it is a component of a vector."""
        return ()


Condition = SharedPoint | GuidedPoint | GuidedBody | EqualRotation
Imposed = ImposedRotation | ImposedMotion | ImposedCircling
Law = (
    SharedPoint | GuidedPoint | EqualRotation | NoSlip | EqualPitchSpeed | EqualBeltSpeed | Imposed
)


def _measure_arm(circle: Circle, on: Circle, inside: bool, shares: Shares) -> Arm:
    """The distance of the centres of two circles that touch: the share of r1 in r1 + r2."""
    radius = -circle.radius if inside else circle.radius
    share = (on.radius + shares.arm * radius) / (on.radius + radius)
    return circle.centre, on.centre, share


def _relate(*factors: tuple[str, Number]) -> Turning:
    """The factors of the bodies' turning rates, added up for each; the ground does not turn."""
    rates: dict[Rate, Number] = {}
    for body, factor in factors:
        if body != GROUND:
            rate = make_turning(body)
            rates[rate] = rates[rate] + factor if rate in rates else factor
    return tuple(rates.items())
