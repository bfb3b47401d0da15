"""What drivers impose."""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.language.message import Message
from kinegrade.mechanics.laws.reason import Reason
from kinegrade.mechanics.laws.turning import Turning, add_up
from kinegrade.mechanics.shares import Shares
from kinegrade.mechanics.vector import AxisName, Vector


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
        return add_up((self.body, 1), (self.of, -1 * shares.carried))


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
class ImposedComponent(_Imposed):
    """The component along an axis of the motion of `point`, which nothing guides, as seen from the
    ground. `direction` is that of the axis or the opposite one; `driver` numbers the drivers.
    """

    driver: int
    point: str
    axis: AxisName
    direction: Vector

    def find_imposed_direction(self) -> Vector | None:
        """That in which the component is given."""
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


def find_imposed_rotation(law: Reason | None) -> ImposedRotation | None:
    """The rotation that a law imposes; None where it is something else."""
    return law if isinstance(law, ImposedRotation) else None
