"""Checks of vector equations: their projections on axes that have not been used."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from math import cos, radians, sin

from kinegrade.language.message import Message
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.relations import add_vectors
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import VectorEquation
from kinegrade.worked.case import Case
from kinegrade.worked.checks.check import Check, Lacking, Side, compare
from kinegrade.worked.deductions.projected_angles import AXIS_NAMES
from kinegrade.worked.formulas.atoms import AxisName, add_terms
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import bearing, size
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.steps.couplers import Coupler, choose_method, find_coupler
from kinegrade.worked.steps.rigid import find_rigid_triangle
from kinegrade.worked.steps.titles import select_scalars
from kinegrade.worked.vectors.facts import make_key
from kinegrade.worked.vectors.inclinations import Cosine, find_inclination, is_direction_told
from kinegrade.worked.vectors.magnitudes import find_heading
from kinegrade.worked.vectors.projection import Projection, Share, find_deductions
from kinegrade.worked.vectors.stage import Stage, find_share_cosine
from kinegrade.worked.vectors.summands import PLACES
from kinegrade.worked.vectors.vectors import UNITS, name_part, vanishes

_SAME = 1e-6  # degrees within which two axes are one
_AXES: dict[float, AxisName] = {0.0: "x", 90.0: "y"}


def list_theorem_checks(step: Step, stage: Stage) -> Iterator[Check]:
    """The checks of a step by the projection theorem where a pole has given the velocities."""
    coupler = find_coupler(stage)
    if coupler is not None and choose_method(coupler, stage.case) == "pole":
        yield from _check_by_theorem(coupler, step, stage)


def list_projection_checks(step: Step, stage: Stage) -> Iterator[Check]:
    """The checks of a step by axes that its deductions have not used and whose angles have been
    worked out; none where no deduction is told.
    """
    coupler, case = find_coupler(stage), stage.case
    if coupler is not None and choose_method(coupler, case) == "pole":
        return
    if find_rigid_triangle(stage) is not None:
        return
    deductions = tuple(find_deductions(stage.equations, select_scalars(step, case), step.unknowns))
    projections = [one for deduction in deductions for one in deduction.projections]
    by_theorem = coupler is not None and choose_method(coupler, case) == "projection"
    lacking = tuple(
        Lacking(stage, one, frozenset(step.unknowns) - {*one.unknowns})
        for one in deductions
        if stage.spares(one) and not by_theorem
    )
    printed = _list_angles(projections, stage)
    for equation in reversed(stage.equations):
        used = [one.axis for one in projections if one.equation == equation]
        for projection, axis in _list_axes(equation, case):
            if _is_among(projection.axis, used) or _list_sums(projection, stage) - printed:
                continue
            way = _name_way(equation, axis, stage)
            for check in _check_on(projection, way, step, stage):
                yield replace(check, lacking=_select_lacking(lacking, projection))


def _select_lacking(lacking: Iterable[Lacking], projection: Projection) -> tuple[Lacking, ...]:
    """Those that a projection involves."""
    left = {share.part.unknown for share in projection.shares}
    return tuple(one for one in lacking if left.intersection(one.deduction.unknowns))


def _name_way(equation: VectorEquation, axis: Message, stage: Stage) -> Message:
    """By which projection, and of which equation where a step has several."""
    if len(stage.equations) == 1:
        return Message("solution.check-projection", axis=axis)
    point = stage.case.naming.point(equation.parts[0].point)
    return Message("solution.equation-projected", point=point, axis=axis)


def _check_by_theorem(coupler: Coupler, step: Step, stage: Stage) -> Iterator[Check]:
    """The velocities of two points projected on their line."""
    heading = bearing(find_heading(coupler.rotation))
    projection = Projection(coupler.equation, (heading + 90) % 360, coupler.rotation)
    first, second = map(stage.case.naming.point, (coupler.rotation.base, coupler.rotation.point))
    way = Message("solution.check-theorem", first=first, second=second)
    yield from _check_on(projection, way, step, stage)


def _list_axes(equation: VectorEquation, case: Case) -> list[tuple[Projection, Message]]:
    """The projections on the axes, then on the directions of the vectors, with their names; those
    first that leave vectors on both sides.
    """
    named = _name_axes(equation, case)
    return sorted(named, key=lambda one: not (one[0].left and one[0].right))


def _name_axes(equation: VectorEquation, case: Case) -> Iterator[tuple[Projection, Message]]:
    for axis, name in AXIS_NAMES.items():
        yield Projection(equation, axis, None), name
    for part in equation.parts:
        if not vanishes(part):
            vector = case.text(name_part(equation, part, case, bold=True))
            along = Message("solution.projection-of", vector=vector)
            yield Projection(equation, bearing(find_heading(part)), None), along


def _list_angles(projections: Iterable[Projection], stage: Stage) -> frozenset[float]:
    """The angles in the cosines of projections, in degrees."""
    cosines = (one for projection in projections for one in _list_cosines(projection, stage))
    return frozenset(one.value for one in cosines)


def _list_cosines(projection: Projection, stage: Stage) -> Iterator[Cosine]:
    """The cosines of a projection."""
    named = (find_share_cosine(projection, share, stage.case) for share in projection.shares)
    return filter(None, named)


def _list_sums(projection: Projection, stage: Stage) -> frozenset[float]:
    """The angles in the cosines of a projection that are sums of others: these have been worked
    out only where a projection has used them.
    """
    headings = (find_inclination(share.part, stage.case) for share in projection.shares)
    named = {one.value for one in headings if one is not None and not _is_sum(one.angle)}
    return _list_angles((projection,), stage) - named


def _is_sum(angle: Formula | None) -> bool:
    return angle is not None and angle.kind == "sum"


def _is_among(axis: float, used: Sequence[float]) -> bool:
    return any(abs((axis - other + 90) % 180 - 90) < _SAME for other in used)


def _check_on(projection: Projection, way: Message, step: Step, stage: Stage) -> Iterator[Check]:
    """The check by a projection in which two parts or more are left, all by what the solution has
    found, with the sides of the equation.
    """
    shares = projection.shares
    told = all(_can_be_told(projection, share, stage) for share in shares)
    if len(shares) < 2 or not told or _is_left_out(shares, step, stage):
        return
    left, right = (
        _work_out_side(projection, side, step, stage)
        for side in (projection.left, projection.right)
    )
    largest = max(size(share.part.value) for share in shares)
    yield compare(way, left, right, UNITS[stage.level, False], largest)


def _is_left_out(shares: Sequence[Share], step: Step, stage: Stage) -> bool:
    """Whether a share is that of an unknown which stands with others and that nothing needs."""
    deductions = find_deductions(stage.equations, select_scalars(step, stage.case), step.unknowns)
    together = {rate for one in deductions if len(one.unknowns) > 1 for rate in one.unknowns}
    left = {share.part.unknown for share in shares} & together
    return any(rate and stage.case.findings.spares(rate, stage.level) for rate in left)


def _can_be_told(projection: Projection, share: Share, stage: Stage) -> bool:
    """Whether the solution has found a share: its angle, or a component along an axis."""
    along_axis = not share.angle and projection.axis in _AXES
    if along_axis or _find_component(projection, share, stage) is not None:
        return True
    named = not share.angle or find_share_cosine(projection, share, stage.case) is not None
    return named and is_direction_told(share.part, stage.case)


def _find_component(projection: Projection, share: Share, stage: Stage) -> Formula | None:
    """The component of a vector that is known by its components; None for any other."""
    together = share.part.together
    fact = stage.case.findings.facts.get(make_key(together, stage.level)) if together else None
    axis = _AXES.get(projection.axis)
    if fact is None or not fact.by_components or axis is None:
        return None
    return measure(share.part.value[PLACES[axis]], UNITS[stage.level, False])


def _work_out_side(
    projection: Projection, shares: Sequence[Share], step: Step, stage: Stage
) -> Side:
    """A side in numbers, and what it amounts to."""
    terms = (term for share in shares for term in _state_share(projection, share, step, stage))
    total = add_vectors(share.part.value for share in shares)
    exact = total if projection.axis in _AXES else total.map(float)
    value = exact.dot(_find_unit(projection.axis)) if shares else 0
    return Side(add_terms(terms), value)


def _state_share(
    projection: Projection, share: Share, step: Step, stage: Stage
) -> Iterable[Formula]:
    """A share in numbers: by its component where that has been found, else by its magnitude."""
    component = _find_component(projection, share, stage)
    if component is not None:
        return (component,)
    return stage.list_terms(projection, (share,), 1, step.unknowns)


def _find_unit(axis: float) -> Vector:
    """The direction of an axis: exact along x and y."""
    units = {0.0: Vector(1, 0), 90.0: Vector(0, 1)}
    return units.get(axis) or Vector(cos(radians(axis)), sin(radians(axis)))
