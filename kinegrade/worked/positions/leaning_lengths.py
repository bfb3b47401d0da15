"""The distance of two points on a line whose angle is given, by one coordinate alone:
OM = x_M/cos(phi).
"""

from __future__ import annotations

from math import cos, sin

from kinegrade.expressions.tree import Expression, Name, Operation, walk
from kinegrade.numbers.angle import Angle
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.positions.algebra import ZERO, make_positive, over
from kinegrade.worked.positions.instance import Instance
from kinegrade.worked.positions.right_angles import make_unit
from kinegrade.worked.positions.stated_angles import find_stated_tree

_CLOSE = 1e-9


def measure_along(start: str, end: str, instance: Instance) -> Expression | None:
    """The distance as a coordinate over a sine or cosine of a given angle: of the difference of
    coordinates that is the shorter formula, or else the larger; None along an axis, and where no
    given angle states the line.
    """
    angle = find_stated_tree((start, end), instance.case)
    away = instance.case.motion.points[end] - instance.case.motion.points[start]
    size, (x, y) = double(away.squared()) ** 0.5, map(double, away)
    if angle is None or min(abs(x), abs(y)) < _CLOSE * size:
        return None
    pair = instance.axes.pair(Operation("-", Name(end), Name(start))) or (ZERO, ZERO)
    sides = sorted(
        zip(pair, (x, y), strict=True), key=lambda side: (_count(side[0]), -abs(side[1]))
    )
    part, seen = sides[0]
    value = _measure(instance.value(angle))
    for ratio, number in zip(make_unit(angle), (cos(value), sin(value)), strict=True):
        if part != ZERO and abs(abs(seen) - size * abs(number)) < _CLOSE * size:
            above, below = (make_positive(one, instance.sign(one)) for one in (part, ratio))
            return over(above, below)
    return None


def _measure(angle: object) -> float:
    """An angle in radians."""
    return double(angle.ball() if isinstance(angle, Angle) else angle)


def _count(tree: Expression) -> int:
    """How many sums and differences a formula has."""
    parts = (one for one in walk(tree) if isinstance(one, Operation))
    return sum(one.sign in ("+", "-") for one in parts)
