"""The vectors from point to point by the differences of their coordinates."""

from __future__ import annotations

from dataclasses import replace

from kinegrade.mechanics.rates import make_turning
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector import Vector
from kinegrade.worked.case import Case
from kinegrade.worked.checks.amounts import Amount, Multiplier, Pair
from kinegrade.worked.formulas.atoms import AXES, AxisName
from kinegrade.worked.formulas.measures import double, length
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.positions.axes import choose_axes
from kinegrade.worked.vectors.arms import find_stated_length, name_length
from kinegrade.worked.vectors.components import state_arm
from kinegrade.worked.vectors.summands import PLACES


def point_from(base: str, point: str, case: Case) -> Multiplier:
    """The vector from one point to another, with its length where that has been found or given."""
    vector = case.motion.points[point] - case.motion.points[base]
    found = point_from_base(Term("rotation", make_turning(""), vector, point, base), case)
    known = frozenset((base, point)) in case.findings.arms or find_stated_length(base, point, case)
    return found if known else replace(found, length=None)


def find_normal_from(base: str, direction: Vector, case: Case) -> Multiplier | None:
    """The vector from a point to another one that is normal to a direction, of given length."""
    start = case.motion.points[base]
    for point, place in case.motion.points.items():
        across = point != base and not double((place - start).dot(direction))
        if across and find_stated_length(base, point, case):
            return point_from(base, point, case)
    return None


def point_from_base(term: Term, case: Case) -> Multiplier:
    """The vector of a rotation, from its base to its point."""
    far = measure(length(term.vector, case.arithmetic), "m")
    arm = Amount(name_length(term.base, term.point, case), far)
    return Multiplier(term.vector, _find_arm(term, case), arm)


def _find_arm(term: Term, case: Case) -> Pair:
    """The coordinates of a rotation's point from its base point: a difference of two as it is."""
    axes = choose_axes(case.construction)
    components: dict[AxisName, Amount] = {}
    for axis in AXES:
        letters = state_arm(axis, term, axes, case)
        if letters is not None:
            number = measure(term.vector[PLACES[axis]] * letters.sign, "m")
            components[axis] = Amount(letters.size, number, letters.sign)
    return components
