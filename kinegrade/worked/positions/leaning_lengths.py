"""The distance of two points on a line whose angle is given, by one coordinate alone:
OM = x_M/cos(phi).
"""

from __future__ import annotations

from math import atan2, pi

from kinegrade.expressions.tree import Call, Expression, Name, Operation, walk
from kinegrade.worked.formulas.atoms import AXES
from kinegrade.worked.formulas.measures import double, measure_angle
from kinegrade.worked.positions.algebra import ZERO, make_positive, over
from kinegrade.worked.positions.instance import Instance
from kinegrade.worked.positions.right_angles import make_unit
from kinegrade.worked.positions.stated_angles import find_stated_tree

_CLOSE = 1e-9
_Ratios = tuple[Expression, Expression]


def measure_along(start: str, end: str, instance: Instance) -> Expression | None:
    """The distance as a coordinate over a sine or cosine of a given angle: by a length that is
    given, else of the difference of coordinates that is the shorter formula, or else the larger;
    None along an axis, and where no given angle states the line.
    """
    stated = find_stated_tree((start, end), instance.case)
    away = instance.case.motion.points[end] - instance.case.motion.points[start]
    size, (x, y) = double(away.squared()) ** 0.5, map(double, away)
    if stated is None or min(abs(x), abs(y)) < _CLOSE * size:
        return None
    sign, angle = stated
    placed = instance.axes.pair(Operation("-", Name(end), Name(start))) or (ZERO, ZERO)
    pair = [_find_given(one, instance) for one in placed]
    ratios = _split(sign * measure_angle(instance.value(angle)), make_unit(angle), atan2(y, x))
    if ratios is None:
        return None
    sides = sorted(
        zip(pair, ratios, (x, y), strict=True),
        key=lambda side: (not isinstance(side[0], Name), _count(side[0]), -abs(side[2])),
    )
    part, ratio, _ = sides[0]
    if part == ZERO:
        return None
    return over(*(make_positive(one, instance.sign(one)) for one in (part, ratio)))


def _find_given(coordinate: Expression, instance: Instance) -> Expression:
    """The length by which a template states a coordinate, so that no rounded one stands for it; the
    coordinate where it states none.
    """
    for step in instance.steps:
        leaves = (Call(axis, (Name(step.point),)) for axis in AXES)
        for leaf, tree in zip(leaves, instance.axes.pair(step.tree) or (), strict=False):
            if leaf == coordinate and isinstance(tree, Name):
                return tree
    return coordinate


def _split(angle: float, unit: _Ratios, bearing: float) -> _Ratios | None:
    """The shares of a length on a line that x and y are: cosine and sine of the angle, or the other
    way round where the line is a right angle from there; None where it is neither.
    """
    quarters = (bearing - angle) / (pi / 2)
    if abs(quarters - round(quarters)) > _CLOSE:
        return None
    cosine, sine = unit
    return (cosine, sine) if round(quarters) % 2 == 0 else (sine, cosine)


def _count(tree: Expression) -> int:
    """How many sums and differences a formula has."""
    parts = (one for one in walk(tree) if isinstance(one, Operation))
    return sum(one.sign in ("+", "-") for one in parts)
