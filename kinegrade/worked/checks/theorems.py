"""The check of a rod whose pole has given its velocities: the projection theorem."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from math import cos, radians, sin

from kinegrade.language.message import Message
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.vector import AxisName, Vector, add_vectors
from kinegrade.worked.checks.amounts import Amount
from kinegrade.worked.checks.check import Check, compare
from kinegrade.worked.checks.forms import multiply_relation
from kinegrade.worked.checks.sides import Side
from kinegrade.worked.formulas.atoms import add_terms
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import bearing, size
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.steps.couplers import Coupler, choose_method, find_coupler
from kinegrade.worked.vectors.facts import make_key
from kinegrade.worked.vectors.projection import Projection, Share
from kinegrade.worked.vectors.slopes.derived_angles import is_line_found
from kinegrade.worked.vectors.slopes.directions import is_direction_told
from kinegrade.worked.vectors.stage import Stage, find_share_cosine
from kinegrade.worked.vectors.summands import PLACES, name_component
from kinegrade.worked.vectors.table.tracks import find_heading
from kinegrade.worked.vectors.vectors import UNITS

_AXES: Mapping[float, AxisName] = {0.0: "x", 90.0: "y"}


def list_theorem_checks(step: Step, stage: Stage) -> Iterator[Check]:
    """The checks of a step by the projection theorem where a pole has given the velocities."""
    coupler = find_coupler(stage)
    if coupler is not None and choose_method(coupler, stage.case) == "pole":
        yield from _check_by_theorem(coupler, step, stage)


def _check_by_theorem(coupler: Coupler, step: Step, stage: Stage) -> Iterator[Check]:
    """The velocities of two points projected on their line."""
    heading = bearing(find_heading(coupler.rotation))
    projection = Projection(coupler.equation, (heading + 90) % 360, coupler.rotation)
    first, second = map(stage.case.naming.point, (coupler.rotation.base, coupler.rotation.point))
    way = Message("solution.check-theorem", first=first, second=second)
    yield from _check_on(projection, way, step, stage)


def _check_on(projection: Projection, way: Message, step: Step, stage: Stage) -> Iterator[Check]:
    """The check by a projection in which two parts or more are left, all by what the solution has
    found, with the sides of the equation.
    """
    shares = projection.shares
    told = all(_can_be_told(projection, share, stage) for share in shares)
    if len(shares) < 2 or not told:
        return
    left, right = (
        _work_out_side(projection, side, step, stage)
        for side in (projection.left, projection.right)
    )
    largest = max(size(share.part.value) for share in shares)
    form = multiply_relation(projection.equation.relation, projection.direction)
    yield compare(way, left, right, UNITS[stage.level, False], form=form, largest=largest)


def _can_be_told(projection: Projection, share: Share, stage: Stage) -> bool:
    """Whether the solution has found a share: its angle, or a component along an axis."""
    along_axis = not share.angle and projection.axis in _AXES
    if along_axis or _find_component(projection, share, stage) is not None:
        return True
    cosine = find_share_cosine(projection, share, stage.case) if share.angle else None
    found = cosine is not None and is_line_found(cosine.value, stage.case)
    return (found or not share.angle) and is_direction_told(share.part, stage.case)


def _find_component(projection: Projection, share: Share, stage: Stage) -> Amount | None:
    """The component of a vector that is known by its components; None for any other."""
    together = share.part.together
    fact = stage.case.findings.facts.get(make_key(together, stage.level)) if together else None
    axis = _AXES.get(projection.axis)
    if fact is None or not fact.by_components or axis is None:
        return None
    number = measure(share.part.value[PLACES[axis]], UNITS[stage.level, False])
    return Amount(name_component(fact.symbol, axis), number)


def _work_out_side(
    projection: Projection, shares: Sequence[Share], step: Step, stage: Stage
) -> Side:
    """A side in letters and in numbers, and what it amounts to."""
    letters, numbers = (
        add_terms(
            term for share in shares for term in _state_share(projection, share, solved, stage)
        )
        for solved in (None, step.unknowns)
    )
    total = add_vectors(share.part.value for share in shares)
    exact = total if projection.axis in _AXES else total.map(float)
    value = exact.dot(_find_unit(projection.axis)) if shares else 0
    return Side(numbers, value, letters if shares else None)


def _state_share(
    projection: Projection, share: Share, solved: Collection[Rate] | None, stage: Stage
) -> Iterable[Formula]:
    """A share by its component where that has been found, else by its magnitude: in numbers, in
    letters where nothing counts as solved.
    """
    component = _find_component(projection, share, stage)
    if component is not None:
        return (component.letters if solved is None else component.numbers,)
    return stage.list_terms(projection, (share,), 1, solved)


def _find_unit(axis: float) -> Vector:
    """The direction of an axis: exact along x and y."""
    units = {0.0: Vector(1, 0), 90.0: Vector(0, 1)}
    return units.get(axis) or Vector(cos(radians(axis)), sin(radians(axis)))
