"""Velocities of two points of a body by the projection theorem, or by the instantaneous centre.

Where neither applies (a body that turns about no known point, a composition of motions), nothing is
given, and the step is written with a base point.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import assert_never

from kinegrade.expressions.expression import Name
from kinegrade.language.message import Message
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.rates import make_turning
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Part, VectorEquation, is_whole
from kinegrade.problem.quantities.functions import find_motion_calls
from kinegrade.problem.template.template import Method
from kinegrade.worked.document import Block, Display
from kinegrade.worked.formulas.numbers import (
    double,
    length,
    size,
    write_absolute_value,
    write_number,
    write_short,
)
from kinegrade.worked.steps.deductions import (
    Stage,
    explain_deduction,
    write_rotation_result,
    write_solution,
)
from kinegrade.worked.steps.findings import Findings, write_point_symbol
from kinegrade.worked.steps.known_vectors import is_stated_negative
from kinegrade.worked.steps.points import write_way
from kinegrade.worked.steps.poles import name_pole
from kinegrade.worked.steps.projection import PARALLEL, find_deductions
from kinegrade.worked.steps.steps import explain_remarks, make_term_table
from kinegrade.worked.steps.titles import introduce_equation
from kinegrade.worked.steps.vectors import (
    find_arm,
    vanishes,
    write_letters,
    write_magnitude_formula,
    write_symbol,
)
from kinegrade.worked.words.solution_case import Case


@dataclass(frozen=True)
class Coupler:
    """Two points of one body: the velocity of `base` is known, the direction of that of `point`."""

    equation: VectorEquation
    base: Part
    point: Part
    rotation: Part

    @property
    def body(self) -> str:
        """The body that carries both points."""
        return self.rotation.unknown.body if self.rotation.unknown else ""


def explain_by_method(step: Step, stage: Stage, findings: Findings) -> Iterator[Block]:
    """The step by the method chosen, or nothing where a base point is to be used."""
    coupler = find_coupler(stage)
    if coupler is None:
        return
    method = choose_method(coupler, stage.case)
    if method == "projection":
        yield from _explain_by_projection(coupler, step, stage)
    elif method == "pole":
        yield from _explain_by_pole(coupler, stage, findings)


def name_method(stage: Stage) -> Message | None:
    """The title of a step by another method than the base point's, else None."""
    coupler = find_coupler(stage)
    return _name_method_for(coupler, stage.case) if coupler else None


def _name_method_for(coupler: Coupler, case: Case) -> Message | None:
    body, method = case.naming.body(coupler.body), choose_method(coupler, case)
    match method:
        case "base-point":
            return None
        case "projection":
            return Message("solution.title-projection", body=body)
        case "pole":
            return Message("solution.title-pole", body=body)
        case _:
            assert_never(method)


def choose_method(coupler: Coupler, case: Case) -> Method:
    """The method asked for; else the pole where an answer is about it, or where the body does not
    turn.
    """
    if case.method is not None:
        return case.method
    asked = {
        call.arguments[0].name
        for name in case.solution.answers
        for call in find_motion_calls(case.template.asks[name].quantity)
        if call.function == "pole" and isinstance(call.arguments[0], Name)
    }
    still = case.arithmetic.is_zero(case.motion.omega(coupler.body))
    return "pole" if coupler.body in asked or still else "base-point"


def find_coupler(stage: Stage) -> Coupler | None:
    """The two points of a step of one velocity equation v_B = v_A + v_BA; None for any other
    step.
    """
    if stage.level != "velocity" or len(stage.equations) != 1:
        return None
    equation = stage.equations[0]
    whole, other = equation.left, equation.right
    if not (
        is_whole(whole) and len(whole) == 1 and len(other) == 2 and other[1].role == "rotation"
    ):
        return None
    if whole[0].unknown is None:  # v_B known, v_A sought: A and B change places
        known, sought = whole[0], other[0]
    else:
        known, sought = other[0], whole[0]
    if (
        known.unknown
        or not sought.unknown
        or not other[1].unknown
        or vanishes(known)
        or sought.role != "absolute"
    ):
        return None
    return Coupler(equation, known, sought, other[1])


def _explain_by_projection(coupler: Coupler, step: Step, stage: Stage) -> Iterator[Block]:
    """The projection theorem for the point's speed, then the base point for the rotation."""
    case = stage.case
    first, second = find_deductions(stage.equations, (), step.unknowns)
    if first.projections[0].dropped != coupler.rotation:
        first, second = second, first
    if first.projections[0].dropped != coupler.rotation or not first.projections[0].left:
        return
    projection = first.projections[0]
    base, point = case.naming.point(coupler.base.point), case.naming.point(coupler.point.point)
    yield from _explain_base_speed(coupler, case)
    yield case.say(
        Message(
            "solution.equal-projections",
            body=case.naming.body(coupler.body),
            first=base,
            second=point,
        )
    )
    yield Display(tuple(write_solution(stage, projection, (), first.unknowns[0])))
    yield case.say(introduce_equation(coupler.equation, case))
    yield make_term_table(coupler.equation, case)
    yield from explain_remarks(coupler.equation, case)
    yield from explain_deduction(stage, second, set(first.unknowns))


def _explain_by_pole(coupler: Coupler, stage: Stage, findings: Findings) -> Iterator[Block]:
    """The pole by its construction, the rotation about it, and the speed of the second point."""
    case, body = stage.case, coupler.body
    name = name_pole(body, case)
    letter = case.naming.point(name)
    yield case.say(_describe_construction(coupler, letter, case))
    if case.arithmetic.is_zero(case.motion.omega(body)):
        yield from _explain_base_speed(coupler, case)
        known = write_symbol(coupler.equation, coupler.base, case)
        yield Display(
            (f"{case.naming.omega(body)} &= 0", *_write_found_speed(coupler, known, case))
        )
        return
    pole = case.motion.pole(body, case.arithmetic)
    findings.poles[body] = name
    yield from _explain_base_speed(coupler, case)
    yield Display(tuple(_write_pole_lines(coupler, pole, letter, stage, findings)))


def _explain_base_speed(coupler: Coupler, case: Case) -> Iterator[Block]:
    """The speed of the point whose velocity is known, where it follows from a rotation about a
    fixed axis.
    """
    formula = write_magnitude_formula(coupler.equation, coupler.base, case)
    if (
        formula
        and coupler.base.term
        and not is_stated_negative(coupler.base.term, case, "velocity")
    ):
        value = coupler.base.value
        yield Display(
            (
                f"{write_letters(coupler.equation, coupler.base, case)} &= {formula} = "
                f"{write_number(length(value, case.arithmetic), 'm/s')}{write_way(value, case)}",
            )
        )


def _describe_construction(coupler: Coupler, pole: str, case: Case) -> Message:
    """Where the pole of a body lies, by the construction that applies."""
    body = case.naming.body(coupler.body)
    first, second = map(case.naming.point, (coupler.base.point, coupler.point.point))
    if case.arithmetic.is_zero(case.motion.omega(coupler.body)):
        return Message("solution.pole-at-infinity", body=body, first=first, second=second)
    if _are_parallel(coupler.base.value, coupler.point.coefficient or Vector(0, 0)):
        return Message(
            "solution.pole-by-parallel-velocities", body=body, pole=pole, first=first, second=second
        )
    return Message("solution.pole-by-normals", body=body, pole=pole, first=first, second=second)


def _are_parallel(first: Vector, second: Vector) -> bool:
    return abs(double(first.cross(second))) < PARALLEL * size(first) * size(second)


def _write_pole_lines(
    coupler: Coupler, pole: Vector, letter: str, stage: Stage, findings: Findings
) -> Iterator[str]:
    """The pole, its distances, and the velocities that follow from them."""
    case, points = stage.case, stage.case.motion.points
    base, point = coupler.base.point, coupler.point.point
    yield rf"{letter} &: ({write_number(pole.x, 'm')},\quad {write_number(pole.y, 'm')})"
    arms = {name: length(points[name] - pole, case.arithmetic) for name in (base, point)}
    yield from (
        f"{letter}{case.naming.point(name)} &= {write_number(size_, 'm')}"
        for name, size_ in arms.items()
    )
    speed = write_symbol(coupler.equation, coupler.base, case)
    omega = write_absolute_value(case.naming.omega(coupler.body))
    value = length(coupler.base.value, case.arithmetic)
    yield (
        rf"{omega} &= \frac{{{speed}}}{{{letter}{case.naming.point(base)}}} = "
        rf"\frac{{{write_short(value)}}}{{{write_short(arms[base])}}}"
    )
    yield write_rotation_result(make_turning(coupler.body), case, "velocity", "")
    findings.sized.add(write_point_symbol(point, "velocity", case))
    how = (
        rf"{letter}{case.naming.point(point)}\cdot {omega} = "
        rf"{write_short(arms[point])}\cdot {write_short(abs(case.motion.omega(coupler.body)))}"
    )
    yield from _write_found_speed(coupler, how, case)


def _write_found_speed(coupler: Coupler, how: str, case: Case) -> Iterator[str]:
    """The magnitude and direction of the second point's velocity, and the body's rotation."""
    sought, term = coupler.point, coupler.point.term
    if term is None or sought.coefficient is None:
        return
    negative = double(sought.value.dot(sought.coefficient)) < 0
    letters = write_letters(coupler.equation, sought, case)
    speed = write_absolute_value(letters) if negative else letters
    yield (
        f"{speed} &= {how} = "
        f"{write_number(length(sought.value, case.arithmetic), 'm/s')}"
        f"{write_way(sought.value, case)}"
    )
    if term.kind == "rotation":
        fraction = rf"\frac{{{speed}}}{{{find_arm(sought, case)}}} = "
        yield write_rotation_result(
            term.rate, case, "velocity", f"-{fraction}" if negative else fraction
        )
