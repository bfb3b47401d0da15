"""The teeth of gears and racks in millimetres: trapezoids of one size on the pitch line, whatever
the gear, so that gears of one figure mesh.
"""

from __future__ import annotations

from math import ceil, cos, floor, pi, sin

from kinegrade.figure.plane import angle_of, length, unit
from kinegrade.mechanics.vector import Vector

_PITCH = 3.4  # from tooth to tooth
_LEAST = 8  # teeth of a gear
TOOTH_TIP, TOOTH_ROOT = 0.7, 1.05  # from the pitch line, into the partner and into the material
# Corners of a tooth: along the pitch line in parts of the pitch, and outward from it; narrow, so
# that paper is seen between the flanks of two gears
_CORNERS = ((-0.29, -TOOTH_ROOT), (-0.11, TOOTH_TIP), (0.11, TOOTH_TIP), (0.29, -TOOTH_ROOT))


def find_tooth_angle(radius: float) -> float:
    """From tooth to tooth of a gear with that pitch radius, in radians."""
    return 2 * pi / max(_LEAST, round(2 * pi * radius / _PITCH))


def trace_gear(centre: Vector, tooth: Vector, inward: bool) -> tuple[Vector, ...]:
    """The contour of a gear whose pitch circle passes through `tooth`, where a tooth is; a ring has
    its teeth inward.
    """
    radius, first = length(tooth - centre), angle_of(tooth - centre)
    step, outward = find_tooth_angle(radius), -1.0 if inward else 1.0
    (x, y), shares = centre, [(share * step, radius + outward * high) for share, high in _CORNERS]
    turns = (first + number * step for number in range(round(2 * pi / step)))
    return tuple(
        Vector(x + reach * cos(turn + share), y + reach * sin(turn + share))
        for turn in turns
        for share, reach in shares
    )


def trace_rack(
    start: Vector, end: Vector, back: Vector, contact: Vector, depth: float
) -> tuple[Vector, ...]:
    """The contour of a rack with its pitch line from start to end, a gap at the contact, and its
    back at that depth in the direction `back`.
    """
    along = unit(end - start)
    near, far = (start - contact).dot(along) / _PITCH, (end - contact).dot(along) / _PITCH
    teeth = [
        contact + along * ((number + 0.5 + share) * _PITCH) - back * height
        for number in range(ceil(near), floor(far))
        for share, height in _CORNERS
    ]
    root, base = back * TOOTH_ROOT, back * depth
    return (start + base, start + root, *teeth, end + root, end + base)
