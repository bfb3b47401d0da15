"""A mechanism at one instant: bodies, where their points are, how they are joined, and what drives
them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, fields, is_dataclass, replace
from functools import cached_property
from typing import Any, assert_never

from kinegrade.mechanics.drivers import Driver
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.joints import Joint
from kinegrade.mechanics.laws import Condition, EqualRotation, GuidedBody, GuidedPoint, SharedPoint
from kinegrade.mechanics.shapes import Line
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Number


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

    def list_conditions(self) -> Iterator[Condition]:
        """What the joints hold, guide and keep parallel, in their order."""
        return (condition for joint in self.joints for condition in joint.conditions)

    @cached_property
    def shared_points(self) -> tuple[SharedPoint, ...]:
        """The points at which bodies are pinned together."""
        return select_shared(self.list_conditions())

    def holds(self, needed: SharedPoint) -> bool:
        """Whether pins at that point join all those bodies, some perhaps by way of others."""
        joined, found = set(needed.bodies[:1]), 0
        while len(joined) > found:
            found = len(joined)
            for shared in self.shared_points:
                if shared.point == needed.point and not joined.isdisjoint(shared.bodies):
                    joined.update(shared.bodies)
        return joined.issuperset(needed.bodies)

    def find_pivots(self) -> dict[str, str]:
        """The fixed point of each body that is pinned to the ground."""
        return {
            body: shared.point
            for shared in reversed(self.shared_points)
            if GROUND in shared.bodies
            for body in shared.bodies
            if body != GROUND
        }

    def find_guides(self, body: str) -> Iterator[tuple[str, Line]]:
        """The points of a body that are on fixed straight lines, with these."""
        for law in self.list_conditions():
            match law:
                case GuidedPoint(point=point, body=owner, of=of, track=Line() as track):
                    if (owner, of) == (body, GROUND):
                        yield point, track
                case GuidedPoint() | GuidedBody() | SharedPoint() | EqualRotation():
                    continue
                case _:
                    assert_never(law)

    def find_sleeves(self, body: str) -> Iterator[tuple[str, Line]]:
        """The bodies along whose lines a body slides, with these."""
        for law in self.list_conditions():
            if isinstance(law, GuidedBody) and law.body == body:
                yield law.of, law.line

    def find_translating(self) -> set[str]:
        """The bodies that cannot rotate: kept parallel to the ground, or to a body that is."""
        held = {GROUND}
        for _ in self.bodies:
            for law in self.list_conditions():
                if isinstance(law, EqualRotation) and held & {law.body, law.of}:
                    held |= {law.body, law.of}
        return held - {GROUND}

    @cached_property
    def held_parallel(self) -> frozenset[str]:
        """The bodies that a joint does nothing else with but keep them from turning."""
        return frozenset(
            condition.body
            for condition in self.list_conditions()
            if isinstance(condition, EqualRotation) and condition.is_sole and condition.of == GROUND
        )

    @cached_property
    def resting(self) -> frozenset[str]:
        """The bodies that are pinned to the ground and kept from turning, as a fixed rope is."""
        return self.held_parallel & self.find_pivots().keys()

    def join_resting_to_ground(self) -> Mechanism:
        """The same, but that what rolls or slides on a body at rest does so on the ground."""
        joints = tuple(_join_to_ground(joint, self.resting) for joint in self.joints)
        return replace(self, joints=joints) if self.resting else self

    def map(self, number: Callable[[Number], Number]) -> Mechanism:
        """The mechanism with `number` applied to every number of its points, joints and
        drivers.
        """
        return Mechanism(
            {name: point.map(number) for name, point in self.points.items()},
            self.bodies,
            tuple(_map_part(joint, number) for joint in self.joints),
            tuple(_map_part(driver, number) for driver in self.drivers),
        )


def _join_to_ground(joint: Any, resting: frozenset[str]) -> Any:
    """A joint that guides something on a body at rest does so on the ground; others stay."""
    guides = any(isinstance(law, GuidedPoint | GuidedBody) for law in joint.conditions)
    return replace(joint, of=GROUND) if guides and joint.of in resting else joint


def _map_part(part: Any, number: Callable[[Number], Number]) -> Any:
    """A joint, a driver, or a part of one: a vector, a line or a circle; names stay as they are."""
    match part:
        case Vector():
            return part.map(number)
        case str() | bool() | tuple():
            return part
        case _ if is_dataclass(part) and not isinstance(part, type):
            parts = {each.name: getattr(part, each.name) for each in fields(part)}
            return replace(part, **{name: _map_part(each, number) for name, each in parts.items()})
        case _:
            return number(part)


def select_shared(conditions: Iterable[Condition]) -> tuple[SharedPoint, ...]:
    """The shared points among some conditions."""
    return tuple(condition for condition in conditions if isinstance(condition, SharedPoint))
