"""Straight tracks of the ground: one surface under all wheels on the same line, or a fixed rack."""

from __future__ import annotations

from collections.abc import Sequence

from kinegrade.figure.joints.symbol import Foot, Rim, find_fixed_pins
from kinegrade.figure.mechanism.anatomy import Anatomy
from kinegrade.figure.mechanism.rims import find_gap_of_rack
from kinegrade.figure.plane import NEAR, length, on_line, same_line
from kinegrade.figure.scene import Primitive
from kinegrade.figure.symbols.ground import draw_ground
from kinegrade.figure.symbols.teeth import RACK_DEPTH, draw_rack
from kinegrade.mechanics.vector import Vector

_LEAST = 8.0  # millimetres of a track on either side of a contact
_BEYOND = 3.0  # millimetres beyond a larger circle, in front of which a track runs
_SHARE = 1.2  # of the wheel's radius that a track has at least on either side


def draw_tracks(anatomy: Anatomy) -> tuple[Primitive, ...]:
    """The hatched surfaces, each as long as its wheels need and extended to the ground pins on
    it.
    """
    groups: list[list[Foot]] = []
    for standing in (symbol.foot for symbol in anatomy.symbols if symbol.foot):
        home = next((group for group in groups if _share_surface(group[0], standing)), None)
        if home is None:
            groups.append([standing])
        else:
            home.append(standing)
    pins = [anatomy.mechanism.points[name] for name in find_fixed_pins(anatomy.symbols)]
    return tuple(piece for group in groups for piece in _draw_surface(group, pins, anatomy.rims))


def _share_surface(one: Foot, other: Foot) -> bool:
    return (
        same_line(one.line, other.line)
        and one.away.dot(other.away) > 0
        and one.toothed == other.toothed
    )


def _draw_surface(
    group: list[Foot], pins: list[Vector], rims: Sequence[Rim]
) -> tuple[Primitive, ...]:
    first = group[0]
    along = first.away.turned()
    stations = [step for foot in group for step in _measure_span(foot, along, rims)]
    stations += [pin for pin in pins if on_line(pin, first.line)]
    start, end = min(stations, key=along.dot), max(stations, key=along.dot)
    if not first.toothed:
        return draw_ground(start, end, first.away)
    depth = first.away * RACK_DEPTH
    gap = find_gap_of_rack(rims, first.contact)
    rack = draw_rack(start, end, first.away, gap)
    return (*rack, *draw_ground(start + depth, end + depth, first.away))


def _measure_span(foot: Foot, along: Vector, rims: Sequence[Rim]) -> tuple[Vector, Vector]:
    """Beyond every circle about the wheel's centre that reaches below the track."""
    centre = foot.contact - foot.away * foot.radius
    about = [rim.radius for rim in rims if length(rim.at - centre) < NEAR]
    larger = [radius + _BEYOND for radius in about if radius > foot.radius + NEAR]
    reach = max(_LEAST, _SHARE * foot.radius, *larger)
    return foot.contact - along * reach, foot.contact + along * reach
