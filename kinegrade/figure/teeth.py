"""The teeth of gears and racks in millimetres: trapezoids of one size on the pitch line, whatever
the gear, so that gears of one figure mesh.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, cos, floor, pi, sin

from kinegrade.figure.plane import angle_of, length, unit
from kinegrade.mechanics.vector import Vector

_PITCH = 4.0  # from tooth to tooth
_LEAST = 8  # teeth of a gear
_BESIDE_EYE = 3.4  # from the pin at the end of a rack to its first tooth
# Of the pitch line at an end without an eye, up to which the rack is solid, and of one that is wide
# instead of a tooth so near to the end that the two would make a hook
_LAND, _WIDE_LAND = 0.9, 2.2
_BESIDE_END = 0.85 * _PITCH
_TAPER = 4.2  # of the back of a rack that narrows towards such a pin
_HALF_ARM, _ARM = 1.2, 2.2  # half the width and the length of the arm with the eye
TOOTH_TIP, TOOTH_ROOT = 0.7, 1.05  # from the pitch line, into the partner and into the material
# Corners of a tooth: along the pitch line in parts of the pitch, and outward from it; narrow, so
# that paper is seen between the flanks of two gears
_CORNERS = ((-0.25, -TOOTH_ROOT), (-0.09, TOOTH_TIP), (0.09, TOOTH_TIP), (0.25, -TOOTH_ROOT))


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


def find_teeth_of_rack(
    start: Vector, end: Vector, gap: Vector, eyes: Sequence[Vector]
) -> list[Vector]:
    """The middles of a rack's teeth on its pitch line, with the middle of a gap at that point, none
    in the way of an eye and none, where there is one, that would make a hook with the other end.
    """
    along = unit(end - start)
    near, far = (start - gap).dot(along) / _PITCH, (end - gap).dot(along) / _PITCH
    middles = [gap + along * ((number + 0.5) * _PITCH) for number in range(ceil(near), floor(far))]
    room = [(tip, _BESIDE_EYE if tip in eyes else _BESIDE_END) for tip in (start, end) if eyes]
    return [at for at in middles if all(length(at - tip) > least for tip, least in room)]


def trace_rack(
    ends: tuple[Vector, Vector],
    back: Vector,
    teeth: Sequence[Vector],
    depth: float,
    eyes: Sequence[Vector],
) -> tuple[Vector, ...]:
    """The contour of a rack with its pitch line between the ends and teeth there, its back at
    that depth in the direction `back`; it narrows to an arm about the pin at the ends that have an
    eye, and is solid up to the others, so that a point marked there lies on it.
    """
    start, end = ends
    along, base = unit(end - start), back * depth
    near, far = (along * (_TAPER if at in eyes else 0.0) for at in ends)
    land = _WIDE_LAND if eyes else _LAND
    first = _trace_end(start, along, back, 0.0 if start in eyes else land)
    last = _trace_end(end, -along, back, 0.0 if end in eyes else land)[::-1]
    profile = [
        at + along * (share * _PITCH) - back * height for at in teeth for share, height in _CORNERS
    ]
    return (start + near + base, *first, *profile, *last, end - far + base)


def _trace_end(at: Vector, inward: Vector, back: Vector, land: float) -> tuple[Vector, ...]:
    """The contour from an end of the back to the root of the first tooth; without land about the
    pin there.
    """
    if not land:
        half = back * _HALF_ARM
        return at + half, at - half, at + inward * _ARM - half
    solid = at + inward * land
    return at, solid, solid + back * TOOTH_ROOT
