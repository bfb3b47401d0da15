"""The velocity of a point by the instantaneous centre of its body."""

from __future__ import annotations

from collections.abc import Iterator
from typing import assert_never

from kinegrade.language.math.tree import Row
from kinegrade.language.message import Message
from kinegrade.mechanics.rates import make_turning
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Part
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block
from kinegrade.worked.formulas.atoms import ZERO
from kinegrade.worked.formulas.equation import Equation, Link, equate
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double, length, size
from kinegrade.worked.formulas.numbers import measure, state_number
from kinegrade.worked.senses import state_way_about
from kinegrade.worked.steps.couplers import Coupler, explain_base_speed
from kinegrade.worked.steps.poles.pole_distances import PoleTriangle
from kinegrade.worked.steps.poles.poles import name_pole
from kinegrade.worked.vectors.arms import introduce_lengths, name_length
from kinegrade.worked.vectors.projection import PARALLEL
from kinegrade.worked.vectors.results import state_rotation_result, state_sense
from kinegrade.worked.vectors.vectors import name_part, name_point_vector, name_value


def explain_by_pole(coupler: Coupler, case: Case) -> Iterator[Block]:
    """The pole by its construction, the rotation about it, and the speed of the second point."""
    body = coupler.body
    name = name_pole(body, case)
    yield case.say(_describe_construction(coupler, case.naming.point(name), case))
    if case.arithmetic.is_zero(case.motion.omega(body)):
        yield from explain_base_speed(coupler, case)
        yield from _introduce_arm(coupler.point, case)
        known = name_value(coupler.equation, coupler.base, case)
        still = Equation(case.naming.omega(body), equate(ZERO))
        yield case.show(still, *_state_found_speed(coupler, equate(known), case))
        return
    case.findings.poles[body] = name
    triangle = PoleTriangle(
        coupler, case.naming.letter(name), case.motion.pole(body, case.arithmetic), case
    )
    yield from triangle.explain_distances()
    if body in case.findings.poles_sought:
        yield from triangle.explain_coordinates()
    if not case.findings.places_alone:
        yield from explain_base_speed(coupler, case)
        yield from _introduce_arm(coupler.point, case)
        yield case.show(*_state_rotation(coupler, triangle, case))


def _introduce_arm(sought: Part, case: Case) -> Iterator[Block]:
    """The distance of the second point from the fixed axis about which it turns."""
    if sought.term is not None and sought.term.kind == "rotation":
        yield from map(case.show, introduce_lengths(((sought.base, sought.point),), case))


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


def _state_rotation(coupler: Coupler, triangle: PoleTriangle, case: Case) -> Iterator[Equation]:
    """The rotation about the pole, and the velocity of the second point that follows from it."""
    omega, rate = case.naming.omega(coupler.body), case.motion.omega(coupler.body)
    sign = 1 if double(rate) > 0 else -1
    speed = name_value(coupler.equation, coupler.base, case)
    value = measure(length(coupler.base.value, case.arithmetic), "m/s")
    ratios = (
        (above / below).signed(sign)
        for above, below in (
            (speed, triangle.name_distance(coupler.base)),
            (value, triangle.measure_distance(coupler.base)),
        )
    )
    yield state_rotation_result(make_turning(coupler.body), case, "velocity", equate(*ratios))
    case.findings.sized.add(name_point_vector(coupler.point.point, "velocity", case))
    size = omega if sign > 0 else abs(omega)
    how = equate(
        triangle.name_distance(coupler.point).dot(size),
        triangle.measure_distance(coupler.point).dot(measure(abs(rate), "rad/s")),
    )
    yield from _state_found_speed(coupler, how, case)


def _state_found_speed(coupler: Coupler, how: tuple[Link, ...], case: Case) -> Iterator[Equation]:
    """The magnitude and direction of the second point's velocity, and the body's rotation."""
    sought, term = coupler.point, coupler.point.term
    if term is None or sought.coefficient is None:
        return
    negative = double(sought.value.dot(sought.coefficient)) < 0
    letters = name_part(coupler.equation, sought, case)
    speed: Formula = abs(letters) if negative else letters
    links = (*how, *state_number(length(sought.value, case.arithmetic), "m/s"))
    yield Equation(speed, links, _state_way_of(sought, term, case))
    if term.kind == "rotation":
        arm = length(term.vector, case.arithmetic)
        sides = (
            speed / name_length(sought.base, sought.point, case),
            measure(length(sought.value, case.arithmetic), "m/s") / measure(arm, "m"),
        )
        signed = equate(*(side.signed(-1 if negative else 1) for side in sides))
        yield state_rotation_result(term.rate, case, "velocity", signed)


def _state_way_of(sought: Part, term: Term, case: Case) -> Row:
    """The direction of the second point's velocity; on a circle, the sense about its centre."""
    match term.kind:
        case "rotation":
            arm = case.motion.points[sought.point] - case.motion.points[sought.base]
            return state_way_about(sought.value, arm, sought.base, case)
        case "sliding" | "arc":
            positive = sought.coefficient or sought.value
            return state_sense(double(sought.value.dot(positive)), positive, sought, case)
        case _:
            assert_never(term.kind)
