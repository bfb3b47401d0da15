"""Whether the bodies fit together: every joint's condition on the positions at the instant."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from kinegrade.errors import MechanismError, did_you_mean
from kinegrade.mechanics.drivers import Circulation, Driver, Rotation
from kinegrade.mechanics.frames import describe
from kinegrade.mechanics.geometry import short, size
from kinegrade.mechanics.joints import (
    GROUND,
    Arc,
    Circle,
    Contact,
    Joint,
    Line,
    Mesh,
    Parallel,
    Pin,
    Roll,
    Sleeve,
    Slide,
)
from kinegrade.mechanics.mechanism import Mechanism


def require_assembled(mechanism: Mechanism, arithmetic: Any) -> None:
    """Raises MechanismError with every joint that names unknown things or does not fit the positions."""
    problems = list(unknown_names(mechanism)) or list(nonsense(mechanism))
    problems = problems or [
        problem for joint in mechanism.joints for problem in misfits(mechanism, joint, arithmetic)
    ]
    if problems:
        raise MechanismError(*problems)


def unknown_names(mechanism: Mechanism) -> Iterator[str]:
    """Joints and drivers that name a body or point which is not there, and bodies without points."""
    bodies = {body.name for body in mechanism.bodies} | {GROUND}
    for body in mechanism.bodies:
        if not body.points:
            yield f"body {body.name} has no point: name at least one"
        for point in body.points:
            if point not in mechanism.points:
                yield f'body {body.name}: no point "{point}": {did_you_mean(point, mechanism.points)}'
    for part in (*mechanism.joints, *mechanism.drivers):
        for name in body_names(part):
            if name not in bodies:
                yield f'{describe(part)}: no body "{name}": {did_you_mean(name, bodies)}'
        for point in point_names(part):
            if point not in mechanism.points:
                yield f'{describe(part)}: no point "{point}": {did_you_mean(point, mechanism.points)}'


def point_names(part: Joint | Driver) -> list[str]:
    """The points that a joint or driver names."""
    named = [getattr(part, field) for field in ("point", "centre") if hasattr(part, field)]
    return [*named, *(circle.centre for circle in circles(part))]


def body_names(part: Joint | Driver) -> list[str]:
    """The bodies that a joint or driver names."""
    if isinstance(part, Pin):
        return list(part.bodies)
    return [getattr(part, field) for field in ("body", "of", "carrier") if hasattr(part, field)]


def nonsense(mechanism: Mechanism) -> Iterator[str]:
    """Joints and drivers that say nothing: of a body with itself, of a particle's rotation."""
    particles = {body.name for body in mechanism.bodies if body.particle}
    for part in (*mechanism.joints, *mechanism.drivers):
        names = body_names(part)
        if not isinstance(part, Circulation) and len(set(names[:2])) < 2:
            yield f"{describe(part)}: a body cannot move relative to itself: name two bodies"
        if isinstance(part, Sleeve) and part.body == GROUND:
            yield f"{describe(part)}: the ground does not slide: name the moving body first"
        turning = names if isinstance(part, (Rotation, Parallel, Sleeve, Roll, Mesh)) else names[1:]
        if not isinstance(part, Pin):
            yield from (
                f"{describe(part)}: {name} is a particle, which neither turns nor carries a line or circle: "
                "give it two points"
                for name in turning
                if name in particles
            )


def circles(part: Any) -> list[Circle]:
    """The circles that a joint speaks of."""
    found = [getattr(part, field, None) for field in ("circle", "on")]
    return [circle for circle in found if isinstance(circle, Circle)]


def misfits(mechanism: Mechanism, joint: Any, arithmetic: Any) -> Iterator[str]:
    """What is wrong with the positions at one joint."""
    for circle in circles(joint):
        if not bool(arithmetic.is_zero(circle.radius)) and arithmetic.sign(circle.radius) > 0:
            continue
        yield f"{describe(joint)}: a circle of radius {short(circle.radius)}: the radius must be positive"
    for line in (getattr(joint, field, None) for field in ("line", "on")):
        if isinstance(line, Line) and arithmetic.is_zero(line.direction.squared()):
            yield f"{describe(joint)}: the line has no direction: give it two different points, or an angle"
            return
    if isinstance(joint, Slide) and off_line(mechanism, joint.point, joint.line, arithmetic):
        yield f"{describe(joint)}: {joint.point} does not lie on that line: check the construction of {joint.point}"
    if isinstance(joint, Arc):
        yield from wrong_distance(
            mechanism, joint, (joint.point, joint.circle.centre), joint.circle.radius, arithmetic
        )
    if isinstance(joint, (Contact, Roll, Mesh)):
        yield from apart(mechanism, joint, arithmetic)


def off_line(mechanism: Mechanism, point: str, line: Line, arithmetic: Any) -> bool:
    """Whether a point does not lie on a line."""
    return not arithmetic.is_zero(line.direction.cross(mechanism.points[point] - line.point))


def apart(mechanism: Mechanism, joint: Contact | Roll | Mesh, arithmetic: Any) -> Iterator[str]:
    """Two profiles that do not touch."""
    own, centre = joint.circle.radius, joint.circle.centre
    if isinstance(joint.on, Circle):
        if joint.inside and arithmetic.is_zero(joint.on.radius - own):
            yield f"{describe(joint)}: a circle within a circle of the same radius: one must be smaller"
            return
        expected = joint.on.radius - own if joint.inside else joint.on.radius + own
        yield from wrong_distance(mechanism, joint, (centre, joint.on.centre), expected, arithmetic)
        return
    across = joint.on.direction.cross(mechanism.points[centre] - joint.on.point)
    if not arithmetic.is_zero(across * across - own * own * joint.on.direction.squared()):
        yield (
            f"{describe(joint)}: the circle about {centre} of radius {short(own)} does not touch the line: "
            "its centre must be a radius away"
        )


def wrong_distance(
    mechanism: Mechanism, joint: Any, ends: tuple[str, str], expected: Any, arithmetic: Any
) -> Iterator[str]:
    """Two points whose distance is not what the joint needs."""
    first, second = ends
    square = (mechanism.points[first] - mechanism.points[second]).squared()
    if not arithmetic.is_zero(square - expected * expected):
        yield (
            f"{describe(joint)}: {first} and {second} are {short(size(square) ** 0.5)} apart: "
            f"{short(abs(expected))} is needed"
        )
