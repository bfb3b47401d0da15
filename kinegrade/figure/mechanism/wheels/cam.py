"""A cam known only by its curvature at the contact: a smooth closed convex profile with that
curvature there, exact at the contact and arbitrary elsewhere.

Its radius of curvature, as a function of the direction of the normal, is a constant with a second
and a third harmonic: an egg without kinks, closed because there is no first harmonic.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from math import atan2, cos, pi, sin

from msgspec import Struct

from kinegrade.figure.plane import polar, unit
from kinegrade.mechanics.vector import Vector

_STEPS = 90  # directions, four degrees apart: a chord leaves its arc by 0.0006 of the radius
_TRIALS = 18  # directions in which an egg is tried
# Depths of a cam over the height of its contact, and tilts over the angle of its contact: the first
# that fit are taken
_DEPTHS, _TILTS = ((1.8, 2.2, 2.7, 3.4, 4.4, 5.7), (0.5, 0.0))
_FLATTEST = 0.55  # times the radius of curvature: the least height from which depths are taken
_PEAR = 0.2  # half of what the second harmonic exceeds the third by
_LEAST_REACH = 0.3  # of a cam about its pivot, over the height of its contact
_SHARPEST = 0.25  # least radius of curvature, over that at the contact or the mean one


class _Egg(Struct, frozen=True):
    """A profile about its own middle: the mean radius of curvature, the harmonics over it, and the
    direction of its nose, in radians from the contact.
    """

    size: float
    second: float
    third: float
    tilt: float

    def find_radius(self, turn: float) -> float:
        """The radius of curvature where the normal has turned by an angle from the contact."""
        leaning = turn - self.tilt
        return self.size * (1 + self.second * cos(2 * leaning) + self.third * cos(3 * leaning))

    def find_point(self, turn: float) -> Vector:
        """The point there; the normal at the contact points right."""
        along, upward = cos(turn) * self.size, sin(turn) * self.size  # plain numbers: half the time
        twice, thrice = 2 * (turn - self.tilt), 3 * (turn - self.tilt)
        reach = 1 - self.second * cos(twice) / 3 - self.third * cos(thrice) / 8
        aside = self.second * sin(twice) * 2 / 3 + self.third * sin(thrice) * 3 / 8
        return Vector(reach * along - aside * upward, reach * upward + aside * along)

    def suits(self, contact: Vector, radius: float) -> bool:
        """Whether it has no sharp nose, and its pivot well inside; the contact about the pivot."""
        shift = contact - self.find_point(0.0)
        turns = [2 * pi * number / _TRIALS for number in range(_TRIALS)]
        sharpest, least = _SHARPEST * min(radius, self.size), _LEAST_REACH * contact.x
        return all(self.find_radius(turn) >= sharpest for turn in turns) and all(
            (self.find_point(turn) + shift).dot(polar(turn)) >= least for turn in turns
        )


def trace_cam_profile(
    pivot: Vector, contact: Vector, curvature_centre: Vector, radius: float
) -> tuple[Vector, ...]:
    """The contour, counter-clockwise: through `contact`, with the radius of curvature `radius`
    there (all in one unit).
    """
    normal, step = unit(contact - curvature_centre), contact - pivot
    place = Vector(step.dot(normal), normal.cross(step))
    circle = _Egg(radius, 0.0, 0.0, 0.0)
    egg = next((egg for egg in _list_eggs(place, radius) if egg.suits(place, radius)), circle)
    (shift_x, shift_y), (along, upward) = place - egg.find_point(0.0), normal
    turns = (2 * pi * number / _STEPS for number in range(-_STEPS // 2, _STEPS // 2))
    about = [(x + shift_x, y + shift_y) for x, y in map(egg.find_point, turns)]
    return tuple(
        Vector(pivot.x + x * along - y * upward, pivot.y + x * upward + y * along) for x, y in about
    )


def _list_eggs(contact: Vector, radius: float) -> Iterator[_Egg]:
    """Eggs with that radius of curvature at the contact, whose nose is between its normal and the
    line to the pivot.
    """
    height = max(contact.x, _FLATTEST * radius)
    for depth, tilt in product(_DEPTHS, _TILTS):
        yield _solve_egg(radius, depth * height, tilt * atan2(contact.y, contact.x))


def _solve_egg(radius: float, depth: float, tilt: float) -> _Egg:
    """The egg with that radius of curvature at the contact and that depth along the normal there:
    two equations for the mean radius and for the mean harmonic times it.
    """
    second, third = cos(2 * tilt), cos(3 * tilt)
    curved, swing = 1 + _PEAR * (second - third), second + third
    deep, dip = 1 - _PEAR * second / 3, -second / 3
    whole = curved * dip - swing * deep
    size = (radius * dip - swing * depth / 2) / whole
    mean = (curved * depth / 2 - radius * deep) / whole / size
    return _Egg(size, mean + _PEAR, mean - _PEAR, tilt)
