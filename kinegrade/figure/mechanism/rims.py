"""The circles of a mechanism: wheels, gears, tracks, discs, slotted rings, each derived from the
joints.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Literal, assert_never

from kinegrade.figure.plane import foot, length, unit
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
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Rimmed

Kind = Literal["wheel", "gear", "slot", "cam", "edge"]


@dataclass(frozen=True)
class Rim:
    """A circle of a body; `ring` when the material lies outside; `find_touching_point` is the
    contact point.

    The kind "edge" is drawn as a line only: a circle that belongs to no joint.
    """

    body: str
    centre: str
    at: Vector
    radius: float
    kind: Kind
    ring: bool
    touch: Vector


def find_rims(
    mechanism: Mechanism, shapes: Mapping[str, str], circles: Iterable[Rimmed] = ()
) -> tuple[Rim, ...]:
    """Every circle once; a shape "gear" or "cam" of its body or partner decides the kind; circles
    from hints come last.
    """
    found: dict[tuple[str, str, float], Rim] = {}
    for joint in mechanism.joints:
        for rim in _find_joint_rims(mechanism, joint, shapes):
            found.setdefault((rim.body, rim.centre, round(rim.radius, 6)), rim)
    for circle in circles:
        at, touched = mechanism.points[circle.centre], mechanism.points[circle.through]
        rim = Rim(circle.body, circle.centre, at, length(touched - at), "edge", False, touched)
        found.setdefault((rim.body, rim.centre, round(rim.radius, 6)), rim)
    return tuple(found.values())


def _find_joint_rims(
    mechanism: Mechanism, joint: Joint, shapes: Mapping[str, str]
) -> Iterator[Rim]:
    match joint:
        case Contact() | Roll() | Mesh():
            yield from _find_pair_rims(mechanism, joint, shapes)
        case Arc():
            yield _find_arc_rim(mechanism, joint)
        case Pin() | Slide() | Sleeve() | Parallel():
            pass  # nothing round
        case _:
            assert_never(joint)


def find_touching_point(mechanism: Mechanism, joint: Contact | Roll | Mesh) -> Vector:
    """Where the two profiles of a joint touch."""
    centre, radius = mechanism.points[joint.circle.centre], float(joint.circle.radius)
    match joint.on:
        case Line():
            return foot(centre, joint.on)
        case Circle(centre=name, radius=size):
            other, other_radius = mechanism.points[name], float(size)
            if not joint.inside:
                return centre + unit(other - centre) * radius
            if radius < other_radius:
                return centre + unit(centre - other) * radius
            return other + unit(other - centre) * other_radius
        case _:
            assert_never(joint.on)


def is_toothed(joint: Contact | Roll | Mesh, shapes: Mapping[str, str]) -> bool:
    """Whether the joint connects two gears, or a gear and a rack."""
    return isinstance(joint, Mesh) or "gear" in (shapes.get(joint.body), shapes.get(joint.of))


def _find_pair_rims(
    mechanism: Mechanism, joint: Contact | Roll | Mesh, shapes: Mapping[str, str]
) -> Iterator[Rim]:
    at = find_touching_point(mechanism, joint)
    geared = is_toothed(joint, shapes)
    circles = [(joint.body, joint.circle)]
    if isinstance(joint.on, Circle):
        circles.append((joint.of, joint.on))
    outer = max(circle.radius for _, circle in circles)
    for body, circle in circles:
        kind: Kind = "gear" if geared else "cam" if shapes.get(body) == "cam" else "wheel"
        ring = joint.inside and circle.radius == outer
        yield Rim(
            body, circle.centre, mechanism.points[circle.centre], circle.radius, kind, ring, at
        )


def _find_arc_rim(mechanism: Mechanism, joint: Arc) -> Rim:
    """A particle runs in a ring-shaped slot; the point of any other body runs on a disc."""
    particle = any(body.name == joint.body and body.particle for body in mechanism.bodies)
    kind: Kind = "slot" if particle else "wheel"
    centre = mechanism.points[joint.circle.centre]
    return Rim(
        joint.of,
        joint.circle.centre,
        centre,
        joint.circle.radius,
        kind,
        False,
        mechanism.points[joint.point],
    )


def order_rims(found: tuple[Rim, ...]) -> tuple[Rim, ...]:
    """Rims from the largest to the smallest, so that none hides another; those of the ground
    first.
    """
    return tuple(sorted(found, key=lambda rim: (rim.body != GROUND, -rim.radius)))


def enlarge(rim: Rim, by: float) -> Rim:
    """The concentric rim whose radius is larger by that much."""
    return replace(rim, radius=rim.radius + by)
