"""The teeth of gears and racks in millimetres: trapezoids of one size on the pitch line, whatever
the gear, so that gears of one figure mesh. Where their numbers are given, teeth are fine, and cut
only where gears mesh, so that nobody counts others than those that are given.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, floor, pi

from msgspec import Struct

from kinegrade.figure.plane import angle_of, length, polar, unit
from kinegrade.mechanics.vector import Vector

_BESIDE_EYE = 3.4  # from the pin at the end of a rack to its first tooth
# Of the pitch line at an end without an eye, up to which the rack is solid, and of one that is wide
# instead of a tooth so near to the end that the two would make a hook
_LAND, _WIDE_LAND = 0.9, 2.2
_BESIDE_END = 3.4
_TAPER = 4.2  # of the back of a rack that narrows towards such a pin
_HALF_ARM, _ARM = 1.2, 2.2  # half the width and the length of the arm with the eye
TOOTH_TIP, TOOTH_ROOT = 0.7, 1.05  # from the pitch line, into the partner and into the material
_SECTOR = 5.0  # millimetres on either side of a mesh in which fine teeth are cut


class Toothing(Struct, frozen=True):
    """The size of teeth in millimetres: from tooth to tooth, from the pitch line to tip and root;
    the least number of a gear.
    """

    pitch: float
    tip: float
    root: float
    least: int

    @property
    def corners(self) -> tuple[tuple[float, float], ...]:
        """Corners of a tooth: along the pitch line in parts of the pitch, and outward from it;
        narrow, so that paper is seen between the flanks of two gears.
        """
        return ((-0.25, -self.root), (-0.09, self.tip), (0.09, self.tip), (0.25, -self.root))


COARSE = Toothing(4.0, TOOTH_TIP, TOOTH_ROOT, 8)
FINE = Toothing(1.6, 0.5, 0.64, 12)
_PITCH, _CORNERS = COARSE.pitch, COARSE.corners


def find_tooth_angle(radius: float, toothing: Toothing = COARSE) -> float:
    """From tooth to tooth of a gear with that pitch radius, in radians."""
    return 2 * pi / max(toothing.least, round(2 * pi * radius / toothing.pitch))


def trace_gear(
    centre: Vector,
    tooth: Vector,
    inward: bool,
    toothing: Toothing = COARSE,
    meshes: Sequence[Vector] = (),
) -> tuple[Vector, ...]:
    """The contour of a gear whose pitch circle passes through `tooth`, where a tooth is; a ring has
    its teeth inward. Where its `meshes` are given, it is round between them, through the tips.
    """
    radius, first = length(tooth - centre), angle_of(tooth - centre)
    step, outward = find_tooth_angle(radius, toothing), -1.0 if inward else 1.0
    contour = []
    for number in range(round(2 * pi / step)):
        turn = first + number * step
        middle = centre + polar(turn, radius)
        cut = not meshes or any(length(middle - mesh) < _SECTOR for mesh in meshes)
        for share, high in toothing.corners:
            reach = radius + outward * (high if cut else toothing.tip)
            contour.append(centre + polar(turn + share * step, reach))
    return tuple(contour)


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
