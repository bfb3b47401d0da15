"""The bisector of a given angle one leg of which points along the x axis."""

from __future__ import annotations

from typing import assert_never

from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation
from kinegrade.worked.case import Case
from kinegrade.worked.findings import Stated
from kinegrade.worked.formulas.atoms import TWO
from kinegrade.worked.formulas.measures import bearing, tidy
from kinegrade.worked.positions.stated_angles import find_stated_angle

_CLOSE = 1e-6  # degrees


def find_bisector_angle(direction: Expression, case: Case) -> Stated | None:
    """Half the given angle at a point, for the direction from there to the midpoint of two others
    as far from it, or normal to that; None for any other direction.
    """
    match direction:
        case Call("turned", (inner,)):
            return find_bisector_angle(inner, case)
        case Operation("-", Call("midpoint", (Name(first), Name(second))), Name(apex)):
            legs = (first, second), (second, first)
            halves = (_halve(apex, *pair, case) for pair in legs)
            return next((half for half in halves if half is not None), None)
        case Call() | Name() | Number() | Operation():
            return None
        case _:
            assert_never(direction)


def _halve(apex: str, along: str, other: str, case: Case) -> Stated | None:
    """Half the angle that places one leg, where the other one points along the x axis and both
    have one length.
    """
    points, is_zero = case.motion.points, case.arithmetic.is_zero
    base, leg = (points[end] - points[apex] for end in (along, other))
    stated = find_stated_angle((apex, other), case)
    if stated is None or abs(bearing(base)) > _CLOSE or not is_zero(base.squared() - leg.squared()):
        return None
    angle, sign, value = stated
    if abs((bearing(leg) - sign * value + 180) % 360 - 180) > _CLOSE:  # of the line, not the leg
        return None
    return angle / TWO, sign, tidy(value / 2)
