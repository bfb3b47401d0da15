"""A mechanism where it has gone to: its points, its lines, and the relations of its rates there."""

from __future__ import annotations

from dataclasses import fields, replace
from typing import Any, assert_never

from kinegrade.mechanics.bases import Base
from kinegrade.mechanics.frames import Frames
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.joints import Joint
from kinegrade.mechanics.laws import EqualRotation, GuidedBody, GuidedPoint, SharedPoint
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.shapes import Line
from kinegrade.mechanics.vector import Vector
from kinegrade.motion.displacement import Displacement


def place_frames(frames: Frames, relations: tuple[Relation, ...], at: Displacement) -> Frames:
    """The frames of the instant at a displacement, where its relations are those given."""
    bases = {
        name: Base(base.point, at.move_chain(base.chain).chain, base.joint)
        for name, base in frames.bases.items()
    }
    return Frames(place_mechanism(frames, at), bases, relations, frames.guiding)


def place_mechanism(frames: Frames, at: Displacement) -> Mechanism:
    """The mechanism of frames of the instant at a displacement: its points, and the lines of its
    joints.
    """
    return Placing(frames, at).place_mechanism()


class Placing:
    """Where the points and lines of each body are."""

    def __init__(self, frames: Frames, at: Displacement) -> None:
        self.mechanism, self.bases, self.at = frames.mechanism, frames.bases, at
        self.shifts = {name: at.move_chain(base.chain).shift for name, base in frames.bases.items()}

    def place(self, body: str, point: Vector) -> Vector:
        """Where a place of a body, given by where it is at the instant, is now."""
        if body == GROUND:
            return point
        start = self.mechanism.points[self.bases[body].point]
        return start + self.shifts[body] + self.at.carry(body, point - start)

    def place_mechanism(self) -> Mechanism:
        """The mechanism with its points and the lines of its joints."""
        carriers = find_carriers(self.mechanism)
        points = {
            name: self.place(carriers.get(name, GROUND), point)
            for name, point in self.mechanism.points.items()
        }
        joints = tuple(self._place_joint(joint) for joint in self.mechanism.joints)
        return replace(self.mechanism, points=points, joints=joints)

    def _place_joint(self, joint: Joint) -> Joint:
        """A joint with its lines where the bodies that carry these have gone."""
        body = _find_line_carrier(joint)
        parts = {each.name: getattr(joint, each.name) for each in fields(joint)}
        lines: dict[str, Any] = {
            name: Line(self.place(body, line.point), self.at.carry(body, line.direction))
            for name, line in parts.items()
            if isinstance(line, Line)
        }
        return replace(joint, **lines) if lines else joint


def find_carriers(mechanism: Mechanism) -> dict[str, str]:
    """The body with which each point goes: the ground where it is pinned to that, else the body
    that is pinned, guided or lists it; fixed points of no body are left out.
    """
    carriers: dict[str, str] = {}
    for shared in mechanism.shared_points:
        if carriers.get(shared.point) != GROUND:
            carriers[shared.point] = GROUND if GROUND in shared.bodies else shared.bodies[0]
    for condition in mechanism.list_conditions():
        match condition:
            case GuidedPoint(point=point, body=body):
                carriers.setdefault(point, body)
            case SharedPoint() | GuidedBody() | EqualRotation():
                pass  # no further point
            case _:
                assert_never(condition)
    for each in mechanism.bodies:
        for point in each.points:
            carriers.setdefault(point, each.name)
    return carriers


def _find_line_carrier(joint: Joint) -> str:
    """The body that carries the lines of a joint."""
    for condition in joint.conditions:
        match condition:
            case GuidedPoint(of=of) | GuidedBody(of=of):
                return of
            case SharedPoint() | EqualRotation():
                pass  # it has no line
            case _:
                assert_never(condition)
    return GROUND
