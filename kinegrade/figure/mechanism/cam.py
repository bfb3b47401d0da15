"""A cam known only by its curvature at the contact: a smooth closed convex profile with that
curvature there.

The profile is the hull of a base disc about the pivot and of the osculating circle's arc around the
contact, with its corners rounded by discs that touch the arc from inside: exact at the contact,
arbitrary elsewhere. The hull is computed direction by direction: the point that reaches farthest in
a direction is the hull's point with that normal.
"""

from __future__ import annotations

from math import asin, cos, inf, pi, sin

from kinegrade.figure.plane import angle_of, polar, unit
from kinegrade.mechanics.vector import Vector

_BASE = 0.5  # base radius over the height of the contact's tangent; below 1 keeps the arc outermost
_STEPS = 120  # directions, three degrees apart: a chord leaves its arc by 0.0004 of the radius

_Circle = tuple[Vector, float]


def trace_cam_profile(
    pivot: Vector, contact: Vector, curvature_centre: Vector, radius: float
) -> tuple[Vector, ...]:
    """The contour, counter-clockwise: through `contact`, with the radius of curvature `radius`
    there (all in one unit).
    """
    normal = unit(contact - curvature_centre)
    height = (contact - pivot).dot(normal)
    nose = min(radius, 0.35 * max(height, radius * 0.1))
    facing, spread = angle_of(normal), _choose_spread(radius, height)
    corners = [
        (curvature_centre + polar(facing + side, radius - nose), nose) for side in (-spread, spread)
    ]
    outer = [*corners, (pivot, _BASE * max(height, 0.0))]
    within = [(curvature_centre, radius), *outer]
    turns = (2 * pi * step / _STEPS for step in range(-_STEPS // 2, _STEPS // 2))
    return tuple(
        _find_farthest(within if abs(turn) <= spread else outer, facing + turn) for turn in turns
    )


def _find_farthest(circles: list[_Circle], angle: float) -> Vector:
    """The point of the circles that reaches farthest in a direction."""
    along, upward = cos(angle), sin(angle)
    far_x, far_y, farthest = 0.0, 0.0, -inf
    for (x, y), radius in circles:
        reach = x * along + y * upward + radius
        if reach > farthest:
            far_x, far_y, farthest = x + along * radius, y + upward * radius, reach
    return Vector(far_x, far_y)


def _choose_spread(radius: float, height: float) -> float:
    """Half the angle of the osculating arc that is kept: the nose, but no more than the width of
    the cam.
    """
    return min(1.2, asin(min(1.0, 0.75 * max(height, 0.1 * radius) / radius)))
