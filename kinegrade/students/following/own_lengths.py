"""What a student's own length says of velocities: the distance of a point from the pole of a body.

By `v = omega r`, a student with another distance has another angular velocity, or another velocity
of the point. A body that turns about a fixed pin has its pole there. A coordinate of a pole moves
the pole: across the other axis, or along the line that joins it with a point of the body.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import copysign, hypot
from typing import assert_never

from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.doubles import Doubles
from kinegrade.students.following.own_values import OwnValue

_REST = 1e-9  # m/s: what is slower stands still
_AT_POLE = 1e-9  # m
_AXES = Vector(1.0, 0.0), Vector(0.0, 1.0)


@dataclass(frozen=True)
class OwnLengths:
    """The right motion, of which a student has another length."""

    motion: Motion

    def list_ways(self, tree: Expression, length: float) -> Iterator[Sequence[OwnValue]]:
        """The student's values that a length in m says, where `tree` is a distance of a point
        from a pole or a fixed pin, or a coordinate of a pole; one sequence for each way.
        """
        match tree:
            case Call("distance", (one, other)):
                for pole, point in ((one, other), (other, one)):
                    yield from self._measure_distance(pole, point, length)
            case Call("x", (Call("pole", (Name(body),)),)):
                yield from self._move_pole(body, _AXES[0], length)
            case Call("y", (Call("pole", (Name(body),)),)):
                yield from self._move_pole(body, _AXES[1], length)
            case Call() | Name() | Number() | Operation():
                return
            case _:
                assert_never(tree)

    def _measure_distance(
        self, pole: Expression, point: Expression, length: float
    ) -> Iterator[Sequence[OwnValue]]:
        """A distance: from the pole of a named body, or of any body that turns about a point."""
        if not isinstance(point, Name):
            return
        match pole:
            case Call("pole", (Name(body),)):
                bodies = [body]
                right = self._find_pole(body)
            case Name(name):
                bodies = self._find_turning_about(name)
                right = self.motion.points[name]
            case Call() | Number() | Operation():
                return
            case _:
                assert_never(pole)
        distance = hypot(*(self.motion.points[point.name] - right))
        for body in bodies if distance > _AT_POLE else ():
            yield from self._scale(body, point.name, length / distance)

    def _move_pole(self, body: str, axis: Vector, length: float) -> Iterator[Sequence[OwnValue]]:
        """A coordinate of the pole along an axis: it moves along its line through the base point of
        the body, or across the other axis.
        """
        pole, base = self._find_pole(body), self.motion.frames.bases[body].point
        shift = length - pole.dot(axis)
        across = (pole - self.motion.points[base]).dot(axis)
        if abs(across) > _AT_POLE:
            yield from self._scale(body, base, 1 + shift / across)
        yield from self._turn_about(body, pole, pole + axis * shift)

    def _turn_about(self, body: str, pole: Vector, moved: Vector) -> Iterator[Sequence[OwnValue]]:
        """The body turns about another point: the velocity of its base point gives the angular
        velocity, and this that of other points.
        """
        base = self.motion.frames.bases[body].point
        share = self._compare(base, pole, moved)
        for point in self.motion.frames.mechanism.body(body).points:
            other = self._compare(point, pole, moved)
            if point == base and share:
                yield [self._own_rotation(body, 1 / share)]
            elif share and other:
                velocity = self._own_velocity(body, point, other / share)
                yield [self._own_rotation(body, 1 / share), velocity]

    def _compare(self, point: str, pole: Vector, moved: Vector) -> float:
        """How many times as far from a point the pole is after moving, negative beyond the point;
        0 where either is at the point.
        """
        before, after = pole - self.motion.points[point], moved - self.motion.points[point]
        if min(hypot(*before), hypot(*after)) <= _AT_POLE:
            return 0.0
        return copysign(hypot(*after) / hypot(*before), before.dot(after))

    def _scale(self, body: str, point: str, share: float) -> Iterator[Sequence[OwnValue]]:
        """A distance from the pole, taken `share` times too long."""
        if abs(share) > _REST:
            yield [self._own_rotation(body, 1 / share)]
            yield [self._own_velocity(body, point, share)]

    def _own_rotation(self, body: str, factor: float) -> OwnValue:
        """The angular velocity of a body, a factor too large."""
        return OwnValue(
            lambda motion: float(motion.omega(body)),
            factor * float(self.motion.omega(body)),
            "velocity",
        )

    def _own_velocity(self, body: str, point: str, factor: float) -> OwnValue:
        """The velocity of a point of a body along its path, a factor too large."""
        right = self.motion.velocity(point, body)
        return OwnValue(
            lambda motion: float(motion.velocity(point, body).dot(right)),
            factor * right.squared(),
            "velocity",
            (body, point),
        )

    def _find_pole(self, body: str) -> Vector:
        """Where the pole of a body is. Raises AtInfinity where it does not turn."""
        return self.motion.pole(body, Doubles())

    def _find_turning_about(self, point: str) -> list[str]:
        """The bodies that turn about a point."""
        return [
            body.name
            for body in self.motion.frames.mechanism.bodies
            if not body.particle
            and self.motion.omega(body.name)
            and hypot(*self.motion.velocity(point, body.name)) < _REST
        ]
