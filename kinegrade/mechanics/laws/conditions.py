"""The conditions that joints state: shared points, guided points and bodies, equal rotations."""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws.reason import Reason
from kinegrade.mechanics.laws.turning import Turning, add_up
from kinegrade.mechanics.shapes import Line, Shape
from kinegrade.mechanics.shares import Shares


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
        return add_up((self.body, 1), (self.of, -1))
