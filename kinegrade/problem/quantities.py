"""What an ask's `quantity` may say: velocities, accelerations, their relative parts, poles, lengths
and angles.

    magnitude(velocity(B))                     speed of B
    x(acceleration(B))                         component
    along(relative_velocity(A, AB, OC), A - O) A of AB seen from OC, positive from O towards A
    omega(AB), alpha(AB), omega(II, OA)        absolute, and relative to another body
    normal_acceleration(A, O, I)               part of A relative to O, both on body I, towards O
    angle(velocity(A), velocity(B))            from the first to the second, counter-clockwise

A point's body is named where the point belongs to several that are not pinned there: `velocity(A,
cam)`.
"""

from __future__ import annotations

from collections.abc import Callable
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


def make_quantities(motion: Motion, arithmetic: Arithmetic) -> dict[str, Callable[..., Any]]:
    """The functions of a motion by name."""
    ask = Quantities(motion, arithmetic)
    return {
        "velocity": ask.velocity,
        "acceleration": ask.acceleration,
        "omega": ask.omega,
        "alpha": ask.alpha,
        "relative_velocity": ask.relative_velocity,
        "relative_acceleration": ask.relative_acceleration,
        "coriolis": ask.coriolis,
        "normal_acceleration": ask.normal,
        "tangential_acceleration": ask.tangential,
        "pole": ask.pole,
        "magnitude": ask.magnitude,
        "along": ask.along,
        "angle": ask.angle,
        "between": ask.between,
    }


@dataclass(frozen=True)
class Quantities:
    """Reads quantities off a motion; points arrive as the mechanism's own vectors, bodies by
    name.
    """

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

    def velocity(self, place: Vector, body: Any = None) -> Vector:
        """Velocity of a point."""
        point = self.point(place)
        return self.motion.velocity(point, self.owner(point, body))

    def acceleration(self, place: Vector, body: Any = None) -> Vector:
        """Acceleration of a point."""
        point = self.point(place)
        return self.motion.acceleration(point, self.owner(point, body))

    def omega(self, body: Any, of: Any = None) -> Any:
        """Angular velocity, absolute or relative to a second body."""
        return self.motion.omega(self.body(body), GROUND if of is None else self.body(of))

    def alpha(self, body: Any, of: Any = None) -> Any:
        """Angular acceleration, absolute or relative to a second body."""
        return self.motion.alpha(self.body(body), GROUND if of is None else self.body(of))

    def relative_velocity(self, place: Vector, body: Any, frame: Any) -> Vector:
        """Velocity of a body's point seen from a moving body."""
        return self.motion.relative_velocity(self.point(place), self.body(body), self.body(frame))

    def relative_acceleration(self, place: Vector, body: Any, frame: Any) -> Vector:
        """Acceleration of a body's point seen from a moving body."""
        return self.motion.relative_acceleration(
            self.point(place), self.body(body), self.body(frame)
        )

    def coriolis(self, place: Vector, body: Any, frame: Any) -> Vector:
        """Coriolis acceleration of a body's point, moving frame on the second body."""
        return self.motion.coriolis(self.point(place), self.body(body), self.body(frame))

    def normal(self, place: Vector, base: Vector, body: Any) -> Vector:
        """Centripetal part of the acceleration of a point relative to a base point of the same
        body.
        """
        rate = self.motion.omega(self.body(body))
        acceleration: Vector = (base - place) * (rate * rate)
        return acceleration

    def tangential(self, place: Vector, base: Vector, body: Any) -> Vector:
        """Tangential part of the acceleration of a point relative to a base point of the same
        body.
        """
        acceleration: Vector = (place - base).turned() * self.motion.alpha(self.body(body))
        return acceleration

    def pole(self, body: Any) -> Vector:
        """Velocity pole of a body."""
        return self.motion.pole(self.body(body), self.arithmetic)

    def magnitude(self, vector: Vector) -> Any:
        """Length of a vector."""
        return self.arithmetic.magnitude(vector.x, vector.y)

    def along(self, vector: Vector, direction: Vector) -> Any:
        """Component along a direction given by any vector."""
        return vector.dot(direction) / self.magnitude(direction)

    def angle(self, first: Vector, second: Vector) -> Any:
        """Angle from the first vector to the second, counter-clockwise, in (-pi, pi]."""
        return self.arithmetic.arctangent(first.cross(second), first.dot(second))

    def between(self, first: Vector, second: Vector) -> Any:
        """Angle between two vectors, 0 to pi."""
        return self.arithmetic.arctangent(abs(first.cross(second)), first.dot(second))
