"""Whether the bodies fit together: the condition of each joint on the positions at the instant."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, assert_never

from kinegrade.errors import MechanismError, Problem, suggest
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.mechanics.drivers import Circulation, Component, Driver, Rotation
from kinegrade.mechanics.frames import name_element
from kinegrade.mechanics.geometry import round_short, size
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
    """Raises MechanismError listing every joint that names unknown things or does not fit the
    positions.
    """
    problems = list(_find_unknown_names(mechanism)) or list(_find_nonsense(mechanism))
    problems = problems or [
        problem
        for joint in mechanism.joints
        for problem in _find_misfits(mechanism, joint, arithmetic)
    ]
    if problems:
        raise MechanismError(*problems)


def _find_unknown_names(mechanism: Mechanism) -> Iterator[Problem]:
    """Joints and drivers that name a body or point that does not exist, and bodies without
    points.
    """
    bodies = {body.name for body in mechanism.bodies} | {GROUND}
    for body in mechanism.bodies:
        if not body.points:
            yield Message("mechanics.no-points", body=body.name)
        for point in body.points:
            if point not in mechanism.points:
                where = Message("mechanics.body", name=body.name)
                yield Fault(where, _name_unknown_point(point, mechanism))
    for part in (*mechanism.joints, *mechanism.drivers):
        for name in _list_bodies(part):
            if name not in bodies:
                hint = suggest(name, bodies)
                unknown = Message("mechanics.unknown-body", name=Quoted(name), hint=hint)
                yield Fault(name_element(part), unknown)
        for point in _list_points(part):
            if point not in mechanism.points:
                yield Fault(name_element(part), _name_unknown_point(point, mechanism))


def _name_unknown_point(point: str, mechanism: Mechanism) -> Message:
    hint = suggest(point, mechanism.points)
    return Message("mechanics.unknown-point", name=Quoted(point), hint=hint)


def _list_bodies(part: Joint | Driver) -> list[str]:
    """The bodies that a joint or driver names."""
    match part:
        case Pin(bodies=bodies):
            return list(bodies)
        case Mesh(body=body, of=of, carrier=carrier):
            return [body, of, carrier]
        case (
            Slide() | Sleeve() | Arc() | Contact() | Roll() | Parallel() | Rotation() | Component()
        ):
            return [part.body, part.of]
        case Circulation(body=body):
            return [body]
        case _:
            assert_never(part)


def _list_turning_bodies(part: Joint | Driver) -> list[str]:
    """The bodies of a joint or driver that turn in it or carry its line or circle, which no
    particle can.
    """
    match part:
        case Pin():
            return []
        case Rotation() | Parallel() | Sleeve() | Roll() | Mesh():
            return _list_bodies(part)
        case Slide() | Arc() | Contact() | Component() | Circulation():
            return _list_bodies(part)[1:]
        case _:
            assert_never(part)


def _find_nonsense(mechanism: Mechanism) -> Iterator[Problem]:
    """Joints and drivers that are meaningless: of a body with itself, or of a particle's
    rotation.
    """
    particles = {body.name for body in mechanism.bodies if body.particle}
    for part in (*mechanism.joints, *mechanism.drivers):
        names = _list_bodies(part)
        if not isinstance(part, Circulation) and len(set(names[:2])) < 2:
            yield Fault(name_element(part), Message("mechanics.relative-to-itself"))
        if isinstance(part, Sleeve) and part.body == GROUND:
            yield Fault(name_element(part), Message("mechanics.sliding-ground"))
        yield from (
            Fault(name_element(part), Message("mechanics.particle", body=name))
            for name in _list_turning_bodies(part)
            if name in particles
        )


def _list_points(part: Joint | Driver) -> list[str]:
    """The points that a joint or driver names."""
    match part:
        case Pin(point=point) | Slide(point=point) | Component(point=point):
            return [point]
        case Arc(point=point, circle=Circle(centre=centre)):
            return [point, centre]
        case Circulation(point=point, centre=centre):
            return [point, centre]
        case Contact() | Roll() | Mesh():
            return [circle.centre for circle in list_circles(part)]
        case Sleeve() | Parallel() | Rotation():
            return []
        case _:
            assert_never(part)


def _list_shapes(joint: Joint) -> list[Line | Circle]:
    """The shapes that a joint refers to."""
    match joint:
        case Pin() | Parallel():
            return []
        case Slide(line=line) | Sleeve(line=line):
            return [line]
        case Arc(circle=circle):
            return [circle]
        case (
            Contact(circle=circle, on=on) | Roll(circle=circle, on=on) | Mesh(circle=circle, on=on)
        ):
            return [circle, on]
        case _:
            assert_never(joint)


def list_circles(joint: Joint) -> list[Circle]:
    """The circles that a joint refers to."""
    return [shape for shape in _list_shapes(joint) if isinstance(shape, Circle)]


def _find_misfits(mechanism: Mechanism, joint: Joint, arithmetic: Any) -> Iterator[Problem]:
    """What is wrong with the positions at one joint."""
    for circle in list_circles(joint):
        if not bool(arithmetic.is_zero(circle.radius)) and arithmetic.sign(circle.radius) > 0:
            continue
        wrong = Message("mechanics.radius", radius=round_short(circle.radius))
        yield Fault(name_element(joint), wrong)
    for line in _list_shapes(joint):
        if isinstance(line, Line) and arithmetic.is_zero(line.direction.squared()):
            yield Fault(name_element(joint), Message("mechanics.no-direction"))
            return
    match joint:
        case Slide(point=point):
            if _is_off_line(mechanism, point, joint.line, arithmetic):
                yield Fault(name_element(joint), Message("mechanics.off-line", point=point))
        case Arc(circle=circle):
            ends = (joint.point, circle.centre)
            yield from _find_wrong_distances(mechanism, joint, ends, circle.radius, arithmetic)
        case Contact() | Roll() | Mesh():
            yield from _find_separated(mechanism, joint, arithmetic)
        case Pin() | Sleeve() | Parallel():
            pass  # they say nothing about where their bodies are
        case _:
            assert_never(joint)


def _is_off_line(mechanism: Mechanism, point: str, line: Line, arithmetic: Any) -> bool:
    """Whether a point does not lie on a line."""
    return not arithmetic.is_zero(line.direction.cross(mechanism.points[point] - line.point))


def _find_separated(
    mechanism: Mechanism, joint: Contact | Roll | Mesh, arithmetic: Any
) -> Iterator[Problem]:
    """Two profiles that do not touch."""
    radius, centre = joint.circle.radius, joint.circle.centre
    match joint.on:
        case Circle(centre=other, radius=other_radius):
            if joint.inside and arithmetic.is_zero(other_radius - radius):
                yield Fault(name_element(joint), Message("mechanics.same-radius"))
                return
            expected = other_radius - radius if joint.inside else other_radius + radius
            yield from _find_wrong_distances(
                mechanism, joint, (centre, other), expected, arithmetic
            )
        case Line(point=point, direction=direction):
            across = direction.cross(mechanism.points[centre] - point)
            if not arithmetic.is_zero(across * across - radius * radius * direction.squared()):
                apart = Message(
                    "mechanics.apart-from-line", centre=centre, radius=round_short(radius)
                )
                yield Fault(name_element(joint), apart)
        case _:
            assert_never(joint.on)


def _find_wrong_distances(
    mechanism: Mechanism, joint: Joint, ends: tuple[str, str], expected: Any, arithmetic: Any
) -> Iterator[Problem]:
    """Two points whose distance is not the one that the joint needs."""
    first, second = ends
    square = (mechanism.points[first] - mechanism.points[second]).squared()
    if not arithmetic.is_zero(square - expected * expected):
        apart = Message(
            "mechanics.wrong-distance",
            first=first,
            second=second,
            distance=round_short(size(square) ** 0.5),
            needed=round_short(abs(expected)),
        )
        yield Fault(name_element(joint), apart)
