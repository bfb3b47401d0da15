"""A cam known only by its curvature at the contact: a smooth closed convex profile that has it there.

The profile is the hull of a base disc about the pivot and of the osculating circle's arc around the contact,
its corners rounded by discs that touch the arc from inside: exact at the contact, free elsewhere.
"""

from __future__ import annotations

from math import asin, pi

from kinegrade.figure.plane import angle_of, hull, polar, unit
from kinegrade.mechanics.vector import Vector

BASE = 0.5  # base radius over the height of the contact's tangent; below 1 keeps the arc outermost
STEPS = 72


def cam_profile(
    pivot: Vector, contact: Vector, curvature_centre: Vector, radius: float
) -> tuple[Vector, ...]:
    """The contour, counter-clockwise: through `contact`, curved there with `radius` (all in one unit)."""
    normal = unit(contact - curvature_centre)
    height = (contact - pivot).dot(normal)
    base = BASE * max(height, 0.0)
    spread = _spread(radius, height)
    nose = min(radius, 0.35 * max(height, radius * 0.1))
    facing = angle_of(normal)
    points = _arc(curvature_centre, radius, facing - spread, 2 * spread)
    for side in (-spread, spread):
        points += _arc(curvature_centre + polar(facing + side, radius - nose), nose, 0.0, 2 * pi)
    return hull(points + _arc(pivot, base, 0.0, 2 * pi))


def _spread(radius: float, height: float) -> float:
    """Half the angle of the osculating arc that is kept: the nose, but no more than the cam's width."""
    return min(1.2, asin(min(1.0, 0.75 * max(height, 0.1 * radius) / radius)))


def _arc(centre: Vector, radius: float, start: float, sweep: float) -> list[Vector]:
    return [centre + polar(start + sweep * index / STEPS, radius) for index in range(STEPS + 1)]
