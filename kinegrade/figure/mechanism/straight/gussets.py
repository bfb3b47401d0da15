"""Rigid corners: where two bars of one body meet, an arm meets the sleeve it carries, or a rod its
slotted bar, a gusset fills each angle between them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence, Set
from itertools import combinations, product

from msgspec import Struct

from kinegrade.figure.joints.symbol import Symbol
from kinegrade.figure.mechanism.straight.welded_rods import is_welded
from kinegrade.figure.mechanism.straight_parts import Bar, Part, Rod, is_slender, list_ways
from kinegrade.figure.plane import NEAR, length, unit
from kinegrade.figure.scene import Outline, Primitive
from kinegrade.figure.symbols.bars import SLEEVE_WIDTH
from kinegrade.figure.symbols.sliding import WIDTH_ABOUT_PIN
from kinegrade.mechanics.joints import Line
from kinegrade.mechanics.vector import Vector

_LEG = 2.2  # millimetres of a bar along which a gusset is welded to it
# The same under a pin, and more where the angle is wide, so that the gusset reaches out from it
_PINNED_LEG, _LONG_LEG, _BEYOND_PIN = 3.0, 5.0, 2.1
_SLEEVE_LEG = 1.8  # the same, of an arm on a sleeve
_SHARE = 0.4  # of the shorter bar that a gusset takes at most
_STRAIGHT = 0.02  # radians: bars in one line have no corner


class Corner(Struct, frozen=True):
    """A rigid corner: its place, the unit vectors of two bars that leave it, and the millimetres
    of each that a gusset takes.
    """

    at: Vector
    legs: tuple[Vector, Vector]
    leg: float


def find_corners(
    parts: Sequence[Part], symbols: Sequence[Symbol], pins: Set[Vector]
) -> tuple[Corner, ...]:
    """The corners between slender bars of one body, those between an arm and its sleeve, and those
    between a rod and its slotted bar.
    """
    slender = [part for part in parts if is_slender(part)]
    between = [
        corner
        for one, other in combinations(slender, 2)
        if one.body == other.body
        for corner in _find_corners_between(one, other, pins)
    ]
    arms = [corner for arm in find_welded_arms(parts, symbols) for corner in _weld(*arm, pins)]
    rods = [part for part in parts if isinstance(part, Rod)]
    bars = [part for part in parts if isinstance(part, Bar)]
    welded = [
        Corner(rod.start, (unit(rod.end - rod.start), side), _SLEEVE_LEG)
        for rod, bar in product(rods, bars)
        if is_welded(rod, bar)
        for side in (unit(bar.end - bar.start), unit(bar.start - bar.end))
    ]
    return (*between, *arms, *welded)


def find_welded_arms(
    parts: Sequence[Part], symbols: Sequence[Symbol]
) -> Iterator[tuple[Bar | Rod, Line]]:
    """Each bar that ends at a sleeve of its own body, with the axis of the sleeve, which it meets
    at an angle.
    """
    for symbol in symbols:
        for part in parts:
            if symbol.sleeve and is_slender(part) and part.body == symbol.carrier:
                ways = list_ways(part, symbol.sleeve.point)
                if len(ways) == 1 and _is_corner(ways[0], symbol.sleeve.direction):
                    yield part, symbol.sleeve


def draw_gussets(corners: Sequence[Corner]) -> Iterator[Primitive]:
    """The gussets, each a black triangle."""
    for corner in corners:
        ends = (corner.at + leg * corner.leg for leg in corner.legs)
        yield Outline((corner.at, *ends), None, "black")


def _find_corners_between(one: Bar | Rod, other: Bar | Rod, pins: Set[Vector]) -> Iterator[Corner]:
    for at in dict.fromkeys((one.start, one.end, other.start, other.end)):
        for way, across in product(list_ways(one, at), list_ways(other, at)):
            if _is_corner(way, across):
                legs = unit(way), unit(across)
                wanted = _choose_leg_under_pin(*legs) if at in pins else _LEG
                yield Corner(at, legs, min(wanted, _SHARE * length(way), _SHARE * length(across)))


def _choose_leg_under_pin(one: Vector, other: Vector) -> float:
    chord = length(one + other) / 2  # its distance from the corner, over the leg
    return max(_PINNED_LEG, min(_LONG_LEG, _BEYOND_PIN / chord))


def _weld(arm: Bar | Rod, sleeve: Line, pins: Set[Vector]) -> Iterator[Corner]:
    """The two corners of an arm with the edge of its sleeve, which is wider where that turns about
    one of the pins.
    """
    turns = any(length(sleeve.point - pin) < NEAR for pin in pins)
    half = (WIDTH_ABOUT_PIN if turns else SLEEVE_WIDTH) / 2
    (way,) = list_ways(arm, sleeve.point)
    toward, along = unit(way), unit(sleeve.direction)
    edge = sleeve.point + toward * (half / abs(toward.cross(along)))
    for side in (along, -along):
        yield Corner(edge, (toward, side), _SLEEVE_LEG)


def _is_corner(one: Vector, other: Vector) -> bool:
    return bool(abs(unit(one).cross(unit(other))) > _STRAIGHT)
