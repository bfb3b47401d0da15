"""What the arguments of a quantity name: points arrive as the mechanism's own vectors, bodies by
name.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from kinegrade.errors import ExpressionError
from kinegrade.language.message import Message, Quoted, list_all
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic


@dataclass(frozen=True)
class BodyName:
    """A body as it is named in a quantity."""

    name: str


def find_body_names(mechanism: Mechanism) -> dict[str, Any]:
    """The names of the bodies that are not also names of points."""
    names = [GROUND, *(body.name for body in mechanism.bodies)]
    return {name: BodyName(name) for name in names if name not in mechanism.points}


@dataclass(frozen=True)
class MotionReader:
    """A motion, and the arithmetic in which quantities are read off it."""

    motion: Motion
    arithmetic: Arithmetic

    def point(self, place: Vector) -> str:
        """The name of a point."""
        for name, point in self.motion.points.items():
            if point is place:
                return name
        raise ExpressionError(Message("template.point-name-here"))

    def body(self, body: Any) -> str:
        """The name of a body; a particle may be named by its point, whose name it shares."""
        if isinstance(body, BodyName):
            return body.name
        name = self.point(body)
        if any(other.name == name for other in self.motion.frames.mechanism.bodies):
            return name
        raise ExpressionError(Message("template.body-name-here", point=Quoted(name)))

    def owner(self, point: str, body: Any) -> str:
        """The body whose point is meant: the one named, or the one that needs no naming."""
        if body is not None:
            return self.body(body)
        mechanism = self.motion.frames.mechanism
        owners = [other.name for other in mechanism.bodies if point in other.points]
        shared = mechanism.shared_points
        pins = [pin.bodies for pin in shared if pin.point == point]
        if not owners:
            body = mechanism.bodies[0].name
            raise ExpressionError(Message("template.point-of-no-body", point=point, body=body))
        if len(owners) > 1 and not any(set(owners) <= set(bodies) for bodies in pins):
            raise ExpressionError(
                Message(
                    "template.point-of-several",
                    point=point,
                    bodies=list_all(owners),
                    body=owners[0],
                )
            )
        return owners[0]
