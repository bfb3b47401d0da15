"""A mechanism at one instant: bodies, where their points are, how they are joined, and what drives
them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from kinegrade.mechanics.drivers import Driver
from kinegrade.mechanics.joints import Joint
from kinegrade.mechanics.vector import Vector


@dataclass(frozen=True)
class Body:
    """A moving rigid body and the names of its marked points; a `particle` has one point and no
    rotation.
    """

    name: str
    points: tuple[str, ...]
    particle: bool = False


@dataclass(frozen=True)
class Mechanism:
    """Positions in metres in the common frame (x right, y up), all in one arithmetic."""

    points: Mapping[str, Vector]
    bodies: tuple[Body, ...]
    joints: tuple[Joint, ...]
    drivers: tuple[Driver, ...]

    def body(self, name: str) -> Body:
        """The moving body of that name."""
        return next(body for body in self.bodies if body.name == name)
