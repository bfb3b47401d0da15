"""Checks of right angles that the figure states: by the coordinates of their points."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.language.message import Message
from kinegrade.mechanics.vector import AxisName
from kinegrade.worked.case import Case
from kinegrade.worked.checks.check import Check, compare
from kinegrade.worked.checks.positions.sleeves import multiply_coordinates
from kinegrade.worked.checks.sides import Side
from kinegrade.worked.formulas.atoms import AXES
from kinegrade.worked.formulas.measures import double


def list_right_angles(case: Case) -> Iterator[Check]:
    """The checks of those whose legs lie along no axis."""
    points = case.motion.points
    for first, corner, second in case.template.figure.right_angles:
        if not {first, corner, second} <= points.keys():
            continue
        legs = [points[end] - points[corner] for end in (first, second)]
        if all(double(one) for leg in legs for one in leg) and not double(legs[0].dot(legs[1])):
            yield _check(corner, (first, second), case)


def _check(corner: str, ends: tuple[str, str], case: Case) -> Check:
    """The two products of the scalar product that is zero, one on each side."""
    axes: tuple[AxisName, AxisName] = AXES
    along, across = (
        multiply_coordinates(axis, corner, ends, case.motion.points, case) for axis in axes
    )
    first, second = map(case.naming.point, ends)
    names = {"corner": case.naming.point(corner), "first": first, "second": second}
    turned = Side(-across.numbers, -across.value, -across.sum)
    return compare(Message("solution.stated-right-angle", **names), along, turned, "m^2")
