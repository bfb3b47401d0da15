"""Straight tracks of the ground: one surface under all wheels on the same line, or a fixed rack."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from kinegrade.figure.mechanism.rims import find_touching_point, is_toothed
from kinegrade.figure.plane import on_line, same_line, unit
from kinegrade.figure.scene import PITCH, Primitive, Strokes
from kinegrade.figure.symbols import RACK_DEPTH, draw_ground
from kinegrade.mechanics.joints import GROUND, Contact, Line, Pin, Roll, Slide
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector

_LEAST = 8.0  # millimetres of a track on either side of a contact
_SHARE = 1.2  # of the wheel's radius that a track has at least on either side


@dataclass(frozen=True)
class _Foot:
    line: Line
    contact: Vector
    away: Vector  # from the wheel into the ground
    reach: float
    toothed: bool


def draw_tracks(mechanism: Mechanism, shapes: Mapping[str, str]) -> tuple[Primitive, ...]:
    """The hatched surfaces, each as long as its wheels need and extended to the ground pins on
    it.
    """
    groups: list[list[_Foot]] = []
    for standing in _find_feet(mechanism, shapes):
        home = next((group for group in groups if _share_surface(group[0], standing)), None)
        if home is None:
            groups.append([standing])
        else:
            home.append(standing)
    return tuple(
        piece for group in groups for piece in _draw_surface(group, _find_fixed_points(mechanism))
    )


def find_fixed_pins(mechanism: Mechanism) -> list[str]:
    """The points fixed to the ground: its pins, and those about which it guides a moving line."""
    pins = [
        joint.point
        for joint in mechanism.joints
        if isinstance(joint, Pin) and GROUND in joint.bodies
    ]
    pins += [
        joint.point
        for joint in mechanism.joints
        if isinstance(joint, Slide) and joint.body == GROUND
    ]
    return list(dict.fromkeys(pins))


def _find_fixed_points(mechanism: Mechanism) -> list[Vector]:
    return [mechanism.points[name] for name in find_fixed_pins(mechanism)]


def _find_feet(mechanism: Mechanism, shapes: Mapping[str, str]) -> Iterator[_Foot]:
    for joint in mechanism.joints:
        if isinstance(joint, Contact | Roll) and joint.of == GROUND and isinstance(joint.on, Line):
            contact = find_touching_point(mechanism, joint)
            away = unit(contact - mechanism.points[joint.circle.centre])
            reach = max(_LEAST, _SHARE * joint.circle.radius)
            yield _Foot(joint.on, contact, away, reach, is_toothed(joint, shapes))


def _share_surface(one: _Foot, other: _Foot) -> bool:
    return (
        same_line(one.line, other.line)
        and one.away.dot(other.away) > 0
        and one.toothed == other.toothed
    )


def _draw_surface(group: list[_Foot], pins: list[Vector]) -> tuple[Primitive, ...]:
    first = group[0]
    along = first.away.turned()
    stations = [step for foot in group for step in _measure_span(foot, along)]
    stations += [pin for pin in pins if on_line(pin, first.line)]
    start, end = min(stations, key=along.dot), max(stations, key=along.dot)
    if not first.toothed:
        return draw_ground(start, end, first.away)
    depth = first.away * RACK_DEPTH
    return (*draw_ground(start + depth, end + depth, first.away), Strokes(((start, end),), PITCH))


def _measure_span(foot: _Foot, along: Vector) -> tuple[Vector, Vector]:
    return foot.contact - along * foot.reach, foot.contact + along * foot.reach
