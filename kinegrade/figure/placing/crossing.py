"""Whether lines, rings, boxes and strips meet, in plain numbers.

A line is x, y of its start, the steps dx, dy to its end, their negative inverses, half of its pen's
width and its cost. A ring is x, y, inner radius, outer radius and cost.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot

from kinegrade.mechanics.vector import Vector

Numbers = tuple[float, ...]
Boxed = tuple[float, float, float, float, Numbers]  # left, bottom, right, top, then its numbers

_TOUCH = 1e-6  # millimetres by which two things may overlap and still only touch
SAME_AXIS = 0.05  # millimetres within which two lines count as one
_LEAST = 1e-9  # millimetres: a shorter step counts as this one


def make_strip(start: Vector, end: Vector, half: float) -> Numbers:
    """A strip about a straight piece: its centre x, y, its direction x, y, half its length and half
    its width.
    """
    (x, y), (to_x, to_y) = start, end
    size = max(hypot(to_x - x, to_y - y), _TOUCH)
    return ((x + to_x) / 2, (y + to_y) / 2, (to_x - x) / size, (to_y - y) / size, size / 2, half)


def make_boxed_strip(start: Vector, end: Vector, half: float) -> Boxed:
    """A strip about a straight piece, after its bounding box."""
    (x, y), (to_x, to_y) = start, end
    left, right = (x, to_x) if x < to_x else (to_x, x)
    bottom, top = (y, to_y) if y < to_y else (to_y, y)
    strip = make_strip(start, end, half)
    return (left - half, bottom - half, right + half, top + half, strip)


def any_meets_line(strips: Sequence[Boxed], boxed: Boxed, shared: bool) -> bool:
    """Whether any of the strips meets a line: their boxes, then they themselves."""
    start, low, end, high, line = boxed
    for left, bottom, right, top, strip in strips:
        boxes_meet = start <= right and end >= left and low <= top and high >= bottom
        if boxes_meet and meets_line(strip, line, shared):
            return True
    return False


def any_meets_ring(strips: Sequence[Boxed], boxed: Boxed) -> bool:
    """Whether any of the strips meets a ring: their boxes, then they themselves."""
    start, low, end, high, ring = boxed
    for left, bottom, right, top, strip in strips:
        boxes_meet = start <= right and end >= left and low <= top and high >= bottom
        if boxes_meet and meets_ring(strip, ring):
            return True
    return False


def meets_line(strip: Numbers, line: Numbers, shared: bool) -> bool:
    """Whether a strip meets a line; one that may be shared does not count on the strip's axis."""
    centre_x, centre_y, along, across, half_length, half_width = strip
    x, y, dx, dy, _, _, pen, _ = line
    x, y = x - centre_x, y - centre_y
    off, sideways = y * along - x * across, dy * along - dx * across
    if shared and abs(off) <= SAME_AXIS and abs(off + sideways) <= SAME_AXIS:
        return False
    start, further = x * along + y * across, dx * along + dy * across
    wide, high = half_width + pen, half_length + pen
    return crosses_box((off, invert_step(sideways), wide), (start, invert_step(further), high))


def meets_ring(strip: Numbers, ring: Numbers) -> bool:
    """Whether a strip meets a ring."""
    centre_x, centre_y, along, across, half_length, half_width = strip
    x, y, inner, outer, _ = ring
    turned = resolve(x - centre_x, y - centre_y, along, across)
    return encircles_box(*turned, (half_length, half_width), inner, outer)


def invert_step(step: float) -> float:
    """The negative inverse of a step; a step shorter than LEAST counts as LEAST."""
    return -1.0 / (step if abs(step) >= _LEAST else _LEAST)


def crosses_box(across: Numbers, upward: Numbers) -> bool:
    """Whether a line meets a box about the origin: it lies within both bands at the same time
    (Liang and Barsky).

    For either coordinate the start of the line, its pace, and half of the box.
    """
    x, pace_x, wide = across
    middle, reach = x * pace_x, (wide - _TOUCH) * abs(pace_x)
    enters, leaves = middle - reach, middle + reach
    if enters > 1.0 or leaves < 0.0:
        return False
    y, pace_y, high = upward
    level, rise = y * pace_y, (high - _TOUCH) * abs(pace_y)
    comes, goes = level - rise, level + rise
    if comes > 1.0 or goes < 0.0 or comes > leaves or goes < enters:
        return False
    return enters <= leaves and comes <= goes


def encircles_box(
    x: float, y: float, half: tuple[float, float], inner: float, outer: float
) -> bool:
    """Whether a ring meets a box about the origin, by the nearest point of the box and the
    farthest.
    """
    away_x, away_y, wide, high = abs(x), abs(y), half[0] - _TOUCH, half[1] - _TOUCH
    if max(away_x - wide, 0.0) ** 2 + max(away_y - high, 0.0) ** 2 > outer**2:
        return False
    return (away_x + wide) ** 2 + (away_y + high) ** 2 >= inner**2


def resolve(x: float, y: float, along: float, across: float) -> tuple[float, float]:
    """The components of a vector along and across a direction."""
    return x * along + y * across, y * along - x * across
