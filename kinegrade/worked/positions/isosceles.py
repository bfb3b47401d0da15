"""Lines whose angle with the x axis is a given one because they are legs of an isosceles triangle
with its base along an axis.
"""

from __future__ import annotations

from kinegrade.worked.case import Case
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.positions.stated_angles import find_stated_angle

_RIGHT = 90.0


def find_other_leg(ends: tuple[str, str], case: Case) -> tuple[str, str] | None:
    """The foot and the apex of the leg across from a line, where its angle is given."""
    points, is_zero = case.motion.points, case.arithmetic.is_zero
    for foot, apex in (ends, ends[::-1]):
        side = points[apex] - points[foot]
        for other, place in points.items():
            base, leg = place - points[foot], points[apex] - place
            if other in ends or not is_zero(base.y) or is_zero(base.x):
                continue
            if is_zero(side.squared() - leg.squared()) and _is_acute((other, apex), case):
                return other, apex
    return None


def _is_acute(leg: tuple[str, str], case: Case) -> bool:
    """Whether the angle of a line is given, and is that of a triangle with its base along x."""
    stated = find_stated_angle(leg, case)
    return stated is not None and 0 < stated[2] < _RIGHT


def find_mirrored_angle(ends: tuple[str, str], case: Case) -> tuple[Formula, int, float] | None:
    """The angle of a line by that of the other leg, where a solution has said so."""
    leg = case.findings.legs.get(frozenset(ends))
    stated = find_stated_angle(leg, case) if leg else None
    if stated is None:
        return None
    angle, sign, value = stated
    return angle, -sign, value
