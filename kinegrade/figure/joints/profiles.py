"""What joints with circles look like: wheels on tracks, gears, racks, cams, discs, ring-shaped
slots.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import asin
from typing import assert_never

from msgspec.structs import replace

from kinegrade.figure.joints.ropes import find_rope, is_rope
from kinegrade.figure.joints.symbol import Feature, Foot, Kind, Rim, Symbol, is_particle
from kinegrade.figure.plane import angle_of, foot, length, polar, unit
from kinegrade.mechanics.joints import GROUND, Arc, Circle, Contact, Line, Mesh, Roll
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.shapes import Profile
from kinegrade.mechanics.vector import Vector

# Radians by which the edge of a wheel, seen from the centre of the track about it, lies beyond the
# contact while the usual arc has room for an arrow beside it
_WITHIN_ARC = 0.3


def find_touch_symbol(
    mechanism: Mechanism, joint: Contact | Roll, shapes: Mapping[str, str]
) -> Symbol:
    """A wheel, gear or cam with its partner: another circle, a face or rack of a body, a track."""
    toothed = "gear" in (shapes.get(joint.body), shapes.get(joint.of))
    profile = joint.find_profile()
    kinds = {body: _choose_kind(body, toothed, profile, shapes) for body in (joint.body, joint.of)}
    rims = _find_rims(mechanism, joint, kinds)
    match joint.on:
        case Circle():
            return Symbol(rims=tuple(_limit(rim, rims, shapes) for rim in rims))
        case Line():
            away = unit(rims[0].touch - rims[0].at)
        case _:
            assert_never(joint.on)
    if joint.of == GROUND:
        foot_on_track = Foot(joint.on, rims[0].touch, away, joint.circle.radius, toothed)
        return Symbol(rims=rims, foot=foot_on_track)
    if is_rope(shapes, joint.of):
        return Symbol(
            rims=rims, hanging=find_rope(mechanism, joint.of, joint.on, rims[0].touch, shapes)
        )
    edge = Feature(joint.of, joint.on, rims[0].touch, "rack" if toothed else "face", away)
    return Symbol(rims=rims, features=(edge,))


def find_mesh_symbol(mechanism: Mechanism, joint: Mesh) -> Symbol:
    """Two gears by their pitch circles."""
    return Symbol(rims=_find_rims(mechanism, joint, {joint.body: "gear", joint.of: "gear"}))


def find_arc_symbol(mechanism: Mechanism, joint: Arc) -> Symbol:
    """A particle runs in a ring-shaped slot; the point of any other body runs on a disc."""
    particle = is_particle(mechanism, joint.body)
    rim = Rim(
        joint.of,
        joint.circle.centre,
        mechanism.points[joint.circle.centre],
        joint.circle.radius,
        "slot" if particle else "wheel",
        False,
        mechanism.points[joint.point],
        mechanism.points[joint.point],
    )
    edge = None if particle else joint.body
    return Symbol(point=joint.point, pinned=particle, edge=edge, rims=(rim,))


def _limit(rim: Rim, rims: tuple[Rim, ...], shapes: Mapping[str, str]) -> Rim:
    """A rim of which the author wants only an arc; that around a wheel within it goes on to where
    an arrow from its centre passes beside the wheel.
    """
    if shapes.get(rim.body) != "arc":
        return rim
    middle, contacts = angle_of(rim.touch - rim.at), [rim.touch]
    for wheel in rims:
        if rim.ring and wheel is not rim:
            aside = asin(min(1.0, wheel.radius / length(wheel.at - rim.at))) - _WITHIN_ARC
            ends = (middle - aside, middle + aside) if aside > 0 else ()
            contacts += [rim.at + polar(end, rim.radius) for end in ends]
    return replace(rim, contacts=tuple(contacts))


def _choose_kind(
    body: str, toothed: bool, profile: Profile | None, shapes: Mapping[str, str]
) -> Kind:
    if toothed:
        return "gear"
    is_curved = profile == Profile(body, of_curvature=True)
    return "cam" if is_curved or shapes.get(body) == "cam" else "wheel"


def _find_rims(
    mechanism: Mechanism, joint: Contact | Roll | Mesh, kinds: Mapping[str, Kind]
) -> tuple[Rim, ...]:
    """The circle of a joint, and that of its partner if it has one."""
    circles = [(joint.body, joint.circle)]
    if isinstance(joint.on, Circle):
        circles.append((joint.of, joint.on))
    touch = _find_touching_point(mechanism, joint)
    outer = max(circle.radius for _, circle in circles)
    return tuple(
        Rim(
            body,
            circle.centre,
            mechanism.points[circle.centre],
            circle.radius,
            kinds[body],
            joint.inside and circle.radius == outer,
            touch,
            touch,
        )
        for body, circle in circles
    )


def _find_touching_point(mechanism: Mechanism, joint: Contact | Roll | Mesh) -> Vector:
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
