"""The acute angle between the x axis and a line whose direction a triangle has given: by that
direction, so that it is not found a second time.
"""

from __future__ import annotations

from math import degrees

from kinegrade.expressions.tree import Expression, Name, Number
from kinegrade.worked.formulas.measures import measure_angle
from kinegrade.worked.positions.algebra import ZERO, make_positive, minus, over, times
from kinegrade.worked.positions.instance import Instance
from kinegrade.worked.positions.right_angles import split_right_angles

_HALF_TURN, _TWO = Name("pi"), Number(2)


def find_seen_acute(
    ends: tuple[str, str], instance: Instance
) -> tuple[Expression, Instance] | None:
    """The angle as what remains of the direction beside whole half turns, with the instance that
    knows the triangle's angle; None where no triangle has given the direction.
    """
    pairs = tuple(map(Name, ends)), tuple(map(Name, reversed(ends)))
    found = instance.case.findings.seen.items()
    seen = next((one for pair, one in found if pair in pairs), None)
    if seen is None:
        return None
    named = instance.named(seen.name, seen.symbol, seen.value)
    _, rest, quarters = split_right_angles(seen.tree)
    turned = degrees(measure_angle(named.value(rest))) / 90
    halves = quarters + 2 * round((turned - quarters) / 2)
    left = minus(rest, _count_right_angles(halves))
    return make_positive(left, named.sign(left)), named


def _count_right_angles(count: int) -> Expression:
    if count % 2 == 0:
        return times(Number(count // 2), _HALF_TURN) if count else ZERO
    return over(times(Number(count), _HALF_TURN), _TWO)
