"""Two points of a body that move on circles about one fixed centre: with it they are the corners of
a rigid triangle, which turns about the centre.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import assert_never

from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.rates import make_turning
from kinegrade.mechanics.vector_equation import Part, VectorEquation
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block
from kinegrade.worked.formulas.atoms import TWO, ZERO
from kinegrade.worked.formulas.equation import Equation, equate, lead_to
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double, length
from kinegrade.worked.formulas.numbers import measure, state_number
from kinegrade.worked.vectors.arms import introduce_lengths, name_length
from kinegrade.worked.vectors.known_vectors import find_stated_sense
from kinegrade.worked.vectors.results import state_rotation_result, state_vector_value
from kinegrade.worked.vectors.stage import Stage, measure_along_direction
from kinegrade.worked.vectors.vectors import UNITS, name_part, name_point_vector, name_value


@dataclass(frozen=True)
class RigidTriangle:
    """The centre, the point whose motion is known and the one whose motion is sought, each by the
    part of its motion along its circle.
    """

    equation: VectorEquation
    body: str
    known: Part
    sought: Part

    @property
    def centre(self) -> str:
        """The fixed centre about which the body turns."""
        return self.known.base


def find_rigid_triangle(stage: Stage) -> RigidTriangle | None:
    """The triangle of a step of one vector equation; None for any other step, and where a method is
    asked for.
    """
    if len(stage.equations) != 1 or stage.case.method is not None:
        return None
    (equation,) = stage.equations
    moved = [part for part in equation.parts if part.part != "n"]
    circling = [part for part in moved if _circles(part)]
    turning = [part for part in moved if part.role == "rotation"]
    known = [part for part in circling if part.unknown is None]
    if len(moved) != 3 or len(circling) != 2 or len(known) != 1 or len(turning) != 1:
        return None
    (sought,) = (part for part in circling if part.unknown)
    if sought.base != known[0].base or turning[0].term is None:
        return None
    return RigidTriangle(equation, turning[0].term.rate.body, known[0], sought)


def _circles(part: Part) -> bool:
    """Whether a part is the motion of a point along a fixed circle."""
    return part.term is not None and part.term.kind == "arc" and part.term.frame == GROUND


def explain_rigid_triangle(triangle: RigidTriangle, stage: Stage) -> Iterator[Block]:
    """The rotation of the body, and the motion of the second point; why it turns about the centre
    is the idea of the solution.
    """
    ends = ((part.base, part.point) for part in (triangle.known, triangle.sought))
    arms = introduce_lengths(ends, stage.case)
    rotation = _state_rotation(triangle, stage)
    yield stage.case.show(*arms, rotation, *_state_motion(triangle, stage))


def explain_choice(triangle: RigidTriangle, case: Case) -> Message:
    """Why the body turns about the centre."""
    points = (triangle.centre, triangle.known.point, triangle.sought.point)
    centre, first, second = map(case.naming.point, points)
    body = case.naming.body(triangle.body)
    return Message("solution.rigid-triangle", body=body, centre=centre, first=first, second=second)


def name_triangle(triangle: RigidTriangle, case: Case) -> Message:
    """The title of the step."""
    body, centre = case.naming.body(triangle.body), case.naming.point(triangle.centre)
    return Message("solution.title-rigid", body=body, centre=centre)


def _state_rotation(triangle: RigidTriangle, stage: Stage) -> Equation:
    """The speed of the first point, or its tangential acceleration, over its distance from the
    centre.
    """
    case, part = stage.case, triangle.known
    rate = make_turning(triangle.body)
    value = double(case.rates(stage.level)[rate])
    if not value or part.term is None:
        return state_rotation_result(rate, case, stage.level)
    sign = 1 if value > 0 else -1
    arm = _measure_arm(part, case)
    size = measure(length(part.value, case.arithmetic), UNITS[stage.level, False])
    symbols = name_value(triangle.equation, part, case) / _name_arm(part, case)
    how = equate(symbols.signed(sign), (size / arm).signed(sign))
    return state_rotation_result(rate, case, stage.level, how)


def _state_motion(triangle: RigidTriangle, stage: Stage) -> Iterator[Equation]:
    """The motion of the second point along its circle, and the normal accelerations of both: from
    one of them to the other the solution is checked.
    """
    case, part = stage.case, triangle.sought
    if part.term is None:
        return
    arm = _measure_arm(part, case)
    match stage.level:
        case "velocity":
            pass
        case "acceleration":
            for one in (triangle.known, part):
                yield _state_normal(triangle, one, case)
        case _:
            assert_never(stage.level)
    rate = case.rates(stage.level)[make_turning(triangle.body)]
    turned = case.naming.turning(triangle.body, stage.level)
    sign, unit = find_stated_sense(part.term, case, stage.level), UNITS[stage.level, False]
    symbols = _name_arm(part, case).dot(turned).signed(sign)
    numbers = arm.dot(measure(rate, UNITS[stage.level, True])) if double(rate) else ZERO
    links = state_number(measure_along_direction(part.term, case, stage.level) * sign, unit)
    left = name_part(triangle.equation, part, case)
    way = state_vector_value(left, part, case, stage.level).aside
    yield Equation(left, lead_to(left, (symbols, numbers.signed(sign)), links), way)


def _state_normal(triangle: RigidTriangle, part: Part, case: Case) -> Equation:
    """The square of the speed over the radius, towards the centre."""
    normal = next(
        one for one in triangle.equation.parts if one.point == part.point and one.part == "n"
    )
    speed = name_point_vector(part.point, "velocity", case)
    number = measure(abs(_measure_speed(part, case)), "m/s")
    arm = _measure_arm(part, case)
    symbols = speed**TWO / _name_arm(part, case)
    size = state_number(length(normal.value, case.arithmetic), "m/s^2")
    left = name_part(triangle.equation, normal, case)
    return Equation(left, (*equate(symbols, number**TWO / arm), *size))


def _measure_speed(part: Part, case: Case) -> float:
    """The speed of a point along its circle, m/s."""
    if part.term is None:
        return 0.0
    return double(measure_along_direction(part.term, case, "velocity"))


def _measure_arm(part: Part, case: Case) -> Formula:
    """The radius of a point's circle, in metres."""
    return measure(length(part.term.vector, case.arithmetic), "m") if part.term else ZERO


def _name_arm(part: Part, case: Case) -> Formula:
    """The radius of a point's circle."""
    return name_length(part.base, part.point, case)
