"""The vectors from point to point by the differences of their coordinates, and the normals to the
straight paths of points in bodies that turn.
"""

from __future__ import annotations

from dataclasses import replace

from kinegrade.mechanics.rates import make_turning
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector import AxisName, Vector
from kinegrade.worked.case import Case
from kinegrade.worked.checks.amounts import Amount, Multiplier, Pair, point_along
from kinegrade.worked.formulas.atoms import AXES
from kinegrade.worked.formulas.measures import double, length
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.positions.axes import choose_axes
from kinegrade.worked.vectors.arms import find_stated_length, name_length
from kinegrade.worked.vectors.components import state_arm
from kinegrade.worked.vectors.summands import PLACES
from kinegrade.worked.vectors.table.tracks import find_track_ends


def point_from(base: str, point: str, case: Case) -> Multiplier:
    """The vector from one point to another, with its length where that has been found or given."""
    vector = case.motion.points[point] - case.motion.points[base]
    found = point_from_base(Term("rotation", make_turning(""), vector, point, base), case)
    known = frozenset((base, point)) in case.findings.arms or find_stated_length(base, point, case)
    return found if known else replace(found, length=None)


def _find_normal_from(base: str, direction: Vector, case: Case) -> Multiplier | None:
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


def find_path_normal(
    turn: Term, slide: Term, case: Case
) -> tuple[Multiplier | None, tuple[str, str] | None]:
    """A normal to the line along which a point slides, None where no two points give one, and two
    points of the line whose distance it has and that have to be told.
    """
    for axis in map(point_along, AXES):
        if not double(axis.vector.dot(slide.vector)):
            return axis, None
    if not double(turn.vector.dot(slide.vector)):
        return point_from_base(turn, case), None
    normal = _find_normal_from(turn.base, slide.vector, case)
    ends = find_track_ends(slide, case)
    if normal is not None or ends is None:
        return normal, None
    start, end = (case.motion.points[point] for point in ends)
    along = Term("rotation", turn.rate, end - start, ends[1], ends[0])
    return point_from_base(along, case).turned(), ends
