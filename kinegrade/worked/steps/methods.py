"""Velocities of two points of a body by the projection theorem, by the instantaneous centre, or
by a rigid triangle.

Where neither applies (a body that turns about no known point, a composition of motions), nothing is
given, and the step is written with a base point.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal, TypeAlias, assert_never

from kinegrade.language.message import Message
from kinegrade.mechanics.plan import Step
from kinegrade.problem.template.template import Method
from kinegrade.worked.deductions.deductions import (
    explain_deduction,
    introduce_angles,
    show_solution,
)
from kinegrade.worked.deductions.projected_angles import explain_angles
from kinegrade.worked.document import Block
from kinegrade.worked.steps.couplers import Coupler, choose_method, explain_base_speed, find_coupler
from kinegrade.worked.steps.poles.pole_method import explain_by_pole
from kinegrade.worked.steps.remarks import explain_remarks
from kinegrade.worked.steps.rigid import explain_rigid_triangle, find_rigid_triangle
from kinegrade.worked.steps.steps import introduce_with_lengths
from kinegrade.worked.steps.term_tables import make_term_table
from kinegrade.worked.vectors.projection import Deduction, find_deductions
from kinegrade.worked.vectors.stage import Stage

Way: TypeAlias = Method | Literal["rigid-triangle"]


def find_way(step: Step, stage: Stage) -> Way | None:
    """By which way the velocities of a step are found; None where no two points of a body are
    compared.
    """
    if find_rigid_triangle(stage) is not None:
        return "rigid-triangle"
    coupler = find_coupler(stage)
    if coupler is None:
        return None
    method = choose_method(coupler, stage.case)
    without = method == "projection" and _find_theorem(coupler, step, stage) is None
    return "base-point" if without else method


def explain_by_method(step: Step, stage: Stage) -> Iterator[Block]:
    """The step by the method chosen, or nothing where a base point is to be used."""
    triangle = find_rigid_triangle(stage)
    if triangle is not None:
        yield from explain_rigid_triangle(triangle, stage)
        return
    coupler = find_coupler(stage)
    if coupler is None:
        return
    method = choose_method(coupler, stage.case)
    match method:
        case "projection":
            yield from _explain_by_projection(coupler, step, stage)
        case "pole":
            yield from explain_by_pole(coupler, stage.case)
        case "base-point":
            return
        case _:
            assert_never(method)


def _find_theorem(coupler: Coupler, step: Step, stage: Stage) -> tuple[Deduction, Deduction] | None:
    """The projection on the line of the two points, which gives the speed, and what then gives the
    rotation; None where the line is normal to a velocity.
    """
    first, second = find_deductions(stage.equations, (), step.unknowns)
    if first.projections[0].dropped != coupler.rotation:
        first, second = second, first
    projection = first.projections[0]
    told = projection.dropped == coupler.rotation and projection.left
    return (first, second) if told else None


def _explain_by_projection(coupler: Coupler, step: Step, stage: Stage) -> Iterator[Block]:
    """The projection theorem for the point's speed, then the base point for the rotation."""
    case, theorem = stage.case, _find_theorem(coupler, step, stage)
    if theorem is None:
        return
    first, second = theorem
    base, point = case.naming.point(coupler.base.point), case.naming.point(coupler.point.point)
    body = case.naming.body(coupler.body)
    yield from explain_base_speed(coupler, case)
    yield case.say(Message("solution.equal-projections", body=body, first=base, second=point))
    yield from introduce_angles(stage, first.projections[0])
    yield from map(case.say, explain_angles(stage, first.projections[0]))
    yield show_solution(stage, first.projections[0], (), first.unknowns[0])
    yield case.say(introduce_with_lengths(coupler.equation, stage))
    yield make_term_table(coupler.equation, case)
    yield from explain_remarks(coupler.equation, case)
    yield from explain_deduction(stage, second, set(first.unknowns))
